#pragma once
/// \file
/// The size of a discrepancy as a torque at the joints.

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// The torque at the elastic joints that would give this discrepancy beside a hypothesis: at each reading the
/// smallest one, by how the channels answer to a torque. \returns its root mean square over the readings, N m
/// \param delta  flat, declared sigmas
double discrepancy_torque(const Study& study, const Hypothesis& found, const VectorXd& delta);

}  // namespace plumbline::diagnose
