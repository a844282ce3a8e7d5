#include "app/structure_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofs/exact/certain_digits.hpp"

namespace plumbline::app {
namespace {

std::string type_of(const BentPoint<double>& point) {
  return point.negative_directions == 0 ? "stable" : fmt::format("unstable ({})", point.negative_directions);
}

std::string type_of(const proofs::SampledEquilibrium& one) {
  return one.singular ? "undecided (constraints are dependent in this shape alone)" : type_of(one.point);
}

const char* name_of(BentEventKind kind) {
  return kind == BentEventKind::fold ? "fold" : "bifurcation";
}
const char* name_of(BentEnd end) {
  switch (end) {
    case BentEnd::factor:
      return "end of the loads";
    case BentEnd::closed:
      return "closed";
    case BentEnd::stuck:
      return "could not be followed further";
    case BentEnd::loss:
      return "loss of stability";
    case BentEnd::flight:
      return "loss of stability, and no stable equilibrium was reached beyond";
    case BentEnd::singular:
      return "not decided beyond a shape in which alone constraints are dependent";
    default:
      return "as many linear systems as are allowed were solved";
  }
}

Eigen::Vector3d end_point(const BentStructure<double>& model, const BentPoint<double>& point) {
  BentExpansion<double> at;
  model.expand(point.x, point.factor, point.multiplier, at);
  return at.place.back();
}

/// Every point of a branch in order, events among them.
template <class Row>
void each(const BentBranch<double>& branch, const Row& row) {
  std::size_t event = 0;
  for (std::size_t i = 0; i <= branch.points.size(); ++i) {
    for (; event < branch.events.size() && branch.events[event].before == i; ++event)
      row(i, branch.events[event].point, name_of(branch.events[event].kind));
    if (i < branch.points.size()) row(i, branch.points[i], "");
  }
}

std::string line(const BentStructure<double>& model, const BentPoint<double>& point,
                 const std::string& note) {
  const Eigen::Vector3d p = end_point(model, point);
  return fmt::format("{:12.6g} {:11.6f} {:11.6f} {:11.6f} {:12.6g}  {:<14}{}\n", point.factor, p(0), p(1),
                     p(2), model.potential(point.x, point.factor), type_of(point), note);
}

nlohmann::ordered_json to_json(const BentStructure<double>& model, const BentPoint<double>& point) {
  const Eigen::Vector3d p = end_point(model, point);
  return {{"factor", point.factor},
          {"end_point", {p(0), p(1), p(2)}},
          {"energy", model.potential(point.x, point.factor)},
          {"negative_directions", point.negative_directions},
          {"q", model.angles(point.x)}};
}

}  // namespace

std::string as_text(const NamedModel& chain, const proofs::StructurePath& path) {
  std::string text = fmt::format("{}: {} links, {}\n", chain.name, chain.model.chain().size(), chain.words);
  for (std::size_t b = 0; b < path.branches.size(); ++b) {
    const BentBranch<double>& branch = path.branches[b];
    text += fmt::format("\n{} {}: {}\n{:>12} {:>11} {:>11} {:>11} {:>12}  {}\n",
                        path.history ? "stretch" : "branch", b + 1, name_of(branch.end), "factor", "x", "y",
                        "z", "energy", "equilibrium");
    const std::size_t stride = std::max<std::size_t>(1, branch.points.size() / 12);
    each(branch, [&](std::size_t i, const BentPoint<double>& point, const std::string& note) {
      if (!note.empty() || i % stride == 0 || i + 1 == branch.points.size())
        text += line(chain.model, point, note);
    });
  }
  return text;
}

std::string as_csv(const NamedModel& chain, const proofs::StructurePath& path) {
  std::string text = "branch,point,factor,x,y,z,energy,negative_directions,event";
  for (std::size_t i = 0; i < chain.model.chain().freedoms(); ++i) text += fmt::format(",q{}", i + 1);
  text += "\n";
  for (std::size_t b = 0; b < path.branches.size(); ++b) {
    each(path.branches[b], [&](std::size_t i, const BentPoint<double>& point, const std::string& note) {
      const Eigen::Vector3d p = end_point(chain.model, point);
      text += fmt::format("{},{},{},{},{},{},{},{},{}", b + 1, i, point.factor, p(0), p(1), p(2),
                          chain.model.potential(point.x, point.factor), point.negative_directions, note);
      for (const double q : chain.model.angles(point.x)) text += fmt::format(",{}", q);
      text += "\n";
    });
  }
  return text;
}

nlohmann::ordered_json as_json(const NamedModel& chain, const proofs::StructurePath& path) {
  nlohmann::ordered_json branches = nlohmann::ordered_json::array();
  for (const BentBranch<double>& branch : path.branches) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array(), events = points;
    for (const auto& point : branch.points) points.push_back(to_json(chain.model, point));
    for (const auto& event : branch.events) {
      nlohmann::ordered_json one = to_json(chain.model, event.point);
      one["kind"] = name_of(event.kind);
      one["before"] = event.before;
      events.push_back(std::move(one));
    }
    branches.push_back({{"end", name_of(branch.end)}, {"points", points}, {"events", events}});
  }
  return {{"chain", chain.name},
          {"case", chain.words},
          {"history", path.history},
          {"branches", branches},
          {"warnings", path.warnings}};
}

std::string as_text(const NamedModel& chain, double factor,
                    const std::vector<proofs::SampledEquilibrium>& found, std::size_t starts) {
  std::string text = fmt::format(
      "{}: {} links, {}; loads times {}\n{} equilibria, by energy; found from {} random shapes: there may be "
      "others\n",
      chain.name, chain.model.chain().size(), chain.words, factor, found.size(), starts);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Eigen::Vector3d p = end_point(chain.model, found[i].point);
    text += fmt::format(
        "\n{:3}  {}, energy {:.12g}\n     end point {:.12g}, {:.12g}, {:.12g}\n     angles    ", i + 1,
        type_of(found[i]), chain.model.potential(found[i].point.x, factor), p(0), p(1), p(2));
    const auto q = chain.model.angles(found[i].point.x);
    for (std::size_t j = 0; j < q.size(); ++j) text += fmt::format("{}{:.12g}", j > 0 ? ", " : "", q[j]);
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const NamedModel& chain, double factor,
                               const std::vector<proofs::SampledEquilibrium>& found) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& one : found) {
    list.push_back(to_json(chain.model, one.point));
    if (one.singular) list.back()["negative_directions"] = nullptr;
  }
  return {{"chain", chain.name},
          {"case", chain.words},
          {"factor", factor},
          {"complete", false},
          {"equilibria", list}};
}

namespace {

/// As many digits as the bounds share, twelve at most; "0" where it may be zero.
std::string certain(const proofs::Span& x) {
  return proofs::certain_digits(hull(Interval::from_double(x.low), Interval::from_double(x.high)), 12);
}
std::string type_of(const proofs::StructureEquilibrium& one) {
  if (!one.negative_directions) return "undecided";
  return *one.negative_directions == 0 ? "stable" : fmt::format("unstable ({})", *one.negative_directions);
}
std::vector<std::string> certain_angles(const proofs::StructureEquilibrium& one) {
  std::vector<std::string> q;
  for (const proofs::Span& angle : one.q) q.push_back(certain(angle));
  return q;
}

}  // namespace

std::string as_text(const NamedModel& chain, double factor, const proofs::StructureCensus& census) {
  std::string text = fmt::format(
      "{}: {} links, {}; loads times {}\n{} equilibria, by energy; {} ({} boxes searched)\n", chain.name,
      chain.model.chain().size(), chain.words, factor, census.equilibria.size(),
      census.complete() ? "certified: these are all in the window" : "certified, but for the undecided boxes",
      census.boxes);
  text += fmt::format("window: each joint within {:.4f} rad of its rest", census.widest_turn);
  if (census.largest_force > 0)
    text += fmt::format(", the force across the end point up to {:.6g}", census.largest_force);
  text += "\n";
  for (std::size_t i = 0; i < census.equilibria.size(); ++i) {
    const auto& one = census.equilibria[i];
    text +=
        fmt::format("\n{:3}  {}, energy {}\n     end point {}, {}; force across it {}\n     angles    {}\n",
                    i + 1, type_of(one), certain(one.energy), certain(one.x), certain(one.y),
                    certain(one.across), fmt::join(certain_angles(one), ", "));
  }
  for (const auto& box : census.undecided) {
    text += "\nundecided: joint angles in";
    for (const proofs::Span& q : box) text += " " + proofs::text(q, 8);
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const NamedModel& chain, double factor,
                               const proofs::StructureCensus& census) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array(), undecided = list;
  for (const auto& one : census.equilibria)
    list.push_back({{"type", type_of(one)},
                    {"energy", certain(one.energy)},
                    {"end_point", {certain(one.x), certain(one.y)}},
                    {"force_across", certain(one.across)},
                    {"q", certain_angles(one)}});
  for (const auto& box : census.undecided) {
    nlohmann::ordered_json q = nlohmann::ordered_json::array();
    for (const proofs::Span& angle : box) q.push_back({angle.low, angle.high});
    undecided.push_back(q);
  }
  return {{"chain", chain.name},
          {"case", chain.words},
          {"factor", factor},
          {"complete", census.complete()},
          {"widest_turn", census.widest_turn},
          {"largest_force_across", census.largest_force},
          {"equilibria", list},
          {"undecided", undecided}};
}

}  // namespace plumbline::app
