#pragma once
/// \file
/// The prediction of an experiment with a given rig, along the loading history of every run.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The circumstances of a reading that user corrections may depend on.
struct Moment {
  double t;         ///< in the run, s
  std::size_t run;  ///< its number, from 0
  double
      direction;  ///< 1 or -1: of the joint for a joint angle, else of the command along the channel's axis
  double rest;    ///< rest angle of that joint
  std::span<const double> covariates = {};  ///< of the reading
};

/// The values of the variables of a channel's correction: reading_variables, angle_variables, covariates.
std::vector<double> reading_values(const Eigen::Ref<const Eigen::ArrayXd>& row, const Moment& moment,
                                   const Channel& channel);

/// All runs of an experiment.
struct Prediction {
  /// False where the rig cannot follow the experiment: an end point out of reach, or no stable posture.
  bool reached = true;
  bool snapped = false;                         ///< some run snapped
  std::vector<Trace> runs;                      ///< one a run; NaN beyond the reading that was not reached
  std::vector<std::vector<Trace>> sensitivity;  ///< [parameter][run]: derivative by the fitted coordinate
};

/// A rig with a small step in one parameter.
struct RigVariation {
  Rig rig;
  double step;
};

/// Predicts all runs, and the difference quotients by the variations.
Prediction simulate(const Experiment& experiment, const Rig& rig,
                    const std::vector<RigVariation>& variations);

}  // namespace plumbline::diagnose
