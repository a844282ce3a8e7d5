#pragma once
/// \file
/// An arm as the tables [arm] and [[arm.joint]] of an experiment have it.

#include <string>

#include "diagnose/bench/nominal_arm.hpp"

namespace plumbline::exchange {

/// Numbers have twelve digits.
std::string arm_toml(const diagnose::NominalArm& nominal);

}  // namespace plumbline::exchange
