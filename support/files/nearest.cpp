#include "support/files/nearest.hpp"

#include <algorithm>

namespace plumbline::files {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        least[i][j] = i + j;
        continue;
      }
      least[i][j] = std::min(
          {least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
    }
  return least[a.size()][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 100;  // the table of distances is as long as both words
  if (word.empty() || word.size() > longest) return "";
  std::string best;
  // a letter of the word remains at least
  std::size_t least = std::min(std::max<std::size_t>(1, word.size() / 3), word.size() - 1) + 1;
  for (const std::string& one : known)
    if (const std::size_t off = distance(word, one); off < least) least = off, best = one;
  return best;
}

std::string expected_word(std::string_view word, const std::vector<std::string>& known) {
  std::string expected = nearest(word, known);
  expected += expected.empty() ? "one of" : ", or one of";
  for (const std::string& one : known) expected += " " + one;
  return expected;
}

}  // namespace plumbline::files
