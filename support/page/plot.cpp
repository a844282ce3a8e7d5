#include "support/page/plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <plumbline/base/error.hpp>

#include "support/files/child_process.hpp"
#include "support/files/printable.hpp"
#include "support/page/compact_svg.hpp"

namespace plumbline::page {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == ' ')
      result += "\u00a0";  // gnuplot drops an ordinary space behind an index
    else
      result += c;
  }
  return result + "\"";
}

const char* const palette[] = {"#000000", "#0072b2", "#d55e00", "#009e73",
                               "#cc79a7", "#e69f00", "#56b4e9", "#999999"};

std::string colour(int index) {
  return palette[static_cast<std::size_t>(index) % std::size(palette)];
}

/// Where words no longer fit to the right of a point.
double right_part(const std::vector<Curve>& curves) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : curves)
    for (const auto& [x, y] : curve.points) low = std::min(low, x), high = std::max(high, x);
  return low + 0.75 * (high - low);
}

/// Contour lines, which gnuplot computes from the grid.
void add_contours(std::string& script, const Panel& panel) {
  script += "$grid << END\n";
  const std::size_t columns = panel.surface.size() / panel.surface_rows;
  for (std::size_t i = 0; i < panel.surface.size(); ++i) {
    const auto& [x, y, z] = panel.surface[i];
    script += fmt::format("{:.6g} {:.6g} {:.6g}\n", x, y, z);
    if ((i + 1) % columns == 0) script += "\n";
  }
  script +=
      "END\nset contour base\nunset surface\nset cntrparam levels auto 24\nset table $contours\n"
      "splot $grid using 1:2:3\nunset table\nunset contour\nset surface\n";
}

void add_panel(std::string& script, const Panel& panel) {
  script += fmt::format("set title {} font ',13'\nset xlabel {}\nset ylabel {}\n", quoted(panel.title),
                        quoted(panel.x_label), quoted(panel.y_label));
  script += panel.equal_axes ? "set size ratio -1\n" : "set size noratio\n";
  script += "unset label\nunset logscale\nset key on top left\nset autoscale\n" + panel.extra + "\n";
  std::string data, plots;
  if (!panel.surface.empty()) {
    add_contours(script, panel);
    plots = "plot $contours using 1:2:3 with lines lc palette lw 0.8 notitle";
  }
  for (const Curve& curve : panel.curves) {
    plots += fmt::format("{}'-' with lines lc rgb '{}' lw {} dt {} {}", plots.empty() ? "plot " : ", ",
                         colour(curve.colour), curve.width, curve.dashed ? "(6,5)" : "1",
                         curve.title.empty() ? "notitle" : "title " + quoted(curve.title));
    for (const auto& [x, y] : curve.points) data += fmt::format("{:.9g} {:.9g}\n", x, y);
    data += "e\n";
  }
  const double most_of_width = right_part(panel.curves);
  for (const Mark& mark : panel.marks) {
    plots += fmt::format("{}'-' with points pt {} ps 0.6 lc rgb '#d00000' notitle",
                         plots.empty() ? "plot " : ", ", mark.symbol);
    data += fmt::format("{:.9g} {:.9g}\ne\n", mark.x, mark.y);
    if (mark.label.empty()) continue;
    const bool before = mark.x > most_of_width;
    script += fmt::format("set label {} at {:.9g},{:.9g} {} offset {},-0.7 font ',11' front\n",
                          quoted(mark.label), mark.x, mark.y, before ? "right" : "left", before ? -0.7 : 0.7);
  }
  script += plots + "\n" + data;
}

std::string drawn(const std::string& script) {
  unsetenv("GNUTERM");  // a terminal that gnuplot does not know would end it
  const files::Ended gnuplot = files::run_program({"gnuplot", "--default-settings", "-"}, script);
  const std::string expected = "a drawing (the program comes with the package gnuplot-nox)";
  if (!gnuplot.failure.empty()) {
    const std::string why = files::shown(gnuplot.err.substr(0, gnuplot.err.find('\n')));
    throw Error("gnuplot", gnuplot.failure + (why.empty() ? "" : ": " + why), expected);
  }
  const std::size_t end = gnuplot.out.find_last_not_of('\n');
  if (end == std::string::npos || !std::string_view(gnuplot.out).substr(0, end + 1).ends_with("</svg>"))
    throw Error("gnuplot", "a drawing that breaks off", expected);
  return compact_svg(gnuplot.out) + "\n";
}

}  // namespace

std::string as_svg(const std::vector<Panel>& panels, std::size_t columns) {
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  std::string script = fmt::format(
      "set encoding utf8\nset terminal svg size {},{} enhanced font 'Helvetica,12' background rgb "
      "'white'\n"
      "set palette defined (0 '#08306b', 1 '#9ecae1')\nunset colorbox\nset grid lc rgb '#dddddd' dt 1\nset "
      "border lc rgb '#444444'\nset key top left samplen 2\n"
      "set multiplot layout {},{}\n",
      520 * columns, 400 * rows, rows, columns);
  for (const Panel& panel : panels) add_panel(script, panel);
  script += "unset multiplot\n";
  return drawn(script);
}

}  // namespace plumbline::page
