#pragma once
/// \file
/// A drafted run of a joint alone: torque and angle, force and travel, or a command.

#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// \throws Error where no column says where the joint is, or what loads or commands it
DraftedRun drafted_joint_run(const RunSource& source, const DraftModel& model, const Ask& ask);

}  // namespace plumbline::diagnose
