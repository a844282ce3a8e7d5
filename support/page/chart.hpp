#pragma once
/// \file
/// Small line charts as SVG, for pages: no size of their own, no script, colours by the page's style sheet.

#include <optional>
#include <string>
#include <vector>

namespace plumbline::page {

/// In the units of the axes; a NaN interrupts a line.
struct ChartPoint {
  double x, y;
};

/// One curve or cloud of points. `ink` is a class of the style sheet: measured, nominal, corrected, ...
struct Layer {
  enum class Kind { line, dots, rings } kind;
  std::string ink;
  std::vector<ChartPoint> points;
  double radius = 1.6;    ///< of dots and rings, in the chart's pixels
  bool directed = false;  ///< a line with heads of arrows along it
  bool told = false;      ///< a point says its values to who points at it
};

/// A strip across the whole height, or the whole width, behind the curves. Its word stands in it if it fits.
struct Strip {
  double from, to;
  std::string ink, word = {};
};

struct ChartLabel {
  ChartPoint at;
  std::string text;
  double distance = 9;          ///< from the point, in the chart's pixels
  ChartPoint towards = {0, 1};  ///< a unit vector, y up
};

struct Chart {
  std::string id;           ///< unique in the page
  std::string title;        ///< for those who do not see it
  std::string description;  ///< what there is to see, in a sentence
  std::string x_label, y_label;
  std::vector<Layer> layers;
  std::vector<Strip> across = {}, along = {};  ///< of abscissae, of ordinates
  std::vector<ChartLabel> labels = {};
  bool signed_log = false;  ///< ordinates linear near zero and logarithmic beyond, of either sign
  bool equal_axes = false;  ///< a drawing in space: one scale for both
  std::optional<ChartPoint> y_range = {};  ///< at least this much, from x to y
};

/// \returns an <svg> element. Of a curve with thousands of points those are drawn that show its envelope.
std::string drawn(const Chart& chart);

}  // namespace plumbline::page
