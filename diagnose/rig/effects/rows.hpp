#pragma once
/// \file
/// The rows of the catalogue, by where the effects act. A new effect is one row here and its addition to Rig.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

std::vector<Effect> joint_effects();
std::vector<Effect> link_effects();
std::vector<Effect> bench_effects();
std::vector<Effect> load_cell_effects();
std::vector<Effect> common_effects();
std::vector<Effect> joint_law_effects();
std::vector<Effect> friction_effects();
std::vector<Effect> instrument_effects();
std::vector<Effect> arm_joint_effects();
std::vector<Effect> arm_tool_effects();
std::vector<Effect> arm_bench_effects();

}  // namespace plumbline::diagnose
