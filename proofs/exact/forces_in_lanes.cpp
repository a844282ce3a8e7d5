#include "proofs/exact/forces_in_lanes.hpp"

#include <algorithm>
#include <plumbline/straight/critical_force.hpp>

namespace plumbline::proofs {

std::vector<ForceInLanes> forces_in_lanes(const StraightChain<Rational>& chain, std::size_t lowest) {
  const auto wide = from_rational<Wide>(chain.chain);
  const auto narrow = detail::narrowed<double>(wide);
  if (!narrow) return {};
  const auto near = detail::lowest_roots_in_range({*narrow, chain.end_point}, lowest);
  if (!near) return {};
  const detail::BeadString<Wide> string({wide, chain.end_point});
  std::vector<ForceInLanes> forces;
  for (std::size_t part = 0; part < near->size(); ++part) {
    const std::vector<Wide> rough((*near)[part].begin(), (*near)[part].end());
    const auto runs = run_in_lanes(StringInWords(string.pieces()[part]), rough);
    for (std::size_t i = 0; i < rough.size(); ++i) forces.push_back({refined(rough[i], runs[i]), part, i});
  }
  std::stable_sort(forces.begin(), forces.end(),
                   [](const ForceInLanes& a, const ForceInLanes& b) { return a.value < b.value; });
  if (forces.size() > lowest) forces.resize(lowest);
  return forces;
}

}  // namespace plumbline::proofs
