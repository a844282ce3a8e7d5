#pragma once
/// \file
/// The run along a string with beads (<plumbline/straight/bead_string.hpp>) for many forces at once, in sums
/// of two doubles. Which critical forces it counts, theorem "Rounded counts" says.

#include <plumbline/straight/bead_string.hpp>
#include <vector>

#include "proofs/double_word.hpp"
#include "proofs/working_precision.hpp"

namespace plumbline::proofs {

/// The two doubles whose sum is nearest.
inline DoubleWord<double> two_doubles(const Wide& x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(Wide(x - high))};
}

class StringInLanes {
 public:
  /// What a run finds for one force.
  struct Run {
    DoubleWord<double> end;   ///< f: deflection, or slope, at the end, up to a positive factor
    double slope, curvature;  ///< Taylor coefficients of f in the relative change of the force
    std::size_t below;        ///< changes of sign
    bool sound;               ///< no number on the way came near the ends of the range of double
  };

  explicit StringInLanes(const detail::StringPiece<Wide>& string);

  /// Each of the forces.
  [[nodiscard]] std::vector<Run> run(const std::vector<Wide>& forces) const;

 private:
  std::vector<DoubleWord<double>> mass_, spacing_;
  DoubleWord<double> slope_{};
  bool free_end_, in_range_ = true;
  long exponent_ = 0;  ///< that of the force for which masses and spacings are stored
};

/// The critical force next to which a run was made: the root of the Taylor polynomial of order 2 nearby. The
/// force itself where that is none.
inline Wide refined(const Wide& force, const StringInLanes::Run& run) {
  const double newton = (run.end.high + run.end.low) / run.slope;
  const double step = newton * (1 + newton * run.curvature / run.slope);
  return std::abs(step) < 1e-6 ? Wide(force * (1 - Wide(step))) : force;
}

}  // namespace plumbline::proofs
