#pragma once
/// \file
/// Derivatives of all readings by effects, in declared sigmas, and motions of frames.

#include "diagnose/calibration/grouped_regression.hpp"
#include "diagnose/inference/calibration.hpp"
#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Effects, a column a parameter, in units of its typical size.
struct EffectColumns {
  struct Parameter {
    EffectAt at;
    ParameterRange range;
  };
  MatrixXd columns;
  std::vector<Parameter> parameters;  ///< by column
  /// First an effect that is everywhere at all its joints, then each effect at its place alone.
  std::vector<ColumnGroup> groups;
  std::size_t everywhere = 0;  ///< so many groups are of the first kind

  [[nodiscard]] std::vector<std::size_t> always() const;
  [[nodiscard]] std::vector<std::size_t> offered() const;
  /// By effect: its coefficients, within the bounds of its parameters, and their sizes by group, both times
  /// the typical sizes.
  [[nodiscard]] std::vector<Tolerance> effects(const GroupedFit& fit, std::size_t group) const;
  /// Coefficients of all columns that have these means.
  [[nodiscard]] VectorXd coefficients(const std::vector<Tolerance>& means) const;
  [[nodiscard]] LearnedSize size_of(std::size_t group, double size) const;
};

/// Those that are a little there at every joint, and those that may be causes, as far as a small amount of
/// them shows.
EffectColumns effect_columns(const Study& study);

/// Moves the frames, and what is unknown of sensors, by coefficients of the frame columns. \returns the
/// tracker's motion
Pose<double> move_frames(Experiment& experiment, const VectorXd& coefficients);

/// The frames as they are, with their standard deviations beside the effects of a fit.
/// \param declared  as they were before
std::vector<SolvedFrame> solved(const ArmBench& declared, const Experiment& experiment,
                                const Pose<double>& tracker, const MatrixXd& frames, const MatrixXd& effects,
                                const GroupedFit& fit);

}  // namespace plumbline::diagnose
