#pragma once
/// \file
/// What a device has beside any model of it: a smooth function of what was commanded, of the direction in
/// which it was commanded, and of the run; nothing at rest.

#include "diagnose/next/data.hpp"

namespace plumbline::diagnose::next {

/// Where a reading stands, for the discrepancy.
struct State {
  Eigen::Vector2d command{0, 0};  ///< from rest, over the largest of its kind of control
  double direction = 1;           ///< 1 away from rest, -1 back
  double progress = 0;            ///< way covered in the run until then, over the longest of any run
};

/// The states of all readings, and which runs are alike.
struct States {
  explicit States(const Experiment& experiment);
  std::vector<std::vector<State>> of;  ///< [run][reading]
  MatrixXd alike;                        ///< of runs, in [0, 1]
};

/// Covariance of a discrepancy of size one at two readings.
class Kernel {
 public:
  Kernel(const States& states, double length) : states_(states), length_(length) {}
  [[nodiscard]] double operator()(std::size_t run, std::size_t reading, std::size_t other_run,
                                  std::size_t other_reading) const;

 private:
  const States& states_;
  double length_;
};

/// Columns phi with phi phi' = the covariance at the values of a block, but for a share `left_out` of its
/// trace: an incomplete Cholesky factorisation, at most `most` columns.
MatrixXd basis(const Kernel& kernel, const Block& block, Eigen::Index most, double left_out);

}  // namespace plumbline::diagnose::next
