#include "support/files/json_file.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using files::JsonValue, files::parse_json;

namespace {

/// What reading says of it.
template <class Read>
std::string refused(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what is no JSON is refused with its line") {
  CHECK(refused([] { parse_json("{}", "a.json"); }).empty());
  CHECK(refused([] { parse_json("{\n\"a\": x}", "a.json"); }) ==
        "a.json:2: found text that is not JSON: \"a\": x, expected JSON");
  CHECK(refused([] { parse_json("[1,\n2", "a.json"); }) ==
        "a.json:2: found an end in the middle, expected JSON");
  CHECK(refused([] { parse_json("1e999", "a.json"); }) ==
        "a.json: found a number beyond double precision, expected JSON");
}

TEST_CASE("values are read by key, and what stands for another is refused at its place") {
  const nlohmann::json json =
      parse_json(R"({"name": "arm", "k": 2.5, "none": null, "list": [1, "two"]})", "a.json");
  const JsonValue whole(json, "a.json");
  CHECK(whole.has("name"));
  CHECK_FALSE(whole.has("none"));
  CHECK_FALSE(whole.has("other"));
  CHECK(whole.at("name", "a name").text("text") == "arm");
  CHECK(whole.text_or("name", "otherwise") == "arm");
  CHECK(whole.text_or("none", "otherwise") == "otherwise");
  CHECK(whole.number_or("k", 1) == 2.5);
  CHECK(whole.number_or("other", 1) == 1);
  CHECK(whole.members("an object").size() == 4);
  const std::vector<JsonValue> list = whole.at("list", "a list").list("a list");
  CHECK(list.size() == 2);
  CHECK(list[1].place() == "a.json, list[2]");

  CHECK(refused([&] { static_cast<void>(whole.at("other", "a thing")); }) ==
        "a.json: found no key \"other\", expected a thing");
  CHECK(refused([&] { static_cast<void>(list[0].at("key", "a thing")); }) ==
        "a.json, list[1]: found 1, expected an object with \"key\"");
  CHECK(refused([&] { static_cast<void>(list[0].text("a word")); }) ==
        "a.json, list[1]: found 1, expected a word");
  CHECK(refused([&] { static_cast<void>(list[1].number("a number")); }) ==
        "a.json, list[2]: found \"two\", expected a number");
  CHECK(refused([&] { static_cast<void>(whole.list("a list")); }).ends_with("expected a list"));
  CHECK(refused([&] { static_cast<void>(list[0].members("an object")); }) ==
        "a.json, list[1]: found 1, expected an object");
  CHECK_FALSE(list[0].has("key"));
}
