/// docs/arms.md against the catalogue of arms in code, both ways: ids, words, parameters and units.
#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "support/files/text_file.hpp"
#include "tests/diagnose/arms.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

struct DocumentedRow {
  std::string id, words, parameters;
  bool at_joint;
};

std::string document() {
  return files::read_text(PLUMBLINE_SOURCE_DIR "/docs/arms.md");
}

std::vector<DocumentedRow> documented_rows() {
  static const std::regex row(R"(\| `(\w+)(\(j\))?` \| ([^`|]+) \| ([^|]+) \|)");
  std::vector<DocumentedRow> rows;
  std::istringstream lines(document());
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, row)) rows.push_back({found[1], found[3], found[4], found[2].matched});
  return rows;
}

/// "a_2" is "a_j" in the document: one a joint.
std::string as_documented(const std::string& name) {
  return std::regex_replace(name, std::regex(R"(_\d+$)"), "_j");
}

/// An arm whose readings show every effect.
Study study_of_all() {
  Experiment experiment = arm_bench(industrial_arm(), 16, {true, true, true});
  experiment.covariates = {"temperature"};
  double kelvin = 290;
  for (Run& run : experiment.runs) {
    run.by_weights = false;
    for (Reading& reading : run.readings) {
      reading.wrench = {12, -7, -30, 0.4, 0.3, -0.5};
      reading.covariates = {kelvin += 0.1};
    }
  }
  return Study(experiment);
}

}  // namespace

TEST_CASE("the document of arms has the rows of their catalogue, in its order, and no other") {
  std::vector<std::string> ids, documented;
  for (const Effect& row : arm_catalogue())
    if (ids.empty() || ids.back() != row.id) ids.emplace_back(row.id);
  for (const DocumentedRow& row : documented_rows()) documented.push_back(row.id);
  CHECK(documented == ids);
}

TEST_CASE("words, places, parameters and units of the document of arms are those of their catalogue") {
  const Study study = study_of_all();
  const std::vector<DocumentedRow> rows = documented_rows();
  for (const Effect& row : arm_catalogue()) {
    INFO(std::string(row.id));
    const auto stated =
        std::find_if(rows.begin(), rows.end(), [&](const DocumentedRow& one) { return one.id == row.id; });
    REQUIRE(stated != rows.end());
    CHECK(row.at_joint == stated->at_joint);
    const EffectAt at(row, row.at_joint ? 2 : 0);
    if (row.form.empty())
      CHECK(at.in_words() == std::regex_replace(stated->words, std::regex(R"(\bj\b)"), "2"));
    else
      CHECK(stated->parameters.find(row.form) != std::string::npos);
    for (const ParameterRange& range : study.ranges(at)) {
      INFO(stated->parameters);
      CHECK(std::regex_search(stated->parameters,
                              std::regex("\\b" + as_documented(std::string(range.name)) + "\\b")));
      CHECK(stated->parameters.find(std::string(range.unit)) != std::string::npos);
    }
  }
}

TEST_CASE("the document of arms names the rows that chains in the plane have too") {
  const std::string text = document();
  const std::size_t from = text.find("of chains in the plane hold for arms too"),
                    to = text.find("The others are these", from);
  REQUIRE(to != std::string::npos);
  const std::string sentence = text.substr(from, to - from);
  std::set<std::string> named, shared;
  static const std::regex id("`(\\w+)`");
  for (std::sregex_iterator one(sentence.begin(), sentence.end(), id), end; one != end; ++one)
    named.insert((*one)[1]);
  for (const Effect& row : catalogue())
    if (row.in_space) shared.insert(std::string(row.id));
  CHECK(named == shared);
}
