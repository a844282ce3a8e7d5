#include "diagnose/report/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

constexpr std::size_t width = 58, height = 11;

struct Range {
  double low, high;

  [[nodiscard]] std::size_t cell(double value, std::size_t cells) const {
    const double share = high > low ? (value - low) / (high - low) : 0.5;
    return std::min(cells - 1, static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(cells)));
  }
};

}  // namespace

std::string picture(const Missing& missing) {
  if (missing.points.empty()) return "";
  Range across{missing.points.front().at, missing.points.front().at}, up{0, 0};
  for (const MissingPoint& point : missing.points) {
    across = {std::min(across.low, point.at), std::max(across.high, point.at)};
    up = {std::min(up.low, point.value), std::max(up.high, point.value)};
  }
  std::vector<std::string> rows(height, std::string(width, ' '));
  rows[height - 1 - up.cell(0, height)] = std::string(width, '.');
  for (const MissingPoint& point : missing.points) {
    char& cell = rows[height - 1 - up.cell(point.value, height)][across.cell(point.at, width)];
    const char mark = point.falling ? '<' : '>';
    cell = cell == ' ' || cell == '.' || cell == mark ? mark : '8';
  }
  std::string text = fmt::format("  {} ({}) over {} ({}); > rising, < falling, 8 both\n", missing.what,
                                 missing.unit, missing.against, missing.against_unit);
  for (std::size_t r = 0; r < height; ++r) {
    const std::string scale = r == 0            ? fmt::format("{:.3g}", up.high)
                              : r == height - 1 ? fmt::format("{:.3g}", up.low)
                                                : "";
    text += fmt::format("{:>10} |{}\n", scale, rows[r]);
  }
  const std::string left = fmt::format("{:.3g}", across.low), right = fmt::format("{:.3g}", across.high);
  text += fmt::format("{:>10} +{}\n{:12}{}{:>{}}\n", "", std::string(width, '-'), "", left, right,
                      width - left.size());
  return text;
}

}  // namespace plumbline::diagnose
