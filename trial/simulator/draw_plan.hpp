#pragma once
/// \file
/// Random chains, benches and runs of laboratories.

#include "trial/simulator/plan.hpp"
#include "trial/simulator/random.hpp"

namespace plumbline::simulator {

/// Two to six links, straight, curved or folded at rest, pressed along or across, by end point or force,
/// rounded as in the files.
Plan draw_plan(Random& random);

/// A bench with a single sprung joint: an arm pulled across, or a strut whose end point is moved.
Plan draw_joint_plan(Random& random);

}  // namespace plumbline::simulator
