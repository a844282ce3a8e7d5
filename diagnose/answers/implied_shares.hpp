#pragma once
/// \file
/// How much of a gap each joint accounts for, where no measured joint angle shows it.

#include "diagnose/answers/cause.hpp"
#include "diagnose/discrepancy/joint_share.hpp"

namespace plumbline::diagnose {

/// The probability of each joint to be the only one with an unknown torque, largest first.
std::vector<JointShare> shares_by_unknown_torques(const Study& study, const Findings& findings);

/// The squared torque that causes add at each joint, over those causes by their probability, largest first.
std::vector<JointShare> shares_by_causes(const Study& study, const std::vector<RankedCause>& causes);

/// The probability of each joint to be named by explanations, over that of any; empty where they name none.
std::vector<JointShare> shares_by_names(const Study& study, const std::vector<RankedCause>& causes);

}  // namespace plumbline::diagnose
