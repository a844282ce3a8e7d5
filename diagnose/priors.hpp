#pragma once
/// \file
/// Every opinion of the diagnosis, in one table: prior probabilities and scales, losses.
/// docs/how-it-decides.md says what each is for.

#include <array>

namespace plumbline::diagnose::priors {

// ---- Tolerances: standard deviations of single joints and links ----

/// Springs and printed hinges repeat to a tenth, cut lengths to a percent, assembled angles to a degree.
inline constexpr double stiffness_tolerance = 0.1, length_tolerance = 0.01, angle_tolerance = 0.02;
/// Friction of a joint is a tenth of what its spring carries at a typical deflection; the departure of a
/// spring from a straight line there is as much again.
inline constexpr double friction_tolerance = 0.1, hardening_tolerance = 1;
/// Hinges that are folded, glued or notched on one side differ from side to side by a fifth.
inline constexpr double asymmetry_tolerance = 0.2;
/// Arms in space: zeros of encoders, rad, and places of axes, over the length of the arm.
inline constexpr double zero_tolerance = 0.001, axis_tolerance = 0.0003;

// ---- Causes ----

/// Probability that there is no gap at all.
inline constexpr double no_gap = 0.3;
/// Probability that the cause of a gap is outside of the catalogue.
inline constexpr double outside = 0.1;
/// Sizes of effects and of causes outside, over their typical size: any order of magnitude from this one up
/// to 1 is as probable (inference/size_prior.hpp).
inline constexpr double smallest_typical = 1.0 / 27;
/// What it typically changes, over what the readings of a channel differ by: scale of a half-Cauchy density.
/// The shares of its kinds are those of the rows of outside/outside_cause.hpp.
inline constexpr double typical_outside = 0.1;
/// So many times the declared noise is no noise any more.
inline constexpr double scatter = 4;
/// Share in which every reading of a channel is off by an amount of its own beside whatever is the cause.
inline constexpr double scatter_beside = 0.1;
/// Shares of gaps with one cause of the catalogue, two, three.
inline constexpr std::array<double, 3> causes{0.75, 0.2, 0.01};
/// Numbers that are stated of every device and sensor, such as stiffnesses, gains and zeros, and may be wrong
/// beside the cause: so many on average.
inline constexpr double wrong_beside = 0.4;
/// Probability that manufacturing tolerances show beside a cause.
inline constexpr double tolerances_show = 0.2;
/// An effect that contains a simpler row of the catalogue is so much rarer than others; one of several
/// elements with every element more.
inline constexpr double refinement = 0.1, one_more_element = 0.5;

// ---- Discrepancy, over the root mean square of the nominal residual ----

/// Probability that a device has none beside its cause; else any order of magnitude, with an exponential end
/// at this scale.
inline constexpr double exact_model = 0.5, discrepancy_scale = 0.1;
/// Share of its variance that changes sign with the direction of motion, that is each run's own, and that is
/// there at rest too.
inline constexpr double directional_share = 0.4, own_share = 0.3, rest_share = 0.2;

// ---- Noise ----

/// Scale of the logarithm of true over declared sigma, a Student density of four degrees of freedom; spread
/// of the half-normal autocorrelation of successive readings.
inline constexpr double noise_scale_spread = 0.25, correlation_spread = 0.3;
/// So many readings are outliers: a Cauchy density, so many times as wide as the noise. The share is known as
/// from so many readings.
inline constexpr double outlier_share = 0.02, outlier_width = 10, outlier_evidence = 50;
/// Probability of each departure from even noise: a run or a segment that is noisier, noise in proportion,
/// periodic interference.
inline constexpr double uneven_noise = 0.05;

// ---- A cause in part ----

/// An effect is part of the cause, whichever else acts, where that is as probable as this.
inline constexpr double part_of_it = 0.9;
/// Share of the residual of readings that it has not seen which a cause may leave beyond noise and be the
/// whole cause.
inline constexpr double whole_cause_leaves = 0.2;

// ---- Two states of one device ----

/// Share of the range of each command within which two commands are the same. What a model lacks varies with
/// the command over its whole range, so that of two places so near it is the same to about this share.
inline constexpr double same_command = 0.02;
/// A check is sure where a change that the readings speak for is less probable than this, or more probable
/// than one less this.
inline constexpr double check_is_sure = 0.05;

// ---- Losses ----

/// Of a cause that is not among those named, over that of naming one cause more.
inline constexpr double wrong_over_further_name = 20;
/// The largest class that helps: no more causes are named.
inline constexpr std::size_t largest_class = 8;
/// Power of the evidence where a discrepancy is as large as the noise: neighbouring readings share it, and
/// odds inflate with their number.
inline constexpr double temper = 0.25;

}  // namespace plumbline::diagnose::priors
