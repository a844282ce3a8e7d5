#include "proofs/exact/enclosure.hpp"

#include <algorithm>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/forces_in_lanes.hpp"
#include "proofs/exact/found_forces.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// Roots to so many digits from those to a third of them, and so on down to what double leads to: a run with
/// three derivatives makes more than three times as many digits right, and the last one costs most.
detail::RootsOfPieces<Mpfr> roots_in_steps(const StraightChain<Rational>& chain, std::size_t lowest,
                                           int digits) {
  constexpr int few = 80, lost = 8;
  if (digits <= few) {
    const WorkingPrecision precision(digits);
    const auto rounded = from_rational<Mpfr>(chain.chain);
    return detail::lowest_roots(StraightChain<Mpfr>(rounded, chain.end_point), lowest);
  }
  const auto near = roots_in_steps(chain, lowest, digits / 3 + lost);
  const WorkingPrecision precision(digits);
  const auto rounded = from_rational<Mpfr>(chain.chain);
  const StraightChain<Mpfr> straight(rounded, chain.end_point);
  const detail::BeadString<Mpfr> string(straight);
  detail::RootsOfPieces<Mpfr> roots;
  for (const auto& piece : string.pieces()) {
    std::vector<Mpfr>& own = roots.emplace_back();
    for (const Mpfr& value : near[roots.size() - 1]) {
      Mpfr start(0);  // of this precision
      mpfr_set(start.backend().data(), value.backend().data(), MPFR_RNDN);
      const auto root = detail::refined(piece, own.size(), start);
      if (!root) return detail::lowest_roots(straight, lowest);
      own.push_back(*root);
    }
  }
  return roots;
}

/// The lowest critical forces, computed with so many digits.
std::vector<Mpfr> forces_in_steps(const StraightChain<Rational>& chain, std::size_t lowest, int digits) {
  std::vector<Mpfr> forces;
  for (const auto& roots : roots_in_steps(chain, lowest, digits))
    forces.insert(forces.end(), roots.begin(), roots.end());
  std::sort(forces.begin(), forces.end());
  forces.resize(std::min(lowest, forces.size()));
  return forces;
}

}  // namespace

std::vector<ForceEnclosure> enclose_critical_forces(const StraightChain<Rational>& chain, std::size_t lowest,
                                                    int digits) {
  const ExactCount count(chain);
  FoundForces found(std::min(lowest, mode_count(chain.chain)), digits,
                    [&](const std::vector<Rational>& forces) { return count.below(forces); });
  if (digits + 7 <= lane_digits && chain.chain.size() >= long_chain) {
    std::vector<Wide> values;
    for (const ForceInLanes& force : forces_in_lanes(chain, lowest)) values.push_back(force.value);
    found.enclose(values, lane_digits);
  }
  for (int working_digits = digits + 12; !found.complete(); working_digits += 12) {
    const WorkingPrecision precision(working_digits);
    found.enclose(forces_in_steps(chain, lowest, working_digits), working_digits);
  }
  return found.all();
}

}  // namespace plumbline::proofs
