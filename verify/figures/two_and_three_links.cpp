#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "proofs/paths/followed_path.hpp"
#include "verify/figures/branch_curves.hpp"
#include "verify/figures/figures.hpp"

namespace plumbline::verify {
namespace {

using std::numbers::pi;

// --- two links (1) to (3), k = L = 1: F(q) = 2 q / sin(alpha + q), deflection 2 (cos alpha - cos(alpha + q))

double force_of(double alpha, double q) {
  return std::abs(alpha + q) < 1e-9 ? 2 : 2 * q / std::sin(alpha + q);
}
double deflection_of(double alpha, double q) {
  return 2 * (std::cos(alpha) - std::cos(alpha + q));
}

page::Panel two_links_force(double alpha) {
  page::Panel panel{"force", "deflection Δ / L", "F L / k", {}, {}, "set yrange [0:6]", false};
  page::Curve curve;
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

page::Panel two_links_energy(double alpha, const std::vector<double>& forces) {
  page::Panel panel{"potential energy V = U - F Δ", "deflection Δ / L", "V / k", {}, {}, "", false};
  int colour = 1;
  for (const double F : forces) {
    page::Curve curve{{}, colour++, false, fmt::format("F = {:g} k/L", F), 1.6};
    std::pair<double, double> least{0, 1e9};
    for (double q = 0; alpha + q < 2.5; q += 0.005) {
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

proofs::PathTask three_links(double alpha1, double alpha2, double last) {
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

/// U or Z by the bends of joints 2 and 3, with the paper's sign: of U by the bends, of Z by the first angle;
/// shapes that are pulled, not compressed, are named so.
std::string letter(const BranchPoint<double>& p) {
  const std::vector<double> q = joint_angles(p.theta);
  const bool arch = (q[1] > 0) == (q[2] > 0);
  const bool plus = arch ? q[1] < 0 : q[0] > 0;
  return std::string(arch ? "U" : "Z") + (plus ? "^+" : "^-") +
         (p.load > 0 && p.force.x > 0 ? " pulled" : "");
}

/// The shape along a branch: its letter, and where it becomes another one.
std::string letters(const Branch<double>& branch) {
  const std::string last = letter(branch.points.back());
  const auto other = std::find_if(branch.points.rbegin(), branch.points.rend(),
                                  [&](const auto& p) { return p.load > 1e-3 && letter(p) != last; });
  if (other == branch.points.rend()) return last;
  const auto next = other.base();  // the first point that has the last letter
  return fmt::format("{}, from {:.2f} on {}", letter(*other), next->load, last);
}

void add_report(page::Panel& panel, const proofs::PathReport& report, int first_colour) {
  int colour = first_colour;
  for (const auto& branch : report.branches) {
    add_curves(panel.curves, branch, colour++, deflection, compression, letters(branch));
    for (const auto& event : branch.events)
      panel.marks.push_back({event.point.load, -event.point.force.x, std::string(name(event.kind)),
                             event.kind == EventKind::quasi_buckling ? 6 : 7});
  }
}

page::Panel force_panel(const std::string& title, const proofs::PathReport& report,
                        const std::string& extra) {
  page::Panel panel{title, "deflection Δ / L", "compression F L / k", {}, {}, extra, false};
  add_report(panel, report, 1);
  return panel;
}

page::Panel shapes_panel(const std::string& title, const Chain<double>& chain,
                         const std::vector<BranchPoint<double>>& points) {
  page::Panel panel{title, "x / L", "y / L", {}, {}, "set key below", true};
  int colour = 1;
  for (const auto& p : points)
    panel.curves.push_back({outline(chain, p.theta), colour++, p.negative_directions > 0,
                            fmt::format("{} Δ = {:.3g}", letter(p), p.load), 2.4});
  return panel;
}

}  // namespace

std::vector<page::Panel> draw_figure_2() {
  return {two_links_force(0), two_links_energy(0, {1, 2, 2.5, 3})};
}

std::vector<page::Panel> draw_figure_3() {
  return {two_links_force(pi / 6), two_links_energy(pi / 6, {0.5, 1, 2, 3})};
}

std::vector<page::Panel> draw_figure_4() {
  const double phi = 0.5, alpha1 = -0.35, alpha2 = -0.5;
  const Chain<double> chain({1, 1, 1}, {0, 1, 1}, {phi, alpha1, alpha2});
  page::Panel panel{"three links, passive joints at the base and at the end point", "x / L", "y / L", {}, {},
                    "set key off\nset xrange [-0.4:4]\nset yrange [-0.3:1.3]",      true};
  panel.curves.push_back({outline(chain, absolute_angles(chain.rest())), 1, false, "", 3});
  const auto joints = panel.curves[0].points;
  const char* const labels[] = {"φ, passive", "α_1 + q_1, k", "", "(x, y), force F"};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool passive = i == 0 || i + 1 == joints.size();
    panel.marks.push_back({joints[i].first, joints[i].second, labels[i], passive ? 6 : 7});
    if (i == 2) panel.marks.push_back({joints[i].first - 0.2, joints[i].second + 0.3, "α_2 + q_2, k", 0});
    if (i > 0 && i + 1 < joints.size()) {  // the link before, continued: the joint angle is counted from it
      const auto [x, y] = joints[i];
      const double dx = x - joints[i - 1].first, dy = y - joints[i - 1].second;
      panel.curves.push_back({{{x, y}, {x + 0.4 * dx, y + 0.4 * dy}}, 7, true, "", 1});
    }
  }
  panel.curves.push_back({{{-0.4, 0}, {4, 0}}, 7, false, "", 1});
  return {panel};
}

std::vector<page::Panel> draw_figure_5() {
  page::Panel straight =
      force_panel("straight: both U coincide, and both Z", proofs::follow_all(three_links(0, 0, 1)),
                  "set yrange [0:6]\nset xrange [-0.05:1]");
  straight.curves.push_back({{{0, 0}, {0, 1}}, 0, false, "straight shape", 1.6});  // (16): stable up to k / L
  straight.curves.push_back({{{0, 1}, {0, 6}}, 0, true, "", 1.6});
  const auto nearly = proofs::follow_all(three_links(-0.05, -0.05, 1));
  return {straight,
          force_panel("quasi-straight, α_1 = α_2 = -0.05", nearly, "set yrange [0:6]\nset xrange [-0.05:1]")};
}

std::vector<page::Panel> draw_figure_6() {
  const proofs::PathTask task = three_links(0, 0, 0.6);
  std::vector<page::Panel> panels;
  const proofs::PathReport report = proofs::follow_all(task);
  for (const auto& branch : report.branches) {
    std::vector<BranchPoint<double>> shapes;
    for (const double load : {0.05, 0.2, 0.4, 0.6}) shapes.push_back(proofs::state_at(task, branch, load));
    panels.push_back(shapes_panel(branch.points.back().negative_directions == 0 ? "stable" : "unstable",
                                  task.chain, shapes));
  }
  return panels;
}

std::vector<page::Panel> draw_figure_7() {
  const proofs::PathTask task = three_links(-pi / 4, -pi / 3, 1);
  const proofs::PathReport report = proofs::follow_all(task);
  std::vector<BranchPoint<double>> last;
  for (const auto& branch : report.branches) last.push_back(branch.points.back());
  page::Panel shapes = shapes_panel("shapes at the ends of the branches", task.chain, last);
  shapes.extra = "set key rmargin";  // below, it would lie on the axis title
  return {force_panel("α = (-π/4, -π/3)", report, "set yrange [-6:6]\nset key bottom right"), shapes};
}

std::vector<page::Panel> draw_figure_8() {
  proofs::PathTask task = three_links(pi / 10, -pi / 10, 0.6);
  task.step = 0.01;
  const proofs::PathReport slow = proofs::follow_slowly(task), all = proofs::follow_all(task);
  std::vector<BranchPoint<double>> shapes;
  for (const double load : {0.0, 0.0407353, 0.1, 0.256, 0.6})
    shapes.push_back(proofs::state_at(task, slow.branches, load));
  return {force_panel("the slowly loaded chain, α = (π/10, -π/10)", slow, "set key bottom right"),
          force_panel("every branch", all, "set yrange [0:4]\nset key bottom right"),
          shapes_panel("shapes", task.chain, shapes)};
}

std::vector<page::Panel> draw_figure_9() {
  // E(phi) with both elbows of (9); the state of the slowly loaded chain is marked
  proofs::PathTask task = three_links(pi / 10, -pi / 10, 0.6);
  task.step = 0.01;
  const proofs::PathReport slow = proofs::follow_slowly(task);
  std::vector<page::Panel> panels;
  for (const double load : {0.01, 0.0407353, 0.06, 0.15, 0.3, 0.55}) {
    const BranchPoint<double> state = proofs::state_at(task, slow.branches, load);
    const std::string range = fmt::format("set yrange [{:.4f}:{:.4f}]\nset key top center",
                                          state.energy - 0.1 * load, state.energy + 0.002 + 1.5 * load);
    page::Panel panel{fmt::format("Δ = {:.4g} L, dot: the slowly loaded chain", load),
                      "φ [rad]",
                      "E / k",
                      {},
                      {},
                      range,
                      false};
    const double x = task.loading.start.x - load;
    for (const int elbow : {1, -1}) {
      page::Curve curve{{}, elbow > 0 ? 1 : 2, false, elbow > 0 ? "q_3 bends left" : "q_3 bends right", 1.6};
      const double widest = std::acos((x * x - 3) / (2 * x));  // links 2 and 3 stretched
      constexpr int steps = 160;
      for (int step = 0; step <= steps; ++step) {
        const double phi = widest * std::sin(pi * (static_cast<double>(step) / steps - 0.5)),
                     dx = x - std::cos(phi), dy = -std::sin(phi);
        const double c = std::min(1.0, (dx * dx + dy * dy - 2) / 2), q3 = elbow * std::acos(c);
        const double q2 = std::remainder(std::atan2(dy, dx) - std::atan2(std::sin(q3), 1 + c) - phi, 2 * pi);
        curve.points.emplace_back(phi, (std::pow(q2 - pi / 10, 2) + std::pow(q3 + pi / 10, 2)) / 2);
      }
      panel.curves.push_back(curve);
    }
    panel.marks.push_back({state.theta(0), state.energy, ""});
    panels.push_back(panel);
  }
  return panels;
}

}  // namespace plumbline::verify
