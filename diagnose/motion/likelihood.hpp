#pragma once
/// \file
/// The likelihood of what a model leaves of the segments.
///
///   residual = initial state + delta + noise,  delta ~ N(0, (A^2 + e^2) exp(-|t - t'| / tau)), one of each
///   quantity
///
/// Beside the discrepancy A stands e, the error of the prediction by steps of finite length: no drive is
/// modelled better than its motion is computed.
///
/// The initial state and delta are summed out, the latter reading by reading (Kalman 1960); the motion is
/// linear in the initial state about the one that it was computed from, which fits move to the most probable
/// one. Each segment has a scale of its own, which is known within a factor: Student's distribution of many
/// values. So logs that repeat badly count for less.

#include "diagnose/inference/hyperpriors.hpp"
#include "diagnose/motion/bench.hpp"

namespace plumbline::motion {

/// Size of the discrepancy, rad, and its time of correlation, s.
struct Cell {
  double amplitude, correlation;
};

/// What the likelihood says in one cell.
struct Slope {
  double log_likelihood = 0;
  Eigen::VectorXd gradient;     ///< by the parameters
  Eigen::MatrixXd information;  ///< Gauss and Newton's
  std::vector<Begin> begin;     ///< of each segment, the most probable one beside these parameters
  std::vector<Eigen::MatrixXd> begin_slopes;  ///< of these by the parameters
};

/// What it says in all.
struct Look {
  std::vector<double> log_by_amplitude;  ///< in the order of Hyperpriors::amplitude
  Cell best;                             ///< beside a cause of the catalogue
  double log_likelihood = 0;             ///< the same, all cells summed
};

class Likelihood {
 public:
  /// \param units    of the sizes of the discrepancy, by quantity: what the nominal model leaves, root mean
  ///                 square; a discrepancy has the same share of them in every quantity
  /// \param outside  what a cause outside of the catalogue typically changes, rad
  /// \param numerical  errors of the prediction, by log; none where it is empty
  Likelihood(const Quantities& units, double outside, std::vector<Quantities> numerical = {})
      : units_(units), numerical_(std::move(numerical)), priors_(diagnose::full_model()) {
    priors_.set_outside(outside / unit());
  }

  [[nodiscard]] const diagnose::Hyperpriors& priors() const { return priors_; }
  [[nodiscard]] double unit() const { return units_[0]; }
  [[nodiscard]] Slope slope(const std::vector<SegmentMeans>& left, const Cell& cell) const;
  [[nodiscard]] Look look(const std::vector<SegmentMeans>& left) const;

 private:
  struct Whitened;
  /// Share of the discrepancy that each reading has from the one before it of the same quantity.
  [[nodiscard]] static Eigen::VectorXd kept(const SegmentMeans& left, double correlation);
  /// Variance of the discrepancy at each reading, with the error of the prediction.
  [[nodiscard]] Eigen::VectorXd variance(const SegmentMeans& left, double amplitude) const;

  Quantities units_;
  std::vector<Quantities> numerical_;
  diagnose::Hyperpriors priors_;
};

}  // namespace plumbline::motion
