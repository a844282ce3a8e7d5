#include <doctest/doctest.h>

#include <algorithm>

#include "tests/app/process.hpp"

namespace {

const std::filesystem::path published = PLUMBLINE_SOURCE_DIR "/verify/reference/values";

}  // namespace

TEST_CASE("the reference set in the repository is what the command writes, to the byte" *
          doctest::test_suite("long")) {
  const Workplace here;
  REQUIRE(here.plumbline("reference --compact --out set").status == 0);
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(published)) {
    const std::string name = file.path().filename();
    INFO(name);
    std::ostringstream expected;
    expected << std::ifstream(file.path()).rdbuf();
    CHECK(here.read("set/" + name) == expected.str());
    ++files;
  }
  CHECK(files == 24);
  CHECK(static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(here.path() / "set"), {})) == files);
}

TEST_CASE("an unusable folder is refused, and nothing is written") {
  const Workplace here;
  here.write("file", "x");
  for (const char* arguments :
       {"reference", "reference --compact --out file", "reference --compact --out file/set",
        "reference --compact --out set --seed x"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(here.files() == 1);
  }
}
