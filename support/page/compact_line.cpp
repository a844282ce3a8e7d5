#include "support/page/compact_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <vector>

namespace plumbline::page {
namespace {

struct Spot {
  double x, y;
};

struct Polyline {
  std::vector<Spot> spots;
  bool closed = false;
};

/// The lines of absolute path data; nothing where it has other commands than M, L and Z.
std::optional<std::vector<Polyline>> lines_of(const std::string& path) {
  std::vector<Polyline> lines;
  for (const char* at = path.c_str();;) {
    while (std::isspace(static_cast<unsigned char>(*at)) != 0 || *at == ',') ++at;
    if (*at == '\0') return lines;
    const char command = std::isalpha(static_cast<unsigned char>(*at)) != 0 ? *at++ : 'L';
    if (command == 'M') lines.emplace_back();
    if (lines.empty() || lines.back().closed) return std::nullopt;
    if (command == 'Z') lines.back().closed = true;
    if (command != 'M' && command != 'L') {
      if (command == 'Z') continue;
      return std::nullopt;
    }
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    at = end + (*end == ',' ? 1 : 0);
    const double y = std::strtod(at, &end);
    if (end == at) return std::nullopt;
    at = end;
    lines.back().spots.push_back({x, y});
  }
}

double distance(const Spot& p, const Spot& a, const Spot& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Of the spots between two, those that are needed to stay within the tolerance (Douglas and Peucker).
void thin(const std::vector<Spot>& spots, std::size_t first, std::size_t last, double tolerance,
          std::vector<Spot>& kept) {
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = distance(spots[i], spots[first], spots[last]);
    if (off > most) most = off, farthest = i;
  }
  if (farthest == first) return;
  thin(spots, first, farthest, tolerance, kept);
  kept.push_back(spots[farthest]);
  thin(spots, farthest, last, tolerance, kept);
}

/// Tenths as a decimal, without what is not needed.
std::string decimal(long tenths) {
  const long size = std::abs(tenths);
  std::string text = tenths < 0 ? "-" : "";
  if (size >= 10 || size % 10 == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += "." + std::to_string(size % 10);
  return text;
}

std::string both(long x, long y) {
  return decimal(x) + (y < 0 ? "" : " ") + decimal(y);
}

class Pen {
 public:
  void move(long x, long y) {
    text_ += written_ ? "m" + both(x - x_, y - y_) : "M" + both(x, y);
    written_ = true, last_ = 'm';
    x_ = first_x_ = x, y_ = first_y_ = y;
  }
  void draw(long x, long y) {
    const long dx = x - x_, dy = y - y_;
    if (dx == 0 && dy == 0) return;
    x_ = x, y_ = y;
    if (dy == 0)
      text_ += "h" + decimal(dx), last_ = 'h';
    else if (dx == 0)
      text_ += "v" + decimal(dy), last_ = 'v';
    else
      text_ += (last_ == 'l' ? (dx < 0 ? "" : " ") : "l") + both(dx, dy), last_ = 'l';
  }
  void close() {
    text_ += "z", last_ = 'z';
    x_ = first_x_, y_ = first_y_;
  }
  [[nodiscard]] std::string text() const { return text_; }

 private:
  std::string text_;
  bool written_ = false;
  char last_ = ' ';
  long x_ = 0, y_ = 0, first_x_ = 0, first_y_ = 0;
};

}  // namespace

std::string compact_line(const std::string& path) {
  const auto lines = lines_of(path);
  if (!lines) return path;
  // A spot is moved by at most 0.05 px across and 0.05 px up when it is rounded; the rest is for thinning.
  constexpr double rounding = 0.05 * std::numbers::sqrt2;
  Pen pen;
  for (const Polyline& line : *lines) {
    std::vector<Spot> kept{line.spots.front()};
    thin(line.spots, 0, line.spots.size() - 1, unseen - rounding, kept);
    if (line.spots.size() > 1) kept.push_back(line.spots.back());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const long x = std::lround(10 * kept[i].x), y = std::lround(10 * kept[i].y);
      i == 0 ? pen.move(x, y) : pen.draw(x, y);
    }
    if (line.closed) pen.close();
  }
  return pen.text();
}

}  // namespace plumbline::page
