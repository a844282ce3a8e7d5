#include "support/files/nearest.hpp"

#include <doctest/doctest.h>

#include "tests/property.hpp"

namespace plumbline::files {

TEST_CASE("a mistyped word has its nearest known one, a strange word none") {
  const std::vector<std::string> verbs{"critical", "diagnose", "draft", "new", "path"};
  CHECK(nearest("diagnos", verbs) == "diagnose");
  CHECK(nearest("daignose", verbs) == "diagnose");  // neighbours swapped are one change
  CHECK(nearest("crtiicl", verbs) == "critical");
  CHECK(nearest("nwe", verbs) == "new");
  CHECK(nearest("buckle", verbs) == "");
  CHECK(nearest("x", {"q", "t"}) == "");  // of which nothing remains
  CHECK(expected_word("pth", verbs) == "path, or one of critical diagnose draft new path");
  CHECK(expected_word("buckle", verbs) == "one of critical diagnose draft new path");
}

TEST_CASE("a known word is nearest to itself, and to itself with a letter less") {
  check_property("words of four letters and more", [](const std::vector<std::string>& others) {
    std::string word = "stiffness";
    std::vector<std::string> known{"stiffness"};
    for (const std::string& other : others)
      if (other.size() > 2 * word.size()) known.push_back(other);  // further off than any change of a letter
    RC_ASSERT(nearest(word, known) == word);
    word.erase(*rc::gen::inRange<std::size_t>(0, word.size()), 1);
    RC_ASSERT(nearest(word, known) == "stiffness");
  });
}

}  // namespace plumbline::files
