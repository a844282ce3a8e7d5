#include "support/page/markup.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::page;

TEST_CASE("numbers are written for readers") {
  CHECK(written(0.035012, NumberStyle::figures) == "0.035");
  CHECK(written(0.035012, NumberStyle::precise) == "0.03501");
  CHECK(written(-1.234e-7, NumberStyle::figures) == "−1.23 × 10⁻⁷");
  CHECK(written(2.5e12, NumberStyle::figures) == "2.5 × 10¹²");
  CHECK(written(12, NumberStyle::count) == "12");
  CHECK(written(0.10512, NumberStyle::percent) == "10.5 %");
  CHECK(written(1.9098, NumberStyle::percent) == "191 %");
  CHECK(written(1e-9, NumberStyle::percent) == "< 0.01 %");
  CHECK(written(0.9996, NumberStyle::percent) == "> 99.9 %");
  CHECK(written(1, NumberStyle::percent) == "> 99.9 %");
  CHECK(written(0, NumberStyle::percent) == "0 %");
  CHECK(written(0.814, NumberStyle::share) == "81 %");
  CHECK(written(0.0994, NumberStyle::share) == "9.9 %");
  CHECK(written(0.0996, NumberStyle::share) == "10 %");
  CHECK(written(0, NumberStyle::chance) == "< 10⁻¹²");
  CHECK(p_value(0) == "p < 1e-12");
  CHECK(p_value(1e-141) == "p < 1e-12");
  CHECK(p_value(0.04237) == "p = 0.042");
  CHECK(written(std::log(340), NumberStyle::odds) == "340 to 1");
  CHECK(written(800, NumberStyle::odds) == "over a million to 1");
}

TEST_CASE("a marked number says exactly what it is, and where it stands") {
  const double value = 0.1 + 0.2;
  const std::string text = marked(value, "/a/\"b\"", NumberStyle::figures);
  CHECK(text == R"(<data value="0.30000000000000004" data-key="/a/&quot;b&quot;">0.3</data>)");
}

TEST_CASE("every number of a report is marked with its pointer, all else is left alone") {
  const nlohmann::ordered_json report = {{"a", {1, "x", nullptr, true}}, {"b/c", {{"d", 2.5}}}};
  const auto view = with_marked_numbers(report, [](const std::string&) { return NumberStyle::figures; });
  CHECK(view["a"][0] == R"(<data value="1.0" data-key="/a/0">1</data>)");
  CHECK(view["a"][1] == "x");
  CHECK(view["a"][2].is_null());
  CHECK(view["a"][3] == true);
  CHECK(view["b/c"]["d"] == R"(<data value="2.5" data-key="/b~1c/d">2.5</data>)");
}

TEST_CASE("what a user wrote is text, never markup") {
  const std::string text = filled("<p>{{name}}</p>", {{"name", "<script>\"&'"}});
  CHECK(text == "<p>&lt;script&gt;&quot;&amp;&apos;</p>");
}

TEST_CASE("what is empty, null or false is no section") {
  const nlohmann::ordered_json view = {{"list", nlohmann::ordered_json::array()},
                                       {"object", nlohmann::ordered_json::object()},
                                       {"null", nullptr},
                                       {"no", false},
                                       {"yes", true}};
  CHECK(
      filled("{{#list}}1{{/list}}{{#object}}2{{/object}}{{#null}}3{{/null}}{{#no}}4{{/no}}{{#yes}}5{{/yes}}",
             view) == "5");
}

TEST_CASE("a broken template is an error") {
  CHECK_THROWS_AS(filled("{{#open}}never closed", {}), Error);
}
