#pragma once
/// \file
/// Chains, benches and runs as labs have them, at random.

#include "trial/simulator/plan.hpp"
#include "trial/simulator/random.hpp"

namespace plumbline::simulator {

/// Two to six links, straight, curved or folded at rest, pressed along or across, by end point or by force.
/// Everything is rounded as it is written to the files.
Plan draw_plan(Random& random);

/// The bench of a single sprung joint: an arm that is pulled across, or a strut whose end point is moved.
Plan draw_joint_plan(Random& random);

}  // namespace plumbline::simulator
