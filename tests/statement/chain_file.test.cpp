#include "statement/chain_file.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::statement;

namespace {

std::string refusal(const std::string& text) {
  try {
    parse_chain(text, "c.toml");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

Structure<Rational> plane(const std::string& text) {
  return parse_plane_chain(text, "c.toml").structure;
}

SpaceStructure<Rational> space(const std::string& text) {
  return std::get<SpaceStructure<Rational>>(parse_chain(text, "c.toml"));
}

const std::string two_links = "lengths = [1, 1]\nstiffness = [0, 1]\n";
const std::string two_in_space =
    "lengths = [1, 1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [0] }, { axes = [[0, 1, 0]], stiffness = "
    "[1] "
    "}]\n";

}  // namespace

TEST_CASE("a key that is there and of another type is an error, in the plane and in space") {
  const struct {
    std::string text, said;
  } cases[] = {
      {two_links + "base = 3\n", "c.toml:3: base: found 3, expected \"pinned\""},
      {two_links + "base = true\n", "base: found true"},
      {two_links + "end_point = [1]\n", "end_point: found"},
      {two_links + "end_point = { across = true }\n", "across: found true, expected \"free\", \"held\""},
      {two_links + "end_point = { across = -1 }\n", "across: found -1"},
      {two_links + "supports = { at = 2, across = 1 }\n", "supports: found"},
      {two_links + "supports = [2]\n", "supports: found 2, expected a table"},
      {two_links + "supports = [{ at = 2 }]\n", "no key across"},
      {two_links + "supports = [{ across = 2 }]\n", "no key at"},
      {two_links + "supports = [{ at = 2.5, across = 1 }]\n", "at: found 2.5"},
      {two_links + "foundation = [1]\n", "foundation: found"},
      {two_links + "supports = [{ at = \"2\", across = 1 }]\n", "c.toml:3: at: found \"2\", expected"},
      {two_links + "supports = [{ at = 2, across = \"1\" }]\n", "across: found \"1\", expected \"free\""},
      {two_links + "foundation = '1e3'\n", "foundation: found \"1e3\", expected a decimal number"},
      {two_links + "loads = [{ force = [-1, \"0\"] }]\n", "force, entry 2: found \"0\", expected a decimal"},
      {two_links + "masses = [\"1;2\"]\n", "masses, entry 1: found 1;2, expected a decimal number"},
      {"lengths = [1, \"1\"]\nstiffness = [0, 1]\n", "lengths, entry 2: found \"1\""},
      {two_links + "foundation = -1\n", "foundation: found -1"},
      {two_links + "loads = { force = [-1, 0] }\n", "loads: found"},
      {two_links + "loads = [-1]\n", "loads: found -1, expected a table"},
      {two_links + "loads = [{ force = -1 }]\n", "force: found -1, expected a list"},
      {two_links + "loads = [{ force = [-1, 0], fixed = \"true\" }]\n",
       "fixed: found \"true\", expected true or false"},
      {two_links + "loads = [{ force = [-1, 0], fixed = 1 }]\n", "fixed: found 1, expected true or false"},
      {two_links + "loads = [{ force = [-1, 0], hung = 1 }]\n", "the unknown key hung"},
      {two_links + "loads = [{ torque = \"axial\" }]\n", "the unknown key torque"},
      {two_links + "masses = 1\n", "masses: found 1, expected a list"},
      {two_links + "masses = [1, -1]\n", "masses: found a negative value"},
      {two_links + "masses = [1, 1, 1, 1]\n", "masses: found 4 values"},
      {two_in_space + "base = \"sprung\"\n", "base: found sprung, expected \"jointed\""},
      {two_in_space + "base = { across = \"free\" }\n", "base: found one that moves"},
      {two_in_space + "base = { turn = 2 }\n", "base: found a spring that turns"},
      {two_in_space + "end_point = { along = \"held\" }\n", "held or sprung along"},
      {two_in_space + "end_point = { turn = 1 }\n", "a spring against turning in space"},
      {two_in_space + "end_point = true\n", "end_point: found true"},
      {two_in_space + "loads = [{ force = [-1, 0] }]\n", "force: found 2 values, expected 3"},
      {two_in_space + "loads = [{ weight = 1 }]\n", "weight: found 1, expected a list"},
      {two_in_space + "loads = [{ torque = \"axial\", fixed = true }]\n", "a torque that is fixed"},
      {two_in_space + "loads = [{ torque = \"axial\" }, { force = [-1, 0, 0] }]\n",
       "a torque beside other loads"},
      {two_in_space + "loads = [{ force = [-1, 0, 0], fixed = \"no\" }]\n", "fixed: found \"no\""},
      {two_in_space + "masses = [1, 1]\n", "the unknown key masses"},
      {two_in_space + "stiffness = [1, 1]\n", "the unknown key stiffness"},
      {"lengths = [1]\njoints = [{ axes = [0, 0, 1], stiffness = [1] }]\n", "axes: found"},
      {"lengths = [1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [1, 2] }]\n", "stiffness: found 2 values"},
      {"lengths = [1]\njoints = 1\n", "joints: found 1"},
      {"lengths = 1\nstiffness = [1]\n", "lengths: found 1, expected a list"},
      {"lengths = [true]\nstiffness = [1]\n", "found true, expected a decimal number"},
      {"beam = 1\n", "beam: found 1, expected a table"},
      {"beam = { EI = 1, length = 1, links = 4 }\nbase = { turn = \"stiff\" }\n", "turn: found"},
  };
  for (const auto& [text, said] : cases) {
    CAPTURE(text);
    const std::string found = refusal(text);
    CAPTURE(found);
    CHECK(found.starts_with("c.toml"));
    CHECK(found.find(said) != std::string::npos);
    CHECK(found.find('\n') == std::string::npos);
  }
}

TEST_CASE("ends and supports that contradict each other are refused") {
  const struct {
    std::string text, said;
  } cases[] = {
      {"lengths = [1, 1]\nstiffness = [1, 1]\nbase = \"clamped\"\n", "a spring at joint 1 of a clamped base"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nbase = { turn = \"held\" }\n",
       "a spring at joint 1 of a clamped base"},
      {two_links + "end_point = { along = \"held\" }\n", "end_point: found both ends held along the chain"},
      {two_links + "base = { along = \"free\" }\n", "base: found neither end held along the chain"},
      {two_links + "loads = []\n", "loads: found an empty list"},
      {two_in_space + "loads = []\n", "loads: found an empty list"},
      {two_links + "loads = [{ moment = 1, fixed = true }]\n", "a moment that is fixed"},
      {two_links + "base = { turn = 2 }\n", "a spring that turns beside that of joint 1"},
      {two_links + "base = \"sprung\"\n", "\"sprung\" without a spring at joint 1"},
      {two_links + "supports = [{ at = 2, across = 3 }, { at = 2, across = \"free\" }]\n", "joint 2 again"},
      {two_in_space + "supports = [{ at = 2, across = 3 }, { at = 2, across = \"free\" }]\n",
       "joint 2 again"},
      {"lengths = [1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [1] }]\nbase = \"clamped\"\n",
       "springs at joint 1 of a clamped base"},
      {"lengths = [1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [1] }]\nbase = \"bearing\"\n",
       "a bearing beside springs"},
  };
  for (const auto& [text, said] : cases) {
    CAPTURE(text);
    CHECK(refusal(text).find(said) != std::string::npos);
  }
}

TEST_CASE("a word and the table that it stands for are one end, in the plane and in space") {
  for (const auto& [word, table] :
       {std::pair("\"guided\"", "{ across = \"held\" }"), std::pair("\"free\"", "{ across = \"free\" }"),
        std::pair("\"clamped\"", "{ across = \"held\", turn = \"held\" }")}) {
    for (const std::string& chain : {two_links, two_in_space}) {
      CAPTURE(word);
      const auto end = [&](const std::string& said) {
        const StatedChain read = parse_chain(chain + "end_point = " + said + "\n", "c.toml");
        if (const auto* in_plane = std::get_if<PlaneChain>(&read)) return in_plane->structure.end_point;
        return std::get<SpaceStructure<Rational>>(read).end_point;
      };
      CHECK(end(word).across.is_held() == end(table).across.is_held());
      CHECK(end(word).turn.is_held() == end(table).turn.is_held());
      CHECK(end(word).along.is_free());
      CHECK(end(table).along.is_free());
    }
  }
  CHECK(space(two_in_space + "base = { turn = \"held\" }\n").base == SpaceBase::clamped);
  CHECK(space(two_in_space).base == SpaceBase::jointed);
  CHECK(plane(two_links + "base = { turn = \"held\" }\n").base.turn.is_held());
}

TEST_CASE("half of each link's weight and mass stands at either end, the base's too") {
  const Structure<Rational> chain = plane(
      "lengths = [1, 3]\nstiffness = [0, 1]\nbase = { along = \"free\", across = 2, turn = \"held\" }\n"
      "end_point = { along = \"held\", across = \"free\" }\nloads = [{ weight = [2, 4] }]\n");
  // the end point carries what lies before each link: 1 at the base, 1 + 2 more at joint 2
  const auto N = compression(chain).multiplied;
  CHECK(N == std::vector<Rational>{-1, -4});
  CHECK(chain.masses() == std::vector<Rational>{Rational(1, 2), 2, Rational(3, 2)});
  CHECK(plane(two_links + "masses = [3, 4]\n").masses() == std::vector<Rational>{0, 3, 4});
  CHECK(plane(two_links + "masses = [5, 3, 4]\n").masses() == std::vector<Rational>{5, 3, 4});
}

TEST_CASE("a chain within another file's table is read as it is") {
  CHECK(plane("[nominal]\nlink_length = [1, 2]\njoint_stiffness = [0, 1]\nend_point = \"free\"\n")
            .end_point.across.is_free());
  CHECK(parse_plane_chain(two_links, "c.toml").plain);
  CHECK(!parse_plane_chain(two_links + "base = \"pinned\"\n", "c.toml").plain);
  CHECK_THROWS_AS(parse_plane_chain(two_in_space, "c.toml"), Error);
}
