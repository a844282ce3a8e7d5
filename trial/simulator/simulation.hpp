#pragma once
/// \file
/// The bench at work: MuJoCo moves the carriage slowly from command to command and waits until the chain is
/// at rest before it reads.

#include "trial/simulator/physics.hpp"

namespace plumbline::simulator {

/// The true state at one reading, before any instrument.
struct State {
  double t;               ///< when it was read: later than planned where the chain took long to settle
  Pair end_point, force;  ///< force that the environment exerts on the end point
  std::vector<double> q;  ///< hub angles
};

/// One run from rest, a state for every command.
/// \throws Error when the motion does not settle or MuJoCo gives up
std::vector<State> simulate(const Plan& plan, const Physics& physics, const PlannedRun& run);

/// All runs of a plan.
std::vector<std::vector<State>> simulate(const Plan& plan, const Physics& physics);

}  // namespace plumbline::simulator
