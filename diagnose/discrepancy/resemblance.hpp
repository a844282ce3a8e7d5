#pragma once
/// \file
/// Which kinds of the catalogue a free torque law looks like: what a person may look for at that joint. A
/// shape is no cause.

#include "diagnose/discrepancy/offered_law.hpp"

namespace plumbline::diagnose {

/// What a law shows, each a class of effects (their ids) that would draw much the same, the nearest first:
/// the shape of its spring, where that is no straight line or a steeper one; then what its memory is like.
/// The effects sit where the law does.
std::vector<std::vector<std::string>> resemblance(const LawPicture& picture, const JointTorqueLaw& law);

}  // namespace plumbline::diagnose
