#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "app/figures.hpp"
#include "app/path_report.hpp"

namespace plumbline {
namespace {

constexpr double pi = std::numbers::pi;

// --- two links (1) to (3), k = L = 1: F(q) = 2 q / sin(alpha + q), deflection 2 (cos alpha - cos(alpha + q))

double force_of(double alpha, double q) {
  return std::abs(alpha + q) < 1e-9 ? 2 : 2 * q / std::sin(alpha + q);
}
double deflection_of(double alpha, double q) {
  return 2 * (std::cos(alpha) - std::cos(alpha + q));
}

Panel two_links_force(double alpha) {
  Panel panel{"force", "deflection {/Symbol D} / L", "F L / k", {}, {}, "set yrange [0:6]", false};
  Curve curve;
  for (double q = 0; alpha + q < 2.2; q += 0.01)
    curve.points.emplace_back(deflection_of(alpha, q), force_of(alpha, q));
  panel.curves.push_back(curve);
  if (alpha == 0) {
    panel.curves.push_back({{{0, 0}, {0, 2}}, 1, false, "", 1.6});
    panel.curves.push_back({{{0, 2}, {0, 6}}, 1, true, "", 1.6});
    panel.marks.push_back({0, 2, "F_c = 2 k / L"});
  }
  return panel;
}

Panel two_links_energy(double alpha, const std::vector<double>& forces) {
  Panel panel{
      "potential energy V = U - F {/Symbol D}", "deflection {/Symbol D} / L", "V / k", {}, {}, "", false};
  int colour = 1;
  for (const double F : forces) {
    Curve curve{{}, colour++, false, fmt::format("F = {:g} k/L", F), 1.6};
    std::pair<double, double> least{0, 1e9};
    for (double q = 0; alpha + q < 1.9; q += 0.005) {
      const double d = deflection_of(alpha, q), V = 2 * q * q - F * d;
      curve.points.emplace_back(d, V);
      if (V < least.second) least = {d, V};
    }
    panel.curves.push_back(curve);
    panel.marks.push_back({least.first, least.second, ""});
  }
  return panel;
}

// --- three links with a passive base, k = L = 1, the end point on the x axis

PathTask three_links(double alpha1, double alpha2, double last) {
  std::vector<double> rest{0, alpha1, alpha2};
  const Chain<double> shape({1, 1, 1}, {0, 1, 1}, rest);
  const Point<double> p = end_point(shape, rest);
  rest[0] = -std::atan2(p.y, p.x);
  const double reach = std::hypot(p.x, p.y);
  return {
      Chain<double>({1, 1, 1}, {0, 1, 1}, rest), {Control::end_point, {reach, 0}, {-1, 0}}, last, 0.03, 1};
}

double compression(const BranchPoint<double>& p) {
  return -p.force.x;
}
double deflection(const BranchPoint<double>& p) {
  return p.load;
}

/// U or Z by the bends of joints 2 and 3, with the sign of the middle link's side.
std::string letter(const BranchPoint<double>& p) {
  const std::vector<double> q = joint_angles(p.theta);
  const bool arch = (q[1] > 0) == (q[2] > 0);
  return std::string(arch ? "U" : "Z") + ((arch ? q[1] < 0 : q[1] > 0) ? "^+" : "^-");
}

void add_report(Panel& panel, const PathReport& report, int first_colour) {
  int colour = first_colour;
  for (const auto& branch : report.branches) {
    add_curves(panel.curves, branch, colour++, deflection, compression, letter(branch.points.back()));
    for (const auto& event : branch.events)
      panel.marks.push_back({event.point.load, -event.point.force.x, std::string(name(event.kind)),
                             event.kind == EventKind::quasi_buckling ? 6 : 7});
  }
}

Panel force_panel(const std::string& title, const PathReport& report, const std::string& extra) {
  Panel panel{title, "deflection {/Symbol D} / L", "compression F L / k", {}, {}, extra, false};
  add_report(panel, report, 1);
  return panel;
}

Panel shapes_panel(const std::string& title, const Chain<double>& chain,
                   const std::vector<BranchPoint<double>>& points) {
  Panel panel{title, "x / L", "y / L", {}, {}, "", true};
  int colour = 1;
  for (const auto& p : points)
    panel.curves.push_back({outline(chain, p.theta), colour++, p.negative_directions > 0,
                            fmt::format("{} {{/Symbol D}} = {:.3g}", letter(p), p.load), 2.4});
  return panel;
}

}  // namespace

std::vector<Panel> draw_figure_2() {
  return {two_links_force(0), two_links_energy(0, {1, 2, 2.5, 3})};
}

std::vector<Panel> draw_figure_3() {
  return {two_links_force(pi / 6), two_links_energy(pi / 6, {0.5, 1, 2, 3})};
}

std::vector<Panel> draw_figure_5() {
  const auto straight = follow_all(three_links(0, 0, 1));
  const auto nearly = follow_all(three_links(-0.05, -0.05, 1));
  return {force_panel("straight", straight, "set yrange [0:6]"),
          force_panel("quasi-straight, {/Symbol a}_1 = {/Symbol a}_2 = -0.05", nearly, "set yrange [0:6]")};
}

std::vector<Panel> draw_figure_6() {
  const PathTask task = three_links(0, 0, 0.6);
  std::vector<Panel> panels;
  const PathReport report = follow_all(task);
  for (const auto& branch : report.branches) {
    const std::size_t n = branch.points.size();
    panels.push_back(shapes_panel(branch.points[n / 2].negative_directions == 0 ? "stable" : "unstable",
                                  task.chain,
                                  {branch.points[n / 8], branch.points[n / 2], branch.points[n - 1]}));
  }
  return panels;
}

std::vector<Panel> draw_figure_7() {
  const PathTask task = three_links(-pi / 4, -pi / 3, 1);
  const PathReport report = follow_all(task);
  std::vector<BranchPoint<double>> last;
  for (const auto& branch : report.branches) last.push_back(branch.points.back());
  return {force_panel("{/Symbol a} = (-{/Symbol p}/4, -{/Symbol p}/3)", report, "set yrange [-6:6]"),
          shapes_panel("shapes at the ends of the branches", task.chain, last)};
}

std::vector<Panel> draw_figure_8() {
  const PathTask task = three_links(pi / 10, -pi / 10, 0.6);
  const PathReport slow = follow_slowly(task), all = follow_all(task);
  std::vector<BranchPoint<double>> shapes;
  for (const auto& stretch : slow.branches) {
    shapes.push_back(stretch.points.front());
    shapes.push_back(stretch.points.back());
  }
  return {force_panel("the slowly loaded chain, {/Symbol a} = ({/Symbol p}/10, -{/Symbol p}/10)", slow, ""),
          force_panel("every branch", all, "set yrange [0:4]"), shapes_panel("shapes", task.chain, shapes)};
}

std::vector<Panel> draw_figure_9() {
  // E(phi) with both elbows of (9); the stable state of the slowly loaded chain is marked
  const PathTask task = three_links(pi / 10, -pi / 10, 0.6);
  const PathReport slow = follow_slowly(task);
  std::vector<Panel> panels;
  for (const double load : {0.01, 0.0407353, 0.06, 0.15, 0.3, 0.55}) {
    Panel panel{fmt::format("{{/Symbol D}} = {:.4g} L", load),
                "{/Symbol j} [rad]",
                "E / k",
                {},
                {},
                "set xrange [-1.2:1.2]\nset yrange [0:2.5]\nset key top center",
                false};
    const double x = task.loading.start.x - load, reference = pi / 10;
    for (const int elbow : {1, -1}) {
      Curve curve{{}, elbow > 0 ? 1 : 2, false, elbow > 0 ? "q_3 bends left" : "q_3 bends right", 1.6};
      for (double phi = -1.2; phi < 1.2; phi += 0.004) {
        const double dx = x - std::cos(phi), dy = -std::sin(phi), c = (dx * dx + dy * dy - 2) / 2;
        if (std::abs(c) > 1) continue;
        const double q3 = elbow * std::acos(c);
        const double q2 = std::remainder(std::atan2(dy, dx) - std::atan2(std::sin(q3), 1 + c) - phi, 2 * pi);
        curve.points.emplace_back(phi, (std::pow(q2 - reference, 2) + std::pow(q3 + reference, 2)) / 2);
      }
      panel.curves.push_back(curve);
    }
    const BranchPoint<double>* nearest = nullptr;
    for (const auto& stretch : slow.branches) {
      for (const auto& p : stretch.points) {
        if (nearest == nullptr || std::abs(p.load - load) < std::abs(nearest->load - load)) nearest = &p;
      }
    }
    panel.marks.push_back({nearest->theta(0), nearest->energy, "state"});
    panels.push_back(panel);
  }
  return panels;
}

}  // namespace plumbline
