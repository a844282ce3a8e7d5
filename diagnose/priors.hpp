#pragma once
/// \file
/// Every opinion of the diagnosis, in one table: prior probabilities and scales, losses.
/// docs/how-it-decides.md says what each is for. Numerical tolerances stand where they are used.

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
/// Shares of such gaps that show at a few neighbouring readings alone, in which every reading of a channel is
/// off by an amount of its own, in which readings are off by one amount from some reading on, and in which
/// one channel alone is off.
inline constexpr double local = 0.3, nugget = 0.1, step = 0.1, one_channel = 0.1;
/// Shares of gaps with one cause of the catalogue, two, three.
inline constexpr std::array<double, 3> causes{0.75, 0.2, 0.01};
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
/// So many readings are outliers: a Cauchy density, so many times as wide as the noise.
inline constexpr double outlier_share = 0.02, outlier_width = 10;
/// Probability of each departure from even noise: a run or a segment that is noisier, noise in proportion,
/// periodic interference.
inline constexpr double uneven_noise = 0.05;

// ---- Losses ----

/// Of a cause that is not among those named, over that of naming one cause more.
inline constexpr double wrong_over_further_name = 20;
/// The largest class that helps: beyond it the answer is `unknown`.
inline constexpr std::size_t largest_class = 8;
/// Power of the likelihood where a discrepancy is present: neighbouring readings share it, and odds inflate
/// with their number.
inline constexpr double temper = 0.25;

}  // namespace plumbline::diagnose::priors
