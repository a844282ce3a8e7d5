#include "diagnose/api/report.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "diagnose/api/study_files.hpp"

namespace plumbline::diagnose {
namespace {

const std::filesystem::path root = PLUMBLINE_SOURCE_DIR;
const std::filesystem::path chain = root / "docs/examples/experiment",
                            joint = root / "docs/examples/joint-loop";

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A copy of the chain's experiment with a factor on every force that was read.
std::filesystem::path with_forces_times(double factor, const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::copy(chain, folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    std::istringstream lines(text_of(entry.path()));
    std::ofstream out(entry.path());
    std::string line, field;
    std::size_t force = 0;
    for (bool header = true; std::getline(lines, line); header = false) {
      std::istringstream fields(line);
      for (std::size_t column = 0; std::getline(fields, field, ','); ++column) {
        if (header && field == "Fx") force = column;
        out << (column ? "," : "");
        if (!header && column == force && !field.empty())
          out << factor * std::stod(field);
        else
          out << field;
      }
      out << "\n";
    }
  }
  return folder;
}

TEST_CASE("the answer of a report is one answer, in words, in JSON and as an object") {
  const Report report(study_of(experiment_of({joint, {}, {}})));
  const nlohmann::ordered_json json = report.json();
  REQUIRE(report.diagnosis().gap.present);
  CHECK(json["gap"]["present"] == true);
  const RankedCause& best = report.diagnosis().cause.ranking.front();
  CHECK(json["cause"]["ranking"][0]["probability"] == best.probability);
  CHECK(report.text().find(best.cause.name()) != std::string::npos);
  CHECK(report.html().find("<!") == 0);
}

TEST_CASE("without a folder the bundled example is read") {
  const Experiment bundled = experiment_of({}), in_folder = experiment_of({chain, {}, {}});
  REQUIRE(bundled.runs.size() == in_folder.runs.size());
  for (std::size_t run = 0; run < bundled.runs.size(); ++run)
    CHECK(bundled.runs[run].readings.size() == in_folder.runs[run].readings.size());
}

TEST_CASE("the corrected model is the nominal model of a diagnosis that finds no gap") {
  const auto folder = std::filesystem::temp_directory_path() / "plumbline-api-corrected";
  std::filesystem::create_directories(folder);
  const Report report(study_of(experiment_of({joint, {}, {}})));
  const std::vector<exchange::Corrected> models = report.corrected();
  REQUIRE_FALSE(models.empty());
  const std::filesystem::path file = folder / "corrected.toml";
  std::ofstream(file) << exchange::written(models.front().model, exchange::Format::toml).text;
  CHECK_FALSE(Report(study_of(experiment_of({joint, file, {}}))).diagnosis().gap.present);
  std::filesystem::remove_all(folder);
}

TEST_CASE("numbers that look like another unit are asked about, unless they are to be taken as they are") {
  const auto folder =
      with_forces_times(1000, std::filesystem::temp_directory_path() / "plumbline-api-millinewtons");
  const Study study = study_of(experiment_of({folder, {}, {}}));
  CHECK_THROWS_AS(Report{study}, Error);
  struct Begun {};
  CHECK_THROWS_AS(Report(study, {true, false, [](double) { throw Begun(); }}), Begun);
  std::filesystem::remove_all(folder);
}

TEST_CASE("progress grows to the whole, and an exception of its listener ends the work") {
  const Study study = study_of(experiment_of({joint, {}, {}}));
  double last = 0;
  const Report report(study, {false, false, [&](double share) {
                                CHECK(share >= last);
                                last = share;
                              }});
  CHECK(last > 0.5);
  CHECK(last <= 1);
  struct Enough {};
  CHECK_THROWS_AS(Report(study, {false, false, [](double) { throw Enough(); }}), Enough);
}

TEST_CASE("a folder that is none is one line") {
  try {
    (void)experiment_of({root / "no such folder", {}, {}});
    FAIL("read");
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find("no such folder") != std::string::npos);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace plumbline::diagnose
