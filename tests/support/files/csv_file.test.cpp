#include "support/files/csv_file.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::files;

TEST_CASE("fields keep what is in quotes, and rows know their line") {
  const auto rows = parse_csv(
      "\xEF\xBB\xBF"
      "a,b\r\n\n \"x, \"\"y\"\"\nz\" , 2 \r\nlast,",
      "t.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].fields == std::vector<std::string>{"a", "b"});
  CHECK(rows[1].fields == std::vector<std::string>{"x, \"y\"\nz", "2"});
  CHECK(rows[1].line == 3);
  CHECK(rows[2].fields == std::vector<std::string>{"last", ""});
  CHECK(rows[2].line == 5);
}

TEST_CASE("what csv_field writes, parse_csv reads") {
  const std::vector<std::string> fields{"plain", "a, b", "\"quoted\"", "two\nlines", ""};
  std::string text;
  for (const std::string& field : fields) text += (text.empty() ? "" : ",") + csv_field(field);
  CHECK(parse_csv(text + "\n", "t.csv").at(0).fields == fields);
}

TEST_CASE("quotes that do not match are refused with their line") {
  CHECK_THROWS_WITH_AS(parse_csv("a,b\nc,d\"e\n", "t.csv"), doctest::Contains("t.csv:2: found"), Error);
  CHECK_THROWS_AS(parse_csv("a,b\n\"c,d\n", "t.csv"), Error);
}
