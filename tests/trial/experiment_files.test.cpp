#include "support/files/experiment_files.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/campaign/diagnosis_process.hpp"
#include "support/files/text_file.hpp"
#include "tests/folder.hpp"
#include "trial/label.hpp"

namespace fs = std::filesystem;
using namespace plumbline::files;
using namespace plumbline::campaign;
using namespace plumbline::trial;

namespace {

Label parsed(const std::string& effect) {
  const auto json = nlohmann::json::parse(R"({"effects": [)" + effect + "]}");
  return label_from(json, "label.json");
}

/// A program in place of the diagnosis, which writes down what it sees.
fs::path program(const Folder& here, const std::string& text) {
  here.write("program", "#!/bin/sh\n" + text);
  chmod((here / "program").c_str(), 0700);
  return here / "program";
}

}  // namespace

TEST_CASE("a diagnosis sees the files that experiment.toml names, not the label or other files") {
  const Folder here;
  fs::create_directories(here / "E/sub");
  here.write("secret.csv", "secret");
  here.write("E/experiment.toml",
             "run = [{samples = 'a.csv'}, {samples = 'sub/b.CSV'}, {samples = 'link.csv'}, {samples = "
             "'inside.csv'}, "
             "{samples = 'dangling.csv'}, {samples = 'pipe.csv'}, {samples = 'folder.csv'}, {samples = "
             "'../secret.csv'}, "
             "{samples = 'label.json'}, {samples = 'alias.csv'}, {samples = '/etc/passwd'}]\n");
  for (const char* name : {"E/a.csv", "E/sub/b.CSV", "E/label.json", "E/other.csv"}) here.write(name, name);
  fs::create_symlink("../secret.csv", here / "E/link.csv");
  fs::create_symlink("a.csv", here / "E/inside.csv");
  fs::create_symlink("nowhere", here / "E/dangling.csv");
  fs::create_symlink("label.json", here / "E/alias.csv");
  mkfifo((here / "E/pipe.csv").c_str(), 0600);
  fs::create_directory(here / "E/folder.csv");
  const std::vector<fs::path> seen{"experiment.toml", "a.csv", "sub/b.CSV", "inside.csv"};
  CHECK(experiment_files(here / "E") == seen);

  const fs::path spy = program(here, "cd \"$2\" && find . -type f | sort > \"$4\"\n");
  const Diagnosed done = diagnose_alone(spy, here / "E", here / "report", std::chrono::seconds(60));
  CHECK(done.failure.empty());
  CHECK(plumbline::files::read_text(here / "report") ==
        "./a.csv\n./experiment.toml\n./inside.csv\n./sub/b.CSV\n");
}

TEST_CASE("a diagnosis that crashes, fails or takes too long is a failure with its reason") {
  const Folder here;
  fs::create_directory(here / "E");
  here.write("E/experiment.toml", "name = 'a'\n");
  const auto failure = [&](const std::string& text, double patience) {
    return diagnose_alone(program(here, text), here / "E", here / "report",
                          std::chrono::duration<double>(patience))
        .failure;
  };
  CHECK(failure("kill -9 $$", 60) == "killed by signal 9");
  CHECK(failure("echo why >&2; echo more >&2; exit 3", 60) == "exit status 3: why");
  CHECK(failure("exec sleep 60", 0.1) == "not done after 0.1 s");
}

TEST_CASE("all files that a trial reads are known beforehand") {
  const Folder here;
  fs::create_directories(here / "one");
  fs::create_directories(here / "labels");
  here.write("one/experiment.toml", "run = [{samples = 'a.csv'}]\n");
  here.write("one/a.csv", "t");
  here.write("labels/one.json", "{}");
  const std::vector<fs::path> files = files_of(here.path());
  for (const char* name :
       {"one/experiment.toml", "one/a.csv", "one/label.json", "seals.json", "labels/one.json"})
    CHECK(std::find(files.begin(), files.end(), here / name) != files.end());
  CHECK(files_of("").empty());
  CHECK(files_of("/nowhere").size() == 1);
}

TEST_CASE("a joint in a label is a whole number from 1, or null") {
  CHECK(parsed(R"({"id": "rest_angle", "joint": 2})").effects[0].joint == 2);
  CHECK(parsed(R"({"id": "rest_angle", "joint": null})").effects[0].joint == 0);
  CHECK(parsed(R"({"id": "rest_angle"})").effects[0].joint == 0);
  for (const char* joint : {"-1", "0", "1.5", "1e300", "\"1\"", "true", "[1]", "18446744073709551616"}) {
    CAPTURE(joint);
    CHECK_THROWS_WITH_AS(parsed(std::string(R"({"id": "rest_angle", "joint": )") + joint + "}"),
                         doctest::Contains("label.json, effects[1], joint: found "), plumbline::Error);
  }
  CHECK_THROWS_WITH_AS(parsed(R"("rest_angle")"), doctest::Contains("effects[1]: found \"rest_angle\""),
                       plumbline::Error);
}
