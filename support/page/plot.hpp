#pragma once
/// \file
/// Line drawings as SVG, by gnuplot.

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::page {

struct Curve {
  std::vector<std::pair<double, double>> points;
  int colour = 1;       ///< index into a palette that colour-blind eyes can tell apart
  bool dashed = false;  ///< unstable
  std::string title;    ///< in the key; none when empty
  double width = 1.6;
};

struct Mark {
  double x, y;
  std::string label;
  int symbol = 7;  ///< gnuplot's point type: 7 filled circle, 6 open circle, 9 triangle
};

/// One diagram; several stand side by side.
struct Panel {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  std::string extra;  ///< further gnuplot commands before the plot, such as ranges
  bool equal_axes = false;
  /// Contour lines below the curves: (x, y, z) row by row, `surface_rows` rows; z may be NaN.
  std::vector<std::array<double, 3>> surface = {};
  std::size_t surface_rows = 0;
};

/// The drawing as SVG text; one row of panels each `columns` panels.
/// \throws Error when gnuplot is missing or fails
std::string as_svg(const std::vector<Panel>& panels, std::size_t columns);

}  // namespace plumbline::page
