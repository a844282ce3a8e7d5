#pragma once
/// \file
/// What can be said of the joints where no missing torque is measured.

#include "diagnose/discrepancy/joint_share.hpp"
#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// Each elastic joint's chance to be the one place of an unknown torque law: a function of the joint's own
/// deflection and of its direction of motion, the same in every run or with a constant of each run beside.
/// The law is piecewise linear, as fine as Schwarz's criterion asks; the best laws of the joints are compared
/// by the same criterion. A passive joint, whose torque nothing shows, gets no share.
std::vector<JointShare> shares_by_torque_law(const Study& study, const std::vector<double>& residual,
                                             const NoiseModel& noise);

/// Shares of the joints in the torque that the nominal statics would miss if the rig were as fitted, weighted
/// by the fits' probabilities, largest first.
std::vector<JointShare> shares_by_fits(const Study& study, const std::vector<Fit>& fits,
                                       const std::vector<double>& probability);

}  // namespace plumbline::diagnose
