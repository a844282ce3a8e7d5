#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "support/page/compact_line.hpp"
#include "support/page/compact_svg.hpp"

using namespace plumbline::page;

namespace {

struct Spot {
  double x, y;
};

/// The spots of path data with the commands M m L l H h V v Z z; a reader of its own, for numbers that follow
/// each other without a space.
std::vector<Spot> spots(const std::string& path) {
  std::vector<Spot> found;
  Spot at{0, 0}, first{0, 0};
  char command = ' ';
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == ' ' || path[i] == ',') {
      ++i;
      continue;
    }
    if (std::isalpha(static_cast<unsigned char>(path[i])) != 0) command = path[i++];
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const auto number = [&] {
      while (path[i] == ' ' || path[i] == ',') ++i;
      std::size_t length = 0;
      const double value = std::stod(path.substr(i), &length);
      i += length;
      return value;
    };
    const char which = static_cast<char>(std::tolower(static_cast<unsigned char>(command)));
    Spot to = relative ? Spot{0, 0} : at;
    if (which == 'z') {
      at = first;
      continue;
    }
    if (which != 'v') to.x = number();
    if (which != 'h') to.y = number();
    at = relative ? Spot{at.x + to.x, at.y + to.y} : to;
    if (which == 'm') first = at;
    found.push_back(at);
  }
  return found;
}

double off(const Spot& p, const Spot& a, const Spot& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// How far the farthest of the first line's spots is from the second line.
/// at them.
double farthest(const std::vector<Spot>& one, const std::vector<Spot>& other) {
  double most = 0;
  for (const Spot& p : one) {
    double least = off(p, other.front(), other.front());
    for (std::size_t i = 1; i < other.size(); ++i) least = std::min(least, off(p, other[i - 1], other[i]));
    most = std::max(most, least);
  }
  return most;
}

}  // namespace

TEST_CASE("a compact line is no longer, and nowhere farther from the line that was drawn than it says") {
  const bool holds = rc::check([](const std::vector<std::pair<int, int>>& steps, bool smooth) {
    std::string path = "M100.25,200.75";
    double x = 100.25, y = 200.75;
    for (const auto& [dx, dy] : steps) {
      x += (smooth ? 1 : dx % 4000) / 100.0, y += (dy % (smooth ? 30 : 4000)) / 100.0;
      std::ostringstream text;
      text << " L" << x << ',' << y;
      path += text.str();
    }
    const std::string compact = compact_line(path);
    RC_ASSERT(compact.size() <= path.size());
    const auto before = spots(path), after = spots(compact);
    RC_ASSERT(farthest(before, after) <= unseen + 1e-9);
    RC_ASSERT(farthest(after, before) <= unseen + 1e-9);
  });
  CHECK(holds);
}

TEST_CASE(
    "a straight line keeps its ends alone; a closed one stays closed; what is no line of these stays as it "
    "is") {
  CHECK(compact_line("M10,20 L20,20.01 L30,19.99 L40,20") == "M10 20h30");
  CHECK(compact_line("M0,0 L10,0 L10,10 Z M5,5 L6,7") == "M0 0h10v10zm5 5l1 2");
  CHECK(compact_line("M0,0 C1,1 2,2 3,3") == "M0,0 C1,1 2,2 3,3");
  CHECK(compact_line("M1,1").find("nan") == std::string::npos);
}

TEST_CASE("a compact drawing has what is seen, each look once, and nothing else") {
  const std::string svg = compact_svg(
      R"svg(<svg width="9" height="9" xmlns:xlink="http://www.w3.org/1999/xlink"><title>t</title>
      <defs><circle id='a' r='1'/><circle id='b' r='2'/><use xlink:href='#b' id='c'/></defs>
      <g id='x'><g fill="none" color="red" stroke="currentColor" stroke-width="1.00"> <path d='M0,0 L1,0 '/></g></g>
      <g></g><g fill="none" stroke="red"><path d='M0,5 L1,5 '/></g><use xlink:href='#a' transform='scale(2)'/>
      <g transform="translate(3.00,4.50)" stroke="none" fill="black"><text><tspan>q &lt; 1</tspan></text></g>
      </svg>)svg");
  CHECK(svg.find(".a0{fill:none;stroke:red}") != std::string::npos);
  CHECK(svg.find("<path d='M0 0h1m-1 5h1' class='a0'/>") != std::string::npos);  // two neighbours, alike
  CHECK(svg.find("<text x='3' y='4.5' class='a1'>q &lt; 1</text>") != std::string::npos);
  for (const char* const gone : {"<title", "<g", "id='b'", "id='c'"})
    CHECK_MESSAGE(svg.find(gone) == std::string::npos, gone);
  CHECK(svg.find("id='a'") != std::string::npos);
  CHECK_THROWS_AS(compact_svg("<svg><g></svg>"), plumbline::Error);
}
