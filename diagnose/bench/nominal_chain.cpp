#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

std::string NominalChain::joint_name(std::size_t joint) const {
  return arm ? arm->joint[joint] : "joint " + std::to_string(joint + 1);
}

bool NominalChain::slides(std::size_t joint) const {
  return arm ? arm->arm.links[joint].kind == JointKind::prismatic : end().joint == Sensor::position;
}

}  // namespace plumbline::diagnose
