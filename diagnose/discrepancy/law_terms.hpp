#pragma once
/// \file
/// The terms of a free torque law at a joint: hat functions of the deflection, sliders, relaxing arms, and
/// profiles of sliders.

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/free_law.hpp"

namespace plumbline::diagnose {

/// How far a joint was bent and how long: what the terms are laid out over.
struct LawSpan {
  double low = 0, high = 0;  ///< range of the deflection, rad, with zero in it
  double duration = 0;  ///< of the longest run that has a clock, s: unit of the time constants; 0 of none

  /// The knots lie evenly over both signs, up to here.
  [[nodiscard]] double deflection() const { return std::max(high, -low); }
  /// Unit of the sliders.
  [[nodiscard]] double stroke() const { return (high - low) / 2; }
};

/// The finest knots; 3, 5, 9 and 17 knots are every 16th, 8th, 4th and 2nd of them.
inline constexpr Eigen::Index finest_knots = 33;
/// After which turn the sliders slip, over the stroke; those that widen, after which share of the way d^2/2
/// to the largest deflection.
inline constexpr double slip_shares[] = {0.02, 0.05, 0.1, 0.2, 0.4, 0.7};
/// Time constants of the arms, over the duration.
inline constexpr double time_shares[] = {0.03, 0.15, 0.6};

/// Sliders of a constant slip torque, then as many that widen: they slide along d^2/2.
inline constexpr Eigen::Index slip_places = std::size(slip_shares);
inline constexpr Eigen::Index slider_terms = 2 * slip_places;
inline constexpr Eigen::Index arm_terms = std::size(time_shares);
/// Terms of a law without profiles, which come after them.
inline constexpr Eigen::Index plain_terms = finest_knots + slider_terms + arm_terms;
/// Those of the slips that a slider with a profile may have: what takes less of the stroke is a step.
inline constexpr Eigen::Index profile_slips[] = {2, 3, 4};
/// The finest knots of a profile, every second of a law's.
inline constexpr Eigen::Index profile_knots = 17;
inline constexpr Eigen::Index profile_count = std::size(profile_slips);
inline constexpr Eigen::Index law_terms_count = plain_terms + profile_count * profile_knots;

/// Deflection of a knot, rad.
double knot_place(const LawSpan& span, Eigen::Index knot);

/// Every term at every reading of a run, a row a reading: hats (outside of the knots they go on straight),
/// then sliders (stop operators of Prandtl and Ishlinskii: +-1 where they slip), those that slide along d^2/2
/// times the deflection over the largest, then Maxwell arms, in units of a spring's torque at the largest
/// deflection; then, for each slider that may have a profile, the hats of that, times the slider. The sliders
/// come from rest at no deflection; the arms are at ease at the first reading.
/// \param deflection  by reading; NaN where unknown: the row is zero and history passes over it
Eigen::MatrixXd law_terms(const LawSpan& span, const Run& run, const Eigen::VectorXd& deflection);

/// The law of these coefficients as the rig has it.
/// \param knots  that it has, of the finest
/// \param share  of the torques that the joint has
FreeLaw free_law(const LawSpan& span, Eigen::Index knots, const Eigen::VectorXd& coefficients,
                 std::size_t joint, double share);

}  // namespace plumbline::diagnose
