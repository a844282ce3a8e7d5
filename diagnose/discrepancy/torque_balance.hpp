#pragma once
/// \file
/// The torque that the nominal statics miss at each joint, and which joints it points at.

#include "diagnose/discrepancy/joint_share.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// What a reading with measured joint angles misses at one joint: k_i d_i - [J^T F]_i, less what the nominal
/// weight of the links gives.
struct MissingTorque {
  std::size_t run, reading;
  double angle;   ///< measured joint angle
  double torque;  ///< N m
  double sigma;   ///< of the torque, from the declared noise of force and angles
};

/// By joint. Empty lists where no run measures all joint angles together with the force.
std::vector<std::vector<MissingTorque>> missing_torques(const Experiment& experiment);

/// What the readings miss beyond what the effects of the nominal model carry where that predicts the chain.
/// \param readings  of the study's runs, as measured or as predicted
std::vector<std::vector<MissingTorque>> missing_torques(const Study& study, const Experiment& readings);

/// The experiment as if this had been measured: without noise, with the force and all joint angles.
Experiment as_measured(Experiment experiment, const Prediction& predicted);

/// Shares of the joints in the missing torque beyond its noise, largest first. Empty where no joint angles
/// are measured, or where noise alone may give what is missing.
std::vector<JointShare> shares_by_missing_torque(const Study& study, const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
