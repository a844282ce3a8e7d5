#pragma once
/// \file
/// The rows of the catalogue, by where the effects act. A new effect is one row here and its addition to Rig.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

std::vector<Effect> joint_effects();
std::vector<Effect> joint_law_effects();
std::vector<Effect> friction_effects();
std::vector<Effect> command_effects();
std::vector<Effect> link_effects();
std::vector<Effect> axis_effects();
std::vector<Effect> bench_effects();
std::vector<Effect> tool_effects();
std::vector<Effect> load_sensor_effects();
std::vector<Effect> place_sensor_effects();
std::vector<Effect> sensor_effects();
std::vector<Effect> common_effects();
std::vector<Effect> run_effects();

}  // namespace plumbline::diagnose
