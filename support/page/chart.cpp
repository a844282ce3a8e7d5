#include "support/page/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/page/axis.hpp"
#include "support/page/markup.hpp"

namespace plumbline::page {
namespace {

constexpr double width = 360, height = 240;
constexpr double left = 46, right = width - 16, top = 32, bottom = height - 34;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// A little air on both sides; a range of nothing becomes 0 to 1.
  [[nodiscard]] Range with_air(double share) const {
    if (!(low <= high)) return {0, 1};
    return {low - share * (high - low), high + share * (high - low)};
  }
};

/// Where a chart's points lie, and how they come to pixels.
struct Frame {
  Axis x, y;
  double bottom;  ///< pixel of the lower edge
  double height;  ///< of the whole drawing
};

Frame linear_frame(const Chart& chart, const Range& x, const Range& y) {
  const Range across = x.with_air(0.03), up = y.with_air(0.06);
  return {Axis(across.low, across.high, left, right), Axis(up.low, up.high, bottom, top, chart.signed_log),
          bottom, height};
}

/// One scale for both axes: the drawing gets the height that it needs, between a quarter and all of its
/// width.
/// \param room  in pixels, above and below: for words
Frame equal_frame(const Range& x, const Range& y, double room) {
  const Range across = x.with_air(0.1);
  Range up = y.with_air(0.12);
  const double wide = right - left;
  double scale = wide / std::max(across.high - across.low, 1e-12);
  up = {up.low - room / scale, up.high + room / scale};
  const double tall = std::clamp(scale * (up.high - up.low), wide / 4, wide);
  scale = std::min(scale, tall / std::max(up.high - up.low, 1e-12));
  const double middle_x = (across.low + across.high) / 2, middle_y = (up.low + up.high) / 2;
  const double half_x = wide / scale / 2, half_y = tall / scale / 2;
  return {Axis(middle_x - half_x, middle_x + half_x, left, right),
          Axis(middle_y - half_y, middle_y + half_y, top + tall, top), top + tall,
          top + tall + height - bottom};
}

Frame frame_of(const Chart& chart) {
  Range x, y;
  for (const Layer& layer : chart.layers) {
    for (const ChartPoint& point : layer.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      x.include(point.x);
      y.include(point.y);
    }
  }
  if (chart.y_range) y.include(chart.y_range->x), y.include(chart.y_range->y);
  constexpr double line_of_text = 14;
  if (chart.equal_axes) return equal_frame(x, y, chart.labels.empty() ? 0 : line_of_text);
  return linear_frame(chart, x, y);
}

/// Of thousands of points the lowest and the highest of each short stretch, in their order.
std::vector<ChartPoint> envelope(const std::vector<ChartPoint>& points) {
  constexpr std::size_t most = 1200;
  if (points.size() <= most) return points;
  std::vector<ChartPoint> kept;
  const std::size_t stretch = 2 * points.size() / most + 1;
  for (std::size_t from = 0; from < points.size(); from += stretch) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(stretch, points.size() - from));
    auto [low, high] =
        std::minmax_element(begin, end, [](const ChartPoint& a, const ChartPoint& b) { return a.y < b.y; });
    if (high < low) std::swap(low, high);
    kept.push_back(*low);
    if (high != low) kept.push_back(*high);
  }
  return kept;
}

std::string line(const Layer& layer, const Frame& frame) {
  std::string path;
  bool drawing = false;
  for (const ChartPoint& point : envelope(layer.points)) {
    const bool there = std::isfinite(point.x) && std::isfinite(point.y);
    if (there)
      path +=
          fmt::format("{}{:.1f} {:.1f}", drawing ? "L" : "M", frame.x.pixel(point.x), frame.y.pixel(point.y));
    drawing = there;
  }
  return path.empty() ? "" : fmt::format("<path class=\"line {}\" d=\"{}\"/>\n", layer.ink, path);
}

/// Dots as strokes of no length with round ends: one element however many.
std::string dots(const Layer& layer, const Frame& frame) {
  std::string path;
  for (const ChartPoint& point : envelope(layer.points))
    if (std::isfinite(point.x) && std::isfinite(point.y))
      path += fmt::format("M{:.1f} {:.1f}h0", frame.x.pixel(point.x), frame.y.pixel(point.y));
  return path.empty() ? ""
                      : fmt::format("<path class=\"dots {}\" stroke-width=\"{:.1f}\" d=\"{}\"/>\n", layer.ink,
                                    2 * layer.radius, path);
}

std::string rings(const Layer& layer, const Frame& frame) {
  std::string circles;
  for (const ChartPoint& point : layer.points)
    if (std::isfinite(point.x) && std::isfinite(point.y))
      circles += fmt::format("<circle class=\"ring {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n",
                             layer.ink, frame.x.pixel(point.x), frame.y.pixel(point.y), layer.radius);
  return circles;
}

/// Three heads along a line, each in the direction in which its points come.
std::string arrows(const Layer& layer, const Frame& frame) {
  constexpr double size = 6;
  std::vector<ChartPoint> way;
  double whole = 0;
  std::vector<double> so_far;
  for (const ChartPoint& point : layer.points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    const ChartPoint at{frame.x.pixel(point.x), frame.y.pixel(point.y)};
    if (!way.empty()) whole += std::hypot(at.x - way.back().x, at.y - way.back().y);
    way.push_back(at);
    so_far.push_back(whole);
  }
  std::string heads;
  for (const double share : {0.2, 0.5, 0.8}) {
    const auto next = std::upper_bound(so_far.begin(), so_far.end(), share * whole);
    if (next == so_far.begin() || next == so_far.end()) continue;
    const auto i = static_cast<std::size_t>(next - so_far.begin());
    const double dx = way[i].x - way[i - 1].x, dy = way[i].y - way[i - 1].y, step = std::hypot(dx, dy);
    const double u = size * dx / step, v = size * dy / step, x = way[i].x, y = way[i].y;
    heads += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z", x, y, x - u - v / 2, y - v + u / 2,
                         x - u + v / 2, y - v - u / 2);
  }
  return heads.empty() ? "" : fmt::format("<path class=\"arrow {}\" d=\"{}\"/>\n", layer.ink, heads);
}

/// "Fx −0.82 N"; "reading 7".
std::string value_text(const std::string& label, double value) {
  const std::size_t comma = label.rfind(", ");
  std::string number = fmt::format("{:.4g}", value);
  if (number.front() == '-') number.replace(0, 1, "\u2212");
  return comma == std::string::npos ? label + " " + number
                                    : label.substr(0, comma) + " " + number + " " + label.substr(comma + 2);
}

/// A place around each of at most so many points that says its values when it is pointed at.
std::string values(const Chart& chart, const Layer& layer, const Frame& frame) {
  constexpr std::size_t most = 100;
  const std::size_t stride = layer.points.size() / most + 1;
  std::string places;
  for (std::size_t i = 0; i < layer.points.size(); i += stride) {
    const ChartPoint& point = layer.points[i];
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    places += fmt::format(
        "<circle class=\"value\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{}, {}</title></circle>\n",
        frame.x.pixel(point.x), frame.y.pixel(point.y), escaped(value_text(chart.y_label, point.y)),
        escaped(value_text(chart.x_label, point.x)));
  }
  return places;
}

std::string strips(const Chart& chart, const Frame& frame) {
  std::string rectangles;
  const auto rectangle = [&](double x, double y, double w, double h, const std::string& ink) {
    rectangles +=
        fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                    ink, x, y, std::max(0.0, w), std::max(0.0, h));
  };
  for (const Strip& strip : chart.across) {
    const double a = std::clamp(frame.x.pixel(strip.from), left, right),
                 b = std::clamp(frame.x.pixel(strip.to), left, right);
    rectangle(a, top, b - a, frame.bottom - top, strip.ink);
    if (b - a > 6.5 * static_cast<double>(strip.word.size()))
      rectangles += fmt::format("<text x=\"{:.1f}\" y=\"{}\" class=\"word middle\">{}</text>\n", (a + b) / 2,
                                top - 3, escaped(strip.word));
  }
  for (const Strip& strip : chart.along) {
    const double a = std::clamp(frame.y.pixel(strip.to), top, frame.bottom),
                 b = std::clamp(frame.y.pixel(strip.from), top, frame.bottom);
    rectangle(left, a, right - left, b - a, strip.ink);
  }
  return rectangles;
}

std::string axes(const Chart& chart, const Frame& frame) {
  std::string text =
      fmt::format("<path class=\"axis\" d=\"M{0} {1}V{2:.1f}H{3}\"/>\n", left, top, frame.bottom, right);
  for (const Axis::Tick& tick : frame.y.ticks())
    text += fmt::format(
        "<path class=\"{}\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" class=\"end\">{}</text>\n",
        tick.text == "0" ? "zero" : "grid", left, tick.pixel, right, left - 5, tick.pixel + 4, tick.text);
  for (const Axis::Tick& tick : frame.x.ticks())
    text += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}v4\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "class=\"middle\">{3}</text>\n",
        tick.pixel, frame.bottom, frame.bottom + 16, tick.text);
  text += fmt::format("<text x=\"2\" y=\"12\" class=\"name\">{}</text>\n", escaped(chart.y_label));
  text += fmt::format("<text x=\"{}\" y=\"{:.1f}\" class=\"name end\">{}</text>\n", right, frame.bottom + 30,
                      escaped(chart.x_label));
  return text;
}

std::string labels(const Chart& chart, const Frame& frame) {
  std::string text;
  for (const ChartLabel& label : chart.labels) {
    const double aside = label.towards.x * label.distance, up = label.towards.y * label.distance;
    const char* const anchor = label.towards.x > 0.5 ? "" : label.towards.x < -0.5 ? " end" : " middle";
    const double drop = label.towards.y < -0.5 ? 9 : label.towards.y > 0.5 ? 0 : 4;  // of the line of text
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"label{}\">{}</text>\n",
                        std::max(left + 28, frame.x.pixel(label.at.x) + aside),
                        frame.y.pixel(label.at.y) - up + drop, anchor, escaped(label.text));
  }
  return text;
}

}  // namespace

std::string drawn(const Chart& chart) {
  const Frame frame = frame_of(chart);
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-labelledby=\"{}-title {}-desc\">\n<title "
      "id=\"{}-title\">{}</title>\n"
      "<desc id=\"{}-desc\">{}</desc>\n",
      width, frame.height, chart.id, chart.id, chart.id, escaped(chart.title), chart.id,
      escaped(chart.description));
  svg += strips(chart, frame) + axes(chart, frame);
  for (const Layer& layer : chart.layers) {
    switch (layer.kind) {
      case Layer::Kind::line:
        svg += line(layer, frame);
        if (layer.directed) svg += arrows(layer, frame);
        break;
      case Layer::Kind::dots:
        svg += dots(layer, frame);
        break;
      case Layer::Kind::rings:
        svg += rings(layer, frame);
        break;
    }
  }
  svg += labels(chart, frame);
  for (const Layer& layer : chart.layers)
    if (layer.told) svg += values(chart, layer, frame);
  return svg + "</svg>\n";
}

}  // namespace plumbline::page
