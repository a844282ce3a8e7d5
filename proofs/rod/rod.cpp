#include "proofs/rod/rod.hpp"

#include <algorithm>
#include <map>

namespace plumbline::proofs {
namespace {

Growing of_factor(const Rational& value, bool multiplied) {
  return multiplied ? Growing{0, value} : Growing{value, 0};
}

Restraint<Rational> in_units(Restraint<Rational> restraint, const Rational& by) {
  restraint.stiffness *= by;
  return restraint;
}

void stiffen(Restraint<Rational>& restraint, const Restraint<Rational>& more) {
  if (restraint.is_held() || more.is_free()) return;
  if (more.is_held())
    restraint = more;
  else
    restraint = Restraint<Rational>::sprung(restraint.stiffness + more.stiffness);
}

/// What the loads add to the compression where they act, and its slope on each stretch.
struct AxialLoads {
  std::vector<Growing> at_node, slope, tangential;
};

AxialLoads axial_loads(const Rod& rod, const std::vector<Rational>& places) {
  const auto node = [&](const Rational& at) {
    return static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), at) - places.begin());
  };
  const Rational unit = rod.length * rod.length / rod.EI;
  const std::vector<Growing> none(places.size() - 1);
  AxialLoads loads{std::vector<Growing>(places.size()), none, none};
  for (const RodLoad& load : rod.loads)
    loads.at_node[node(load.at)] += of_factor(load.force * unit, load.multiplied);
  for (const RodWeight& weight : rod.weights) {
    const Rational size = weight.per_length * unit * rod.length;
    for (std::size_t i = node(weight.from); i < node(weight.to); ++i) {
      loads.slope[i] += of_factor(-size, weight.multiplied);
      if (weight.kind == LoadKind::follower) loads.tangential[i] += of_factor(size, weight.multiplied);
    }
  }
  return loads;
}

Growing over(const Growing& slope, const Rational& length) {
  return {slope.fixed * length, slope.multiplied * length};
}

/// Each stretch carries what acts beyond it, seen from the end that is held along the rod.
void compress_stretches(DividedRod& divided, const AxialLoads& loads, bool from_base) {
  const std::size_t last = divided.stretches.size();
  Growing N;
  for (std::size_t step = 0; step < last; ++step) {
    const std::size_t i = from_base ? last - 1 - step : step;
    RodStretch& stretch = divided.stretches[i];
    stretch.slope = loads.slope[i];
    stretch.tangential = loads.tangential[i];
    const Growing across = over(stretch.slope, stretch.length);
    const Growing met = loads.at_node[from_base ? i + 1 : i];
    if (from_base) {
      N += met;
      N += {-across.fixed, -across.multiplied};
      stretch.compression = N;
    } else {
      N += {-met.fixed, -met.multiplied};
      stretch.compression = N;
      N += across;
    }
  }
}

/// Where something begins, ends, holds or acts.
std::vector<Rational> places_of(const Rod& rod) {
  std::vector<Rational> places{Rational(0), rod.length};
  for (const RodSupport& support : rod.supports) places.push_back(support.at);
  for (const RodLoad& load : rod.loads) places.push_back(load.at);
  for (const RodWeight& weight : rod.weights) {
    places.push_back(weight.from);
    places.push_back(weight.to);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void hold_nodes(DividedRod& divided, const Rod& rod, const std::vector<Rational>& places) {
  const Rational turn = rod.length / rod.EI, across = turn * rod.length * rod.length;
  const auto node = [&](const Rational& at) -> RodNode& {
    return divided
        .nodes[static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), at) - places.begin())];
  };
  for (const auto& [at, support] : {std::pair(Rational(0), rod.base), std::pair(rod.length, rod.end_point)}) {
    stiffen(node(at).across, in_units(support.across, across));
    stiffen(node(at).turn, in_units(support.turn, turn));
  }
  for (const RodSupport& support : rod.supports)
    stiffen(node(support.at).across, in_units(support.across, across));
  for (const RodLoad& load : rod.loads) {
    if (load.kind == LoadKind::follower)
      node(load.at).follower += of_factor(load.force * rod.length * rod.length / rod.EI, load.multiplied);
  }
}

}  // namespace

bool DividedRod::follower() const {
  const auto any = [](const Growing& load) { return load.fixed != 0 || load.multiplied != 0; };
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](const RodNode& node) {
                       return any(node.follower) && !node.across.is_held() && !node.turn.is_held();
                     }) ||
         std::any_of(stretches.begin(), stretches.end(),
                     [&](const RodStretch& stretch) { return any(stretch.tangential); });
}

DividedRod divided(const Rod& rod) {
  const bool from_base = !rod.base.along.is_free();
  if (from_base == !rod.end_point.along.is_free())
    throw Error("ends of the rod", from_base ? "both held along it" : "neither held along it",
                "one of the two, or what compresses it is open");
  const std::vector<Rational> places = places_of(rod);
  DividedRod result;
  result.bed = rod.bed * rod.length * rod.length * rod.length * rod.length / rod.EI;
  result.nodes.resize(places.size());
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    result.stretches.push_back({(places[i + 1] - places[i]) / rod.length, {}, {}, {}});
  compress_stretches(result, axial_loads(rod, places), from_base);
  hold_nodes(result, rod, places);
  return result;
}

}  // namespace plumbline::proofs
