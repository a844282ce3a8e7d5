#include "support/files/experiment_files.hpp"

#include <doctest/doctest.h>

#include "tests/folder.hpp"

using namespace plumbline::files;
namespace fs = std::filesystem;

namespace {

void settings_naming(const Folder& here, const std::vector<std::string>& samples) {
  std::string text;
  for (const std::string& name : samples) text += "[[run]]\nsamples = \"" + name + "\"\n";
  here.write("experiment.toml", text);
}

}  // namespace

TEST_CASE("an experiment is its settings and the samples that they name") {
  const Folder here;
  here.write("a.csv", ""), here.write("unnamed.csv", "");
  settings_naming(here, {"a.csv", "missing.csv"});
  CHECK(experiment_files(here.path()) == std::vector<fs::path>{"experiment.toml", "a.csv"});
  CHECK(files_read(here.path()) == std::vector<fs::path>{here / "experiment.toml", here / "a.csv"});
  CHECK(files_read("").empty());
  CHECK(experiment_files(here / "nowhere").empty());
}

TEST_CASE("the model of an arm is of the experiment, whatever the arm is") {
  const Folder here;
  here.write("arm.urdf", "");
  for (const char* text :
       {"[arm]\nmodel = 'arm.urdf'\n", "arm.model = 'arm.urdf'\nrun = [{ samples = 'a.csv' }]\n"}) {
    here.write("experiment.toml", text);
    CHECK(experiment_files(here.path()) == std::vector<fs::path>{"experiment.toml", "arm.urdf"});
  }
  for (const char* text : {"arm = 1", "[[arm]]\nmodel = 'arm.urdf'", "[arm]\nmodel = 2"}) {
    here.write("experiment.toml", text);
    CHECK(experiment_files(here.path()) == std::vector<fs::path>{"experiment.toml"});
  }
}

TEST_CASE("settings that cannot be read name no samples: who reads them says why") {
  const Folder here;
  for (const char* text : {"run = 1", "run = [1, {}, { samples = 2 }]", "no TOML"}) {
    here.write("experiment.toml", text);
    CHECK(experiment_files(here.path()) == std::vector<fs::path>{"experiment.toml"});
  }
}

TEST_CASE("neither the label nor what lies outside is of the experiment, by whatever way it is named") {
  const Folder outside, here;
  outside.write("secret.csv", ""), here.write("label.json", "");
  fs::create_directory(here / "folder");
  fs::create_symlink(outside / "secret.csv", here / "link.csv");
  fs::create_symlink("label.json", here / "alias.csv");
  settings_naming(here, {"link.csv", "alias.csv", "label.json", "folder",
                         "../" + outside.path().filename().string() + "/secret.csv", outside / "secret.csv"});
  CHECK(experiment_files(here.path()) == std::vector<fs::path>{"experiment.toml"});
}

TEST_CASE("a trial reads experiments, labels and seals, by name") {
  const Folder here;
  CHECK(files_of("").empty());
  CHECK(files_of(here.path()) == std::vector<fs::path>{here / "seals.json"});
  for (const char* folder : {"b", "a", "labels", "aside"}) fs::create_directory(here / folder);
  here.write("a/experiment.toml", ""), here.write("b/experiment.toml", ""), here.write("labels/a.json", "");
  CHECK(files_of(here.path()) == std::vector<fs::path>{here / "a/experiment.toml", here / "a/label.json",
                                                       here / "b/experiment.toml", here / "b/label.json",
                                                       here / "labels/a.json", here / "seals.json"});
}
