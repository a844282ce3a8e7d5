#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "proofs/census/census.hpp"
#include "proofs/paths/followed_path.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/figures/branch_curves.hpp"
#include "verify/figures/figures.hpp"

namespace plumbline::verify {
namespace {

using std::numbers::pi;

Chain<double> four_links(std::vector<double> rest) {
  return Chain<double>({1, 1, 1, 1}, {1, 1, 1, 1}, std::move(rest));
}
const std::vector<double> u_rest{-0.3179, 0.0558, 0.3804, 0.3524}, z_rest{-0.2417, 0.6821, -0.7958, 0.5170};

proofs::PathTask compressed(const Chain<double>& chain, double reach, double last) {
  return {chain, {Control::end_point, {reach, 0}, {-1, 0}}, last, 0.03, 1};
}

/// Contours of the root of E(q1, q2), with q3, q4 from the closure, on the sheet of the elbow that has the
/// given sign of q4, and the certified equilibria there.
page::Panel energy_surface(const Chain<double>& chain, double x, int elbow, const std::string& title) {
  page::Panel panel{title, "q_1 [rad]", "q_2 [rad]", {}, {}, "set xrange [-1.6:1.6]\nset yrange [-2.2:2.2]",
                    false};
  constexpr int steps = 80;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const double q1 = -1.6 + 3.2 * i / steps, q2 = -2.2 + 4.4 * j / steps, turned = q1 + q2;
      const double dx = x - std::cos(q1) - std::cos(turned), dy = -std::sin(q1) - std::sin(turned);
      const double c = (dx * dx + dy * dy - 2) / 2;
      double energy = std::nan("");
      if (std::abs(c) <= 1) {
        const double q4 = elbow * std::acos(c);
        const double q3 =
            std::remainder(std::atan2(dy, dx) - std::atan2(std::sin(q4), 1 + c) - turned, 2 * pi);
        const double q[] = {q1, q2, q3, q4};
        energy = 0;
        for (std::size_t l = 0; l < 4; ++l) energy += std::pow(q[l] - chain.rest()[l], 2) / 2;
      }
      panel.surface.push_back({q1, q2, std::sqrt(energy)});  // even steps of the root show shallow minima
    }
  }
  panel.surface_rows = steps + 1;
  const auto exact = [](double v) { return Interval::from_double(v); };
  const proofs::Census census =
      proofs::census_at_end_point(convert<Interval>(chain, exact), {exact(x), Interval(0)});
  for (const auto& one : census.equilibria) {
    const auto angle = [&](std::size_t l) {
      return std::remainder(static_cast<double>(one.q[l].middle()), 2 * pi);
    };
    if ((angle(3) > 0) != (elbow > 0)) continue;
    const std::size_t negative = one.negative_directions.value_or(9);
    panel.marks.push_back({angle(0), angle(1),
                           negative == 0   ? "min"
                           : negative == 1 ? "saddle"
                                           : "max",
                           negative == 0   ? 7
                           : negative == 1 ? 9
                                           : 6});
  }
  return panel;
}

page::Panel shapes_at(const Chain<double>& chain, double x) {
  page::Panel panel{"all equilibria", "x / L", "y / L", {}, {}, "set key below", true};
  const auto exact = [](double v) { return Interval::from_double(v); };
  const proofs::Census census =
      proofs::census_at_end_point(convert<Interval>(chain, exact), {exact(x), Interval(0)});
  int colour = 1;
  for (const auto& one : census.equilibria) {
    std::vector<double> q;
    for (const Interval& angle : one.q) q.push_back(static_cast<double>(angle.middle()));
    panel.curves.push_back({outline(chain, absolute_angles(q)), colour++,
                            one.negative_directions.value_or(9) > 0,
                            fmt::format("E = {:.4f} k", static_cast<double>(one.energy.middle())), 2.4});
  }
  return panel;
}

std::vector<page::Panel> force_curves(const Chain<double>& chain) {
  const proofs::PathTask task = compressed(chain, 3.8, 1.5);
  const proofs::PathReport slow = proofs::follow_slowly(task);
  page::Panel along{"F_x, compression positive", "δ_x / L", "F_x L / k", {}, {}, "", false};
  page::Panel across{"F_y of (6)", "δ_x / L", "F_y L / k", {}, {}, "", false};
  page::Panel stiffness{"tangent stiffness", "δ_x / L", "dF_x/dδ_x L^2 / k", {}, {}, "set logscale y", false};
  page::Panel shapes{"shapes", "x / L", "y / L", {}, {}, "set key below", true};
  const auto load = [](const BranchPoint<double>& p) { return p.load; };
  for (const auto& stretch : slow.branches) {
    add_curves(
        along.curves, stretch, 1, load, [](const auto& p) { return paper_force(p).x; }, "");
    add_curves(
        across.curves, stretch, 1, load, [](const auto& p) { return paper_force(p).y; }, "");
    add_curves(
        stiffness.curves, stretch, 1, load, [](const auto& p) { return p.stiffness; }, "");
    for (const auto& event : stretch.events) {
      along.marks.push_back({event.point.load, paper_force(event.point).x, std::string(name(event.kind))});
      stiffness.marks.push_back({event.point.load, event.point.stiffness, std::string(name(event.kind))});
    }
    int colour = 1;
    for (const double at : {0.0, 0.1, 0.4, 0.8, 1.5}) {
      const BranchPoint<double> p = proofs::state_at(task, stretch, at);
      shapes.curves.push_back(
          {outline(chain, p.theta), colour++, false, fmt::format("δ_x = {:.2g} L", p.load), 2.4});
    }
  }
  return {along, across, stiffness, shapes};
}

}  // namespace

std::vector<page::Panel> draw_figure_10() {
  std::vector<page::Panel> panels;
  for (const auto& [name, rest] : {std::pair{"U-shape", u_rest}, {"Z-shape", z_rest}}) {
    const Chain<double> chain = four_links(rest);
    page::Panel panel{fmt::format("{}: q = ({:.4f})", name, fmt::join(rest, ", ")), "x / L", "y / L", {}, {},
                      "set key off\nset xrange [-0.2:4.8]\nset yrange [-1:0.6]",    true};
    panel.curves.push_back({outline(chain, absolute_angles(chain.rest())), 1, false, "", 3});
    const auto joints = panel.curves[0].points;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const bool end = i == rest.size();
      panel.marks.push_back({joints[i].first, joints[i].second, end ? "(x_0, y_0)" : "", end ? 6 : 7});
    }
    panels.push_back(panel);
  }
  return panels;
}

std::vector<page::Panel> draw_figure_11() {
  const auto chain = four_links(u_rest);
  return {energy_surface(chain, 3.4, 1, "E(q_1, q_2), U-shape, q_4 > 0"),
          energy_surface(chain, 3.4, -1, "the other sheet, q_4 < 0"), shapes_at(chain, 3.4)};
}

std::vector<page::Panel> draw_figure_12() {
  return force_curves(four_links(u_rest));
}

std::vector<page::Panel> draw_figure_13() {
  const auto chain = four_links(z_rest);
  return {energy_surface(chain, 3.4, 1, "E(q_1, q_2), Z-shape, q_4 > 0"),
          energy_surface(chain, 3.4, -1, "the other sheet, q_4 < 0"), shapes_at(chain, 3.4)};
}

std::vector<page::Panel> draw_figure_14() {
  return force_curves(four_links(z_rest));
}

std::vector<page::Panel> draw_figure_15() {
  const auto chain = four_links({0, 0, 0, 0});
  std::vector<page::Panel> panels;
  const proofs::PathTask task = compressed(chain, 4, 0.6);
  const proofs::PathReport all = proofs::follow_all(task);
  for (const auto& branch : all.branches) {
    const std::vector<double> q = joint_angles(branch.points.back().theta);
    const bool same[] = {(q[1] > 0) == (q[2] > 0), (q[2] > 0) == (q[3] > 0)};
    const char* const shape = same[0] && same[1] ? "U" : same[0] ? "ZU" : same[1] ? "?" : "Z";  // Table 3
    page::Panel panel{fmt::format("{}-shape, {}", shape,
                                  branch.points.back().negative_directions == 0 ? "stable" : "unstable"),
                      "x / L",
                      "y / L",
                      {},
                      {},
                      "set key below",
                      true};
    int colour = 1;
    for (const double at : {0.05, 0.2, 0.4, 0.6}) {
      const BranchPoint<double> p = proofs::state_at(task, branch, at);
      panel.curves.push_back({outline(chain, p.theta), colour++, p.negative_directions > 0,
                              fmt::format("δ_x = {:.2g} L", p.load), 2.4});
    }
    panels.push_back(panel);
  }
  return panels;
}

std::vector<page::Panel> draw_figure_16() {
  const auto chain = four_links({0, 0, 0, 0});
  return {energy_surface(chain, 3.5, 1, "E(q_1, q_2), straight, δ_x = 0.5 L, q_4 > 0"),
          energy_surface(chain, 3.5, -1, "the other sheet, q_4 < 0"), shapes_at(chain, 3.5)};
}

}  // namespace plumbline::verify
