#include "diagnose/model/run_rig.hpp"

#include <algorithm>

namespace plumbline::diagnose {
namespace {

JointLaw joint_law(const Rig& rig, std::size_t i, double rest) {
  return {rig.stiffness[i], rest + rig.rest_error[i],        rig.backlash[i],
          rig.stop[i],      rig.stop_stiffness[i],           rig.hardening,
          rig.friction,     rig.arm_ratio * rig.stiffness[i]};
}

}  // namespace

RunRig::RunRig(const Rig& whole, const std::vector<double>& commanded_rest)
    : rig(whole),
      rest_orientation(0),
      largest_stiffness(*std::max_element(whole.stiffness.begin(), whole.stiffness.end())),
      beyond(whole.length.size()) {
  const std::size_t n = whole.length.size();
  Vector2 carried = whole.payload;
  for (std::size_t j = n; j-- > 0;) {
    beyond[j] = carried;
    carried += whole.weight[j];
  }
  for (std::size_t i = 0; i < n; ++i) {
    joint.push_back(joint_law(whole, i, commanded_rest[i]));
    rest_orientation += joint.back().rest;
  }
}

}  // namespace plumbline::diagnose
