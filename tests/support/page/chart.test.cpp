#include "support/page/chart.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::page;

namespace {

Chart chart_of(std::vector<ChartPoint> points, Layer::Kind kind = Layer::Kind::line) {
  return {"id", "<title>", "words", "x, m", "y, N", {{kind, "measured", std::move(points)}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a chart has its words for those who do not see it, as text") {
  const std::string svg = drawn(chart_of({{0, 0}, {1, 1}}));
  CHECK(svg.find("<title id=\"id-title\">&lt;title&gt;</title>") != std::string::npos);
  CHECK(svg.find("<desc id=\"id-desc\">words</desc>") != std::string::npos);
}

TEST_CASE("a missing value interrupts a line, and nothing that is not finite is drawn") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = drawn(chart_of({{0, 0}, {1, 1}, {2, nan}, {3, 3}, {4, 4}}));
  const std::string line = svg.substr(svg.find("class=\"line"));
  CHECK(count(line.substr(0, line.find("/>")), "M") == 2);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(drawn(chart_of({})).find("nan") == std::string::npos);
  CHECK(drawn(chart_of({{1, 1}})).find("nan") == std::string::npos);
}

TEST_CASE("of a hundred thousand points the chart keeps the extremes and stays small") {
  std::vector<ChartPoint> points;
  for (int i = 0; i < 100000; ++i) points.push_back({i * 1e-5, std::sin(i * 1e-3)});
  points[54321].y = 25;  // one outlier
  const std::string svg = drawn(chart_of(points, Layer::Kind::dots));
  CHECK(svg.size() < 40000);
  // The outlier defines the upper end of the axis: a dot stands where the air above it begins.
  const std::string with = svg.substr(svg.find("class=\"dots"));
  double highest = 1e9;
  for (std::size_t at = with.find('M'); at != std::string::npos; at = with.find('M', at + 1))
    highest = std::min(highest, std::stod(with.substr(with.find(' ', at))));
  CHECK(highest < 50);
}

TEST_CASE("a drawing in space has one scale for both axes") {
  Chart chart = chart_of({{0, 0}, {2, 0}, {2, 1}});
  chart.equal_axes = true;
  const std::string svg = drawn(chart);
  const std::size_t at = svg.find("d=\"M", svg.find("class=\"line"));
  double x0, y0, x1, y1, x2, y2;
  REQUIRE(std::sscanf(svg.c_str() + at, "d=\"M%lf %lfL%lf %lfL%lf %lf", &x0, &y0, &x1, &y1, &x2, &y2) == 6);
  CHECK(x1 - x0 == close_to(2 * (y1 - y2)).epsilon(0.01));  // drawn to a tenth of a pixel
}

TEST_CASE("a point says its values to who points at it, and no page gets heavy by that") {
  Chart chart = chart_of({{0.5, -1}, {1, 2}}, Layer::Kind::dots);
  CHECK(count(drawn(chart), "class=\"value\"") == 0);
  chart.layers[0].told = true;
  const std::string svg = drawn(chart);
  CHECK(svg.find("<title>y −1 N, x 0.5 m</title>") != std::string::npos);
  CHECK(count(svg, "class=\"value\"") == 2);
  for (int i = 0; i < 10000; ++i) chart.layers[0].points.push_back({1.0 * i, 0});
  CHECK(count(drawn(chart), "class=\"value\"") <= 100);
}

TEST_CASE("the heads of arrows along a line go the way of its points") {
  Chart chart = chart_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
  chart.layers[0].directed = true;
  for (const bool back : {false, true}) {
    if (back) std::reverse(chart.layers[0].points.begin(), chart.layers[0].points.end());
    const std::string svg = drawn(chart);
    const std::size_t at = svg.find("d=\"M", svg.find("class=\"arrow measured\""));
    double tip, one, other, ignored;
    REQUIRE(std::sscanf(svg.c_str() + at, "d=\"M%lf %lfL%lf %lfL%lf", &tip, &ignored, &one, &ignored,
                        &other) == 5);
    CHECK(one == close_to(other));
    CHECK((tip > one) == !back);
  }
}
