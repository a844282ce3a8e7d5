#include "proofs/exact/certified_modes.hpp"

#include <algorithm>

#include "proofs/exact/decimal.hpp"

namespace plumbline::proofs {
namespace {

std::vector<Tie> ties_among(const StraightChain<Rational>& chain, const std::vector<ForceEnclosure>& forces) {
  std::vector<Tie> ties;
  for (const ForceEnclosure& force : forces) {
    if (!ties.empty() && ties.back().low == force.low) continue;
    if (auto tie = find_tie(chain, force)) ties.push_back(std::move(*tie));
  }
  return ties;
}

/// The part of the chain that buckles at a force. Nothing when two parts do and no tie says that they share
/// it.
std::optional<ChainPart> buckling_part(const ExactCount& count, const ForceEnclosure& force,
                                       const std::vector<Tie>& ties) {
  if (std::any_of(ties.begin(), ties.end(), [&](const Tie& tie) { return tie.low == force.low; }))
    return count.parts()[force.index - force.below_low - 1];
  if (force.below_high != force.below_low + 1) return std::nullopt;
  return *std::find_if(count.parts().begin(), count.parts().end(), [&](const ChainPart& part) {
    return count.below(force.low, part) != count.below(force.high, part);
  });
}

/// The shapes of the first so many modes; nothing when they need narrower bounds.
std::optional<std::vector<ShapeEnclosure>> enclose_shapes(const StraightChain<Rational>& chain,
                                                          const CertifiedModes& modes, std::size_t wanted) {
  const ExactCount count(chain);
  std::vector<ShapeEnclosure> shapes;
  while (shapes.size() < std::min(wanted, modes.forces.size())) {
    const ForceEnclosure& force = modes.forces[shapes.size()];
    const auto part = buckling_part(count, force, modes.ties);
    if (!part) return std::nullopt;
    auto shape = enclose_shape(chain, *part, force.low, force.high, modes.digits);
    if (!shape) return std::nullopt;
    shapes.push_back(std::move(*shape));
  }
  return shapes;
}

/// Whether the bounds settle every digit that is asked for.
bool round_alike(const CertifiedModes& modes) {
  return std::all_of(modes.forces.begin(), modes.forces.end(), [&](const ForceEnclosure& force) {
    return to_decimal(force.low, modes.digits) == to_decimal(force.high, modes.digits);
  });
}

}  // namespace

CertifiedModes certify(const StraightChain<Rational>& chain, std::size_t forces, std::size_t shapes,
                       int digits) {
  CertifiedModes modes{digits, {}, {}, {}};
  for (int spare = shapes > 0 ? 8 : 0;; spare += spare / 2 + 8) {
    modes.forces = enclose_critical_forces(chain, forces, digits + spare);
    modes.ties = ties_among(chain, modes.forces);
    auto enclosed = enclose_shapes(chain, modes, shapes);
    constexpr int in_vain = 40;  // a force half-way between two decimals stays there
    if (!enclosed || (spare < in_vain && !round_alike(modes))) continue;
    modes.shapes = std::move(*enclosed);
    return modes;
  }
}

std::string certified_force(const CertifiedModes& modes, std::size_t mode) {
  const ForceEnclosure& force = modes.forces[mode - 1];
  return to_decimal(Rational((force.low + force.high) / 2), modes.digits);
}

}  // namespace plumbline::proofs
