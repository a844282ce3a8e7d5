#pragma once
/// \file
/// A model that closes the gap where no known effect does: a free torque law at the joints. It says what a
/// joint does, never why.

#include <optional>
#include <string>
#include <vector>

#include "diagnose/discrepancy/law_choice.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// One law, which one joint or several have. Torques are added to those of the nominal spring, in the sense
/// of a spring: positive resists a positive deflection.
struct JointTorqueLaw {
  std::vector<std::size_t> joints;  ///< from 1
  LawSpan span;
  Eigen::VectorXd coefficients;  ///< of the terms, N m, at a joint of stiffness `stiffness`
  double stiffness = 0;          ///< of the joint, or the mean of the joints': the law scales with their own
};

struct TorqueLaw {
  std::vector<JointTorqueLaw> laws;
  LawShape shape;              ///< of each law
  double cross_validated = 1;  ///< rms left on blocks that the fit had not seen, over the nominal model's
};

/// Chooses a law blind and fits it: the joints, the number of knots, the sliders, the arms and how smooth it
/// is are those that predict best the blocks of readings that are left out in turn. In that choice the
/// channels answer to a torque as the nominal chain's derivative says, at the deflections that it has, so the
/// law is linear in its coefficients; the law chosen is then refitted().
///
/// \param seen  without the readings that are held out
///
/// \returns nothing where no law predicts surely better than the nominal model
std::optional<TorqueLaw> fit_torque_law(const Study& seen, const NoiseEstimate& noise);

/// The law fitted to the chain that has it, from where it stands, and its shape chosen again by how that
/// chain answers; as it is where that leaves no less.
TorqueLaw refitted(const Study& study, const NoiseEstimate& noise, const TorqueLaw& law);

/// The laws of the joints, each by itself, as the rig has them.
std::vector<FreeLaw> free_laws(const Study& study, const TorqueLaw& law);

/// What the rig gives with this law in it.
Prediction predict_with_law(const Study& study, const TorqueLaw& law);

/// Sum of squares, in the noise, of what is left with the law in the rig; infinite where that cannot follow
/// the experiment.
double left_with(const Study& study, const NoiseEstimate& noise, const TorqueLaw& law);

/// What one joint carries along one run: the law and its spring, with what the nominal model knows of that.
struct LawTrace {
  std::size_t joint, run;              ///< joint from 1
  Eigen::VectorXd deflection, torque;  ///< by reading, rad and N m
};
std::vector<LawTrace> law_traces(const Study& study, const TorqueLaw& law);

/// Whether the readings held out bend the joints no farther than those seen: beyond, a law says nothing.
/// \param heldout  [run][reading]
bool covers(const Study& study, const TorqueLaw& law, const std::vector<std::vector<bool>>& heldout);

}  // namespace plumbline::diagnose
