#pragma once
/// \file
/// The run along a string with beads (<plumbline/straight/bead_string.hpp>) for many forces at once, in sums
/// of two doubles. Which critical forces it counts, theorem "Rounded counts" says.

#include <array>
#include <plumbline/straight/bead_string.hpp>
#include <vector>

#include "proofs/exact/double_word.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {

/// The two doubles whose sum is nearest.
inline DoubleWord<double> two_doubles(const Wide& x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(Wide(x - high))};
}

/// The data of a string, or of a part of one, in units that bring the largest mass and the largest spacing
/// between 1/2 and 1.
struct StringInWords {
  using Word = DoubleWord<double>;
  std::vector<Word> mass, spacing;
  Word slope{}, end_slope{};  ///< before the first bead and, away from it, behind the last; 0 at a free end
  bool free_end = false;
  bool in_range = true;                          ///< whether the exponents of double leave room for a run
  long mass_exponent = 0, spacing_exponent = 0;  ///< of the powers of two that are the units

  explicit StringInWords(const detail::StringPiece<Wide>& string);
};

/// Up to eight forces that are run for side by side.
struct ForcesInLanes {
  using Lanes = detail::Lanes;
  DoubleWord<Lanes> minus_F;  ///< in the units of the string
  Lanes unit;  ///< of slopes: a link multiplies max(|h|, unit |g|) by not more than (1 + sqrt(F m r))^2
  std::size_t links;  ///< after which to rescale
  std::size_t count;  ///< of lanes in use
  std::array<bool, detail::lane_count> in_range;

  /// Of the forces from number `first` on; another stands in for one out of range.
  ForcesInLanes(const StringInWords& string, const std::vector<Wide>& forces, std::size_t first);
};

/// The number of groups of lanes for so many forces, and of threads for them along so many beads.
constexpr std::size_t groups_of(std::size_t forces) {
  return (forces + detail::lane_count - 1) / detail::lane_count;
}
unsigned threads_for(std::size_t forces, std::size_t beads);

/// Whether numbers on the way are far enough from the ends of the range of double.
[[gnu::always_inline]] inline detail::Mask<detail::Lanes> within_range(const detail::Lanes& x) {
  // No product of two halves overflows, and what underflows is below 2^-100 of what it is added to.
  constexpr double smallest = 0x1p-800, largest = 0x1p800;
  const detail::Lanes size = detail::magnitude(x);
  return (size > smallest) & (size < largest);
}

/// What a run finds for one force.
struct RunInLanes {
  DoubleWord<double> end;   ///< f: deflection, or slope, at the end, up to a positive factor
  double slope, curvature;  ///< Taylor coefficients of f in the relative change of the force
  std::size_t below;        ///< changes of sign
  bool sound;               ///< no number on the way came near the ends of the range of double
};

/// A run for each of the forces.
std::vector<RunInLanes> run_in_lanes(const StringInWords& string, const std::vector<Wide>& forces);

/// The critical force next to which a run was made: the root of the Taylor polynomial of order 2 nearby. The
/// force itself where that is none.
inline Wide refined(const Wide& force, const RunInLanes& run) {
  const double newton = (run.end.high + run.end.low) / run.slope;
  const double step = newton * (1 + newton * run.curvature / run.slope);
  return std::abs(step) < 1e-6 ? Wide(force * (1 - Wide(step))) : force;
}

}  // namespace plumbline::proofs
