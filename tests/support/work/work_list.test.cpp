#include "support/work/work_list.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <plumbline/base/error.hpp>
#include <stdexcept>

#include "support/files/text_file.hpp"
#include "support/work/journal.hpp"
#include "tests/folder.hpp"

using namespace plumbline::work;

namespace {

std::atomic<int> times = 0;

std::string doubled(const std::string& item) {
  ++times;
  if (item == "bad") throw std::runtime_error("bad item");
  return item + item;
}

const Task task{"double", doubled};

const auto nobody = [] {};

}  // namespace

TEST_CASE("results come in the order of the items, each done once") {
  WorkList list{task, {}};
  for (int i = 0; i < 500; ++i) list.items.push_back(std::to_string(i));
  times = 0;
  int advanced = 0;
  const auto all = results(list, nullptr, [&] { ++advanced; });
  CHECK(times == 500);
  CHECK(advanced == 500);
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] == list.items[i] + list.items[i]);
  CHECK(results({task, {}}, nullptr, nobody).empty());
}

TEST_CASE("work that was cut off goes on where it was; what no longer stands is done again") {
  const Folder here;
  const auto file = here / "unfinished.jsonl";
  {
    Journal journal(file, "doubling");
    CHECK_THROWS_WITH_AS(results({task, {"a", "b", "bad"}}, &journal, nobody), "bad item",
                         std::runtime_error);
  }
  {
    std::ofstream(file, std::ios::app) << R"({"item":"cut of)";  // killed while it wrote
    Journal journal(file, "doubling");
    REQUIRE(journal.find("a") != nullptr);
    CHECK(*journal.find("a") == "aa");
    times = 0;
    const std::vector<std::string> expected{"cc", "bb", "aa"};
    CHECK(results({task, {"c", "b", "a"}}, &journal, nobody) ==
          expected);    // in another order, with a new one
    CHECK(times <= 2);  // b may or may not have been done before the failure
  }
  Journal journal(file, "doubling");
  times = 0;
  const WorkList doubted{task, {"a", "b", "c"}, [](std::size_t i, const std::string& result) {
                           CHECK(result.size() == 2);
                           return i != 1;
                         }};
  CHECK(results(doubted, &journal, nobody)[1] == "bb");
  CHECK(times == 1);
  journal.finish();
  CHECK(!std::filesystem::exists(file));
}

TEST_CASE("a journal of other work, of another program, of two at once, or none at all is refused") {
  const Folder here;
  const auto file = here / "unfinished.jsonl";
  {
    const Journal journal(file, "this");
    CHECK_THROWS_WITH_AS(Journal(file, "this"), doctest::Contains("another process"), plumbline::Error);
  }
  CHECK_THROWS_WITH_AS(Journal(file, "that"), doctest::Contains("the unfinished work of \"this\""),
                       plumbline::Error);
  std::string text = plumbline::files::read_text(file);
  text[text.find("program") + 12] ^= 1;
  here.write("unfinished.jsonl", text);
  CHECK_THROWS_WITH_AS(Journal(file, "this"), doctest::Contains("another build"), plumbline::Error);
  here.write("unfinished.jsonl", "something else\n");
  CHECK_THROWS_WITH_AS(Journal(file, "this"), doctest::Contains("no unfinished work"), plumbline::Error);
  CHECK(plumbline::files::read_text(file) == "something else\n");
  CHECK_THROWS_WITH_AS(Journal(here / "nowhere" / "file", "this"), doctest::Contains("nowhere"),
                       plumbline::Error);
}

TEST_CASE(
    "whatever JSON a journal holds: it is refused in one line, or what is no result counts for nothing") {
  const std::string header = R"({"format":"plumbline-unfinished/1","program":"p","work":"this"})";
  const auto read = [&](const std::string& text) { return unfinished_results(text, header, "f"); };
  for (const char* none : {"", "\n", "[]\n", "{}\n", "{\"format\": 1}\n", "null\n", "\"format\"\n", "{\n"})
    CHECK_THROWS_WITH_AS(read(none), doctest::Contains("no unfinished work"), plumbline::Error);
  for (const char* other :
       {R"({"format":"plumbline-unfinished/1"})", R"({"format":"plumbline-unfinished/1","work":{"a":[1]}})",
        R"({"format":"plumbline-unfinished/1","work":"that\u001b[1m"})"})
    CHECK_THROWS_WITH_AS(read(other), doctest::Contains("the unfinished work of \""), plumbline::Error);
  const auto results = read(header + R"(
{"item": 1, "result": "x"}
{"item": "a", "result": {"x": 1}}
{"item": "b"}
[1, 2]
nothing
{"item": "c", "result": "d"}
)");
  CHECK(results == std::map<std::string, std::string>{{"c", "d"}});
}
