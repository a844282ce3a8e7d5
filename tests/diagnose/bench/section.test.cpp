#include "diagnose/bench/section.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

const toml::table sectioned = files::parse_toml(R"(empty = ""
word = "two words"
long_word = ")" + std::string(201, 'a') + R"("
words = ["a", "b"]
mixed = ["a", 1]
yes = true
number = -2.5
whole = 3
zero = 0
minus = -1
list = [1, 2.5]
none = []
odd = [1, inf]
[inner]
a = 1
b = 2.5
[inner.deep]
c = 7
[wrong]
a = "x"
[[entry]]
n = 1
[[entry]]
n = 2
m = "x"
)",
                                                "S");

const Section root_of_it(sectioned, "S");

/// The message with which a reader of sections refuses.
template <class Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a key is located by line and path, a missing one by its table") {
  CHECK(root_of_it.place("word") == "S:2: word");
  CHECK(root_of_it.place("absent") == "S: absent");  // of the whole file no line
  const Section inner = root_of_it.table("inner");
  CHECK(inner.place("b") == "S:16: inner.b");
  CHECK(inner.place("absent") == "S:14: inner.absent");
  CHECK(inner.where() == "S:14");
  CHECK(inner.table("deep").place("c") == "S:18: inner.deep.c");
  CHECK(inner.keys() == std::vector<std::string>{"a", "b", "deep"});
  CHECK(root_of_it.table_or_empty("inner").keys() == inner.keys());
  CHECK(root_of_it.table_or_empty("absent").keys().empty());
  CHECK(refusal([] { (void)root_of_it.table_or_empty("absent").number("x", "a number"); }) ==
        "S: absent.x: found no such key, expected a number");
  CHECK(refusal([] { (void)root_of_it.table("absent"); }) ==
        "S: absent: found no such key, expected a table [absent]");
  CHECK(refusal([] { (void)root_of_it.table("word"); }) ==
        "S:2: word: found 'two words', expected a table [word]");
}

TEST_CASE("tables of an array are numbered from 1") {
  const std::vector<Section> entries = root_of_it.tables("entry");
  REQUIRE(entries.size() == 2);
  CHECK(entries[0].place("n") == "S:22: entry[1].n");
  CHECK(entries[1].place("m") == "S:25: entry[2].m");
  CHECK(root_of_it.tables("absent").empty());
  CHECK(refusal([] { (void)root_of_it.tables("list"); }) ==
        "S:11: list: found [ 1, 2.5 ], expected tables [[list]]");
  CHECK(refusal([] { (void)root_of_it.tables("number"); }) ==
        "S:7: number: found -2.5, expected tables [[number]]");
}

TEST_CASE("an unknown key is refused with the known ones, without synonyms") {
  const Section entry = root_of_it.tables("entry")[1];
  CHECK_NOTHROW(entry.allow_only({"m", "n", "o"}));
  CHECK_NOTHROW(entry.allow_only({"n"}, {"m"}));
  CHECK(refusal([&] {
          entry.allow_only({"n", "o"}, {"p"});
        }) == "S:25: entry[2].m: found an unknown key, expected one of n o");
}

TEST_CASE("texts: not empty, short names, lists or single values") {
  CHECK(root_of_it.text("word", "a word") == "two words");
  CHECK(refusal([] { (void)root_of_it.text("empty", "a word"); }) == "S:1: empty: found '', expected a word");
  CHECK(refusal([] { (void)root_of_it.text("yes", "a word"); }) == "S:6: yes: found true, expected a word");
  CHECK(root_of_it.text("long_word", "a word").size() == 201);
  CHECK(root_of_it.name("word", "a word") == "two words");
  CHECK_THROWS_AS((void)root_of_it.name("long_word", "a word"), Error);
  using Words = std::vector<std::string>;
  CHECK(root_of_it.texts("word", "words") == Words{"two words"});
  CHECK(root_of_it.texts("words", "words") == Words{"a", "b"});
  CHECK(root_of_it.texts("none", "words").empty());
  CHECK(refusal([] { (void)root_of_it.texts("mixed", "words"); }) ==
        "S:5: mixed: found [ 'a', 1 ], expected words");
  CHECK(refusal([] { (void)root_of_it.texts("number", "words"); }) ==
        "S:7: number: found -2.5, expected words");
  const toml::table bell = toml::parse("a = \"\\u0007\"\n");
  CHECK_THROWS_AS((void)Section(bell, "B").text("a", "a word"), Error);
}

TEST_CASE("numbers: finite, not negative, whole, from 1; absent keys") {
  CHECK(root_of_it.number("number", "a number") == -2.5);
  CHECK(root_of_it.number("whole", "a number") == 3);
  CHECK(root_of_it.non_negative("absent") == 0);
  CHECK(root_of_it.non_negative("zero") == 0);
  CHECK(root_of_it.non_negative("whole") == 3);
  CHECK(refusal([] { (void)root_of_it.non_negative("number"); }) ==
        "S:7: number: found -2.5, expected a number, zero or positive");
  CHECK(root_of_it.whole_or("absent", 4) == 4);
  CHECK(root_of_it.whole_or("zero", 4) == 0);
  CHECK(root_of_it.whole_or("whole", 4) == 3);
  CHECK(refusal([] { (void)root_of_it.whole_or("minus", 4); }) ==
        "S:10: minus: found -1, expected a whole number, zero or positive");
  CHECK(refusal([] { (void)root_of_it.whole_or("number", 4); }) ==
        "S:7: number: found -2.5, expected a whole number, zero or positive");
  CHECK(root_of_it.count("absent") == 0);
  CHECK(root_of_it.count("whole") == 3);
  CHECK(refusal([] { (void)root_of_it.count("zero"); }) == "S:9: zero: found 0, expected an integer from 1");
  CHECK(refusal([] { (void)root_of_it.count("number"); }) ==
        "S:7: number: found -2.5, expected an integer from 1");
  const toml::table one = toml::parse("a = 1\n");
  CHECK(Section(one, "O").count("a") == 1);
  CHECK(root_of_it.flag_or("yes", false));
  CHECK(root_of_it.flag_or("absent", true));
  CHECK_FALSE(root_of_it.flag_or("absent", false));
  CHECK(refusal([] { (void)root_of_it.flag_or("whole", true); }) ==
        "S:8: whole: found 3, expected true or false");
}

TEST_CASE("lists of numbers: any or a given length, each finite and in range") {
  using Numbers = std::vector<double>;
  CHECK(root_of_it.numbers("list", 0) == Numbers{1, 2.5});
  CHECK(root_of_it.numbers("list", 2) == Numbers{1, 2.5});
  CHECK(root_of_it.pair("list") == std::array<double, 2>{1, 2.5});
  CHECK(refusal([] { (void)root_of_it.numbers("list", 3); }) ==
        "S:11: list: found 2 values, expected a list of 3 numbers");
  CHECK(refusal([] { (void)root_of_it.numbers("none", 0); }) ==
        "S:12: none: found 0 values, expected a list of numbers");
  CHECK(refusal([] { (void)root_of_it.numbers("word", 0); }) ==
        "S:2: word: found 'two words', expected a list of numbers");
  CHECK(refusal([] { (void)root_of_it.numbers("odd", 2); }) ==
        "S:13: odd[2]: found inf, expected a finite number");
  const auto below_two = [](double value) { return value < 2; };
  CHECK(refusal([&] { (void)root_of_it.numbers("list", 0, "less than 2", below_two); }) ==
        "S:11: list[2]: found 2.5, expected less than 2");
  CHECK(root_of_it.numbers("list", 0, "any", [](double) { return true; }) == Numbers{1, 2.5});
  using Named = std::map<std::string, double>;
  CHECK(root_of_it.table("inner").table("deep").keys().size() == 1);
  CHECK(root_of_it.table("inner").named_numbers("deep") == Named{{"c", 7}});
  CHECK(refusal([] { (void)root_of_it.named_numbers("wrong"); }) ==
        "S:19: wrong.a: found 'x', expected a finite number");
  CHECK(refusal([] { (void)root_of_it.named_numbers("word"); }) ==
        "S:2: word: found 'two words', expected a table of numbers");
}

TEST_CASE("numbers are shown by their shortest decimal, other values as in TOML") {
  const toml::table values = toml::parse("a = 0.1\nb = [1, 2]\n");
  CHECK(shown(*values.get("a")) == "0.1");
  CHECK(shown(*values.get("b")) == "[ 1, 2 ]");
}
