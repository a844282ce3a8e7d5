#pragma once
/// \file
/// Derivatives of all readings by frames and effects, in declared sigmas.

#include "diagnose/calibration/calibration.hpp"
#include "diagnose/calibration/grouped_regression.hpp"
#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Effects, a column a parameter, in units of its typical size.
struct EffectColumns {
  struct Parameter {
    EffectAt at;
    ParameterRange range;
  };
  Eigen::MatrixXd columns;
  std::vector<Parameter> parameters;  ///< by column
  std::vector<ColumnGroup> groups;    ///< of one effect at all joints, or of a single cause

  /// Coefficients of all columns, within the bounds of their parameters.
  [[nodiscard]] Eigen::VectorXd clamped(Eigen::VectorXd coefficients) const;
  /// The effects at coefficients of all columns.
  [[nodiscard]] std::vector<NominalEffect> at(const Eigen::VectorXd& coefficients) const;
  /// That of a group, which is one effect, at the coefficients of the group.
  [[nodiscard]] NominalEffect effect(std::size_t group, const Eigen::VectorXd& coefficients) const;
  [[nodiscard]] LearnedSize size_of(std::size_t group, double size) const;
  /// The effects that are combinations of other columns.
  [[nodiscard]] std::vector<EffectAt> within(const Eigen::MatrixXd& others) const;
};

/// Every effect that is a little there at every joint; a group an effect.
EffectColumns random_columns(const Study& study);

/// Every effect that may be a cause, as far as a small amount of it shows; one whose small amounts act
/// otherwise than large ones by the first guess of it. A group an effect at its place.
EffectColumns columns_of_causes(const Study& study);

/// Shift and turn of the tracker, then of each point on its link.
Eigen::MatrixXd columns_of_frames(const Study& study);

/// Moves the frames by coefficients of these columns. \returns the tracker's motion
Pose<double> move_frames(Experiment& experiment, const Eigen::VectorXd& coefficients);

/// The frames as they are, with their standard deviations beside random effects.
/// \param size  of the random effects, by column
std::vector<SolvedFrame> solved(const Experiment& experiment, const Pose<double>& tracker,
                                const Eigen::MatrixXd& frames, const Eigen::MatrixXd& random,
                                const Eigen::VectorXd& size, double noise);

}  // namespace plumbline::diagnose
