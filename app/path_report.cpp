#include "app/path_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <plumbline/branch/straight_start.hpp>

#include "support/files/csv_file.hpp"

namespace plumbline::app {
namespace {

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + files::csv_field(field);
  return line + "\n";
}

std::string stability(const BranchPoint<double>& point) {
  return point.negative_directions == 0 ? "stable" : fmt::format("unstable ({})", point.negative_directions);
}

std::string row(const BranchPoint<double>& p, std::string_view note) {
  return fmt::format("{:10.6f} {:12.6f} {:12.6f} {:12.6f} {:12.5g}  {:<13}{}\n", p.load, p.force.x, p.force.y,
                     p.energy, p.stiffness, stability(p), note);
}

/// Every event, and between them so few points that the table stays short.
std::string table(const Branch<double>& branch) {
  constexpr std::size_t rows = 12;
  std::string text = fmt::format("{:>10} {:>12} {:>12} {:>12} {:>12}  {}\n", "load", "Fx", "Fy", "energy",
                                 "stiffness", "equilibrium");
  const std::size_t stride = std::max<std::size_t>(1, branch.points.size() / rows);
  std::size_t event = 0;
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    if (i % stride == 0 || i + 1 == branch.points.size()) text += row(branch.points[i], "");
    for (; event < branch.events.size() && branch.events[event].before == i; ++event)
      text += row(branch.events[event].point, name(branch.events[event].kind));
  }
  return text;
}

std::vector<std::string> fields(std::size_t branch, std::size_t number, const BranchPoint<double>& p,
                                std::string_view event) {
  std::vector<std::string> row{fmt::format("{}", branch),
                               fmt::format("{}", number),
                               fmt::format("{}", p.load),
                               fmt::format("{}", p.end_point.x),
                               fmt::format("{}", p.end_point.y),
                               fmt::format("{}", p.force.x),
                               fmt::format("{}", p.force.y),
                               fmt::format("{}", p.energy),
                               fmt::format("{}", p.stiffness),
                               fmt::format("{}", p.negative_directions),
                               std::string(event)};
  for (const double q : joint_angles(p.theta)) row.push_back(fmt::format("{}", q));
  return row;
}

nlohmann::ordered_json point_json(const BranchPoint<double>& p) {
  return {{"load", p.load},
          {"end_point", {p.end_point.x, p.end_point.y}},
          {"force", {p.force.x, p.force.y}},
          {"energy", p.energy},
          {"stiffness", p.stiffness},
          {"negative_directions", p.negative_directions},
          {"q", joint_angles(p.theta)}};
}

}  // namespace

std::string as_text(const proofs::PathReport& report) {
  const auto& l = report.loading;
  const Point<double> to = l.at(report.last);
  std::string text = fmt::format("{}: {} from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g})\n", report.chain,
                                 l.control == Control::end_point ? "end point" : "force on the end point",
                                 l.start.x, l.start.y, to.x, to.y);
  text += fmt::format(
      "load = {} so far; stiffness = d(force)/d(deflection) along it\n",
      l.control == Control::end_point ? "distance of the end point from its start" : "force applied");
  for (std::size_t i = 0; i < report.branches.size(); ++i) {
    const Branch<double>& branch = report.branches[i];
    if (report.history)
      text += i == 0 ? "\nThe slowly loaded chain\n" : "\nand from there, where the energy flows\n";
    else
      text += fmt::format("\nBranch {} ({} points; ends: {})\n", i + 1, branch.points.size(),
                          proofs::name(branch.end));
    text += table(branch);
    if (report.history && branch.end != BranchEnd::load && branch.end != BranchEnd::unstable)
      text += fmt::format("the path ends here: {}\n", proofs::name(branch.end));
  }
  return text;
}

std::string as_csv(const proofs::PathReport& report) {
  std::vector<std::string> header{
      "branch", "point", "load", "x", "y", "Fx", "Fy", "energy", "stiffness", "negative_directions", "event"};
  const auto n = static_cast<std::size_t>(report.branches.at(0).points.at(0).theta.size());
  for (std::size_t i = 1; i <= n; ++i) header.push_back(fmt::format("q{}", i));
  std::string text = csv_line(header);
  for (std::size_t b = 0; b < report.branches.size(); ++b) {
    const Branch<double>& branch = report.branches[b];
    std::size_t event = 0, number = 0;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      text += csv_line(fields(b + 1, ++number, branch.points[i], ""));
      for (; event < branch.events.size() && branch.events[event].before == i; ++event) {
        const auto& at = branch.events[event];
        text += csv_line(fields(b + 1, ++number, at.point, name(at.kind)));
      }
    }
  }
  return text;
}

nlohmann::ordered_json as_json(const proofs::PathReport& report) {
  nlohmann::ordered_json branches = nlohmann::ordered_json::array();
  for (const Branch<double>& branch : report.branches) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array(), events = points;
    for (const auto& point : branch.points) points.push_back(point_json(point));
    for (const auto& event : branch.events) {
      nlohmann::ordered_json entry{{"kind", name(event.kind)}};
      entry.update(point_json(event.point));
      events.push_back(std::move(entry));
    }
    branches.push_back({{"end", proofs::name(branch.end)}, {"events", events}, {"points", points}});
  }
  const auto& l = report.loading;
  return {{"chain", report.chain},
          {"control", l.control == Control::end_point ? "end_point" : "force"},
          {"start", {l.start.x, l.start.y}},
          {"direction", {l.direction.x, l.direction.y}},
          {report.history ? "history" : "branches", branches}};
}

namespace {

constexpr int dot = 0;  ///< gnuplot's smallest point

/// What a straight chain does before it buckles: the force grows, and nothing moves.
void add_straight_part(page::Panel& curve, double critical) {
  constexpr int black = 0;
  curve.curves.push_back({{{0, 0}, {0, critical}}, black, false, "straight", 1.6});
  curve.marks.push_back({0, critical, "buckling"});
}

/// The joint farthest from the line between the ends, where no two shapes meet; the end of a straight one.
std::pair<double, double> where_to_write(const std::vector<std::pair<double, double>>& outline) {
  const auto [dx, dy] = outline.back();
  const auto aside = [&](const auto& joint) { return std::abs(dx * joint.second - dy * joint.first); };
  const auto far = std::max_element(outline.begin(), outline.end(),
                                    [&](const auto& a, const auto& b) { return aside(a) < aside(b); });
  return aside(*far) > 0.01 * (dx * dx + dy * dy) ? *far : outline.back();
}

/// Near a singularity, where all links come into one line, forces grow beyond bounds: what most points stay
/// within is shown. Nothing where that is all.
/// \param kept  a force that is shown in any case
std::string range_of_most(const std::vector<page::Curve>& curves, double kept) {
  std::vector<double> forces;
  for (const page::Curve& curve : curves)
    for (const auto& [x, y] : curve.points) forces.push_back(y);
  std::sort(forces.begin(), forces.end());
  const auto at = [&](double share) {
    return forces[static_cast<std::size_t>(share * static_cast<double>(forces.size() - 1))];
  };
  const double low = std::min(at(0.02), kept), high = std::max(at(0.98), kept), air = (high - low) / 2;
  if (forces.front() >= low - air && forces.back() <= high + air) return "";
  return fmt::format("set yrange [{:.6g}:{:.6g}]\n", std::max(forces.front(), low - air),
                     std::min(forces.back(), high + air));
}

}  // namespace

std::vector<page::Panel> as_drawing(const proofs::PathReport& report, const Chain<double>& chain) {
  const auto& l = report.loading;
  const bool held = l.control == Control::end_point;
  page::Panel curve{report.chain + ": force over deflection",
                    "deflection along the load [length]",
                    "force along the load [force]",
                    {},
                    {},
                    "set key below\n",
                    false};
  page::Panel shapes{"shapes, each with its load", "x [length]", "y [length]", {}, {}, "set key off", true};
  const auto deflection = [&](const BranchPoint<double>& p) {
    if (held) return p.load;
    const Point<double>& start = report.branches[0].points[0].end_point;
    return (p.end_point.x - start.x) * l.direction.x + (p.end_point.y - start.y) * l.direction.y;
  };
  const auto force = [&](const BranchPoint<double>& p) {
    return p.force.x * l.direction.x + p.force.y * l.direction.y;
  };
  for (std::size_t b = 0; b < report.branches.size(); ++b) {
    const Branch<double>& branch = report.branches[b];
    const int colour = static_cast<int>(b % 7) + 1;
    verify::add_curves(curve.curves, branch, colour, deflection, force,
                       fmt::format("{} {}", report.history ? "stretch" : "branch", b + 1));
    for (const auto& event : branch.events)
      curve.marks.push_back({deflection(event.point), force(event.point), std::string(name(event.kind))});
    for (const std::size_t i : {std::size_t{0}, branch.points.size() / 2, branch.points.size() - 1}) {
      if (i == 0 && b > 0 && !report.history) continue;  // as the first branch begins
      const BranchPoint<double>& point = branch.points[i];
      const auto outline = verify::outline(chain, point.theta);
      const auto [x, y] = where_to_write(outline);
      const bool unloaded = std::abs(point.load) < 1e-3 * std::abs(report.last);
      shapes.curves.push_back({outline, colour, point.negative_directions > 0, "", 2.2});
      shapes.marks.push_back({x, y, unloaded ? "0" : fmt::format("{:.3g}", point.load), dot});
    }
  }
  if (held && is_straight(chain)) add_straight_part(curve, force(report.branches[0].points[0]));
  const BranchPoint<double>& first = report.branches[0].points[0];
  curve.extra += range_of_most(curve.curves, held && is_straight(chain) ? 0 : force(first));
  return {curve, shapes};
}

}  // namespace plumbline::app
