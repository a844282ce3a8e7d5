#include "support/files/text_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <plumbline/base/error.hpp>

#include "support/files/csv_file.hpp"
#include "support/files/json_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/sha256.hpp"
#include "support/files/toml_file.hpp"
#include "tests/folder.hpp"
#include "tests/property.hpp"

namespace fs = std::filesystem;
using plumbline::Error;
using namespace plumbline::files;

TEST_CASE("what is no text is refused by the name of the file and the line") {
  const Folder here;
  here.write("blank", "\xEF\xBB\xBF\n");
  CHECK_THROWS_WITH_AS(read_text(here / "blank"), doctest::Contains("an empty file"), Error);
  here.write("latin", "a\nb \xE9 c\n");
  CHECK_THROWS_WITH_AS(read_text(here / "latin"), doctest::Contains("latin:2: found the byte \\xe9"), Error);
  here.write("zero", std::string("a\0b", 3));
  CHECK_THROWS_WITH_AS(read_text(here / "zero"), doctest::Contains("zero:1: found the byte \\x00"), Error);
  CHECK_THROWS_WITH_AS(read_text("/dev/zero"), doctest::Contains("a device"), Error);
  CHECK_THROWS_WITH_AS(read_text(here.path()), doctest::Contains("a directory"), Error);
}

TEST_CASE("a pipe that nobody writes into does not hang") {
  const Folder here;
  mkfifo((here / "pipe").c_str(), 0600);
  CHECK_THROWS_WITH_AS(read_text(here / "pipe"), doctest::Contains("an empty file"), Error);
}

TEST_CASE("what is shown of any bytes is one line without controls, and stays as it is") {
  CHECK(printable("a\x1b[31mb\nc\xE9") == "a\\x1b[31mb\\x0ac\\xe9");
  CHECK(printable("k\u00f6nig \u03b8 \u4e00") == "k\u00f6nig \u03b8 \u4e00");
  CHECK(printable("a\u202eb\u0085c\u2028d") == "a\\u202eb\\u0085c\\u2028d");
  check_property("printable", [](const std::string& bytes) {
    const std::string text = printable(bytes);
    RC_ASSERT(first_bad_byte(text) == std::string::npos);
    RC_ASSERT(std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }));
    RC_ASSERT(printable(text) == text);
    RC_ASSERT(shown(bytes).size() <= 80);
    RC_ASSERT(first_bad_byte(shown(bytes)) == std::string::npos);
  });
  CHECK_THROWS_WITH_AS(require_printable("a\nb", "name"), doctest::Contains("name: found a\\x0ab"), Error);
  CHECK_NOTHROW(require_name(std::string(200, 'a'), "name"));
  CHECK_THROWS_WITH_AS(require_name(std::string(201, 'a'), "name"),
                       doctest::Contains("found a name of 201 bytes, aaa"), Error);
}

TEST_CASE("a table without a row is refused, also behind a byte order mark") {
  for (const char* text : {"\n", "\xEF\xBB\xBF\n", "\r\n\r\n"})
    CHECK_THROWS_WITH_AS(parse_csv(text, "t.csv"), doctest::Contains("blank lines alone"), Error);
  CHECK(csv_field("\r") == "\"\r\"");  // a reader takes a bare one for the end of the row
}

TEST_CASE("keys of very many parts end in an error, not in the parser's recursion") {
  for (const char* part : {"a", "\"a\"", "'.'", "\",\""}) {
    std::string key = part;
    for (int i = 0; i < 50000; ++i) key += std::string(i % 2 ? "." : " . ") + part;
    CAPTURE(part);
    for (const std::string& text : {key + " = 1", "[" + key + "]\nb = 1", "a = {" + key + " = 1}",
                                    "s = \"\"\"\n'\"\"\"\n" + key + " = 1"})
      CHECK_THROWS_WITH_AS(parse_toml(text, "t.toml"), doctest::Contains("a key of more than 8 parts"),
                           Error);
  }
  std::string numbers = "a = [0.1";
  for (int i = 0; i < 1000; ++i) numbers += ", 0.1";
  CHECK_NOTHROW(parse_toml(numbers + "]\nb.c.d = \"1.2.3.4.5.6.7.8.9.10\" # 1.2.3.4.5.6.7.8.9.10", "t.toml"));
  CHECK_THROWS_AS(parse_toml("a = " + std::string(100000, '['), "t.toml"), Error);
}

TEST_CASE("errors in TOML and JSON name the line and show it, in our words") {
  CHECK_THROWS_WITH_AS(parse_toml("a = 1\nb = = 2\n", "t.toml"),
                       "t.toml:2: found text that is not TOML: b = = 2, expected key = value", Error);
  CHECK_THROWS_WITH_AS(parse_toml("a = 1\na = 2\n", "t.toml"), doctest::Contains("t.toml:2: found a key"),
                       Error);
  CHECK_THROWS_WITH_AS(parse_json("{\n\"a\": 1,\n\"b\": x}", "t.json"),
                       doctest::Contains("t.json:3: found text that is not JSON: \"b\": x"), Error);
  CHECK_THROWS_WITH_AS(parse_json("{\"a\": 1", "t.json"), doctest::Contains("an end in the middle"), Error);
  CHECK_THROWS_WITH_AS(parse_json("1e999", "t.json"), doctest::Contains("beyond double"), Error);
}

TEST_CASE("a pipe can be read again, and its digest is that of a file") {
  const Folder here;
  here.write("file", "some text\n");
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  REQUIRE(write(ends[1], "some text\n", 10) == 10);
  close(ends[1]);
  const fs::path through = "/dev/fd/" + std::to_string(ends[0]);
  const std::vector<fs::path> piped{through}, file{here / "file"}, twice{here / "file", here / "file"};
  CHECK(sha256(piped) == sha256(file));
  CHECK(read_text(through) == "some text\n");
  close(ends[0]);
  CHECK(sha256(twice) == sha256("some text\nsome text\n"));
  CHECK(sha256(std::vector<fs::path>{here / "nowhere"}) == sha256(""));
}
