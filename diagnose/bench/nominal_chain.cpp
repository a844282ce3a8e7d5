#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

std::vector<std::string> NominalChain::joint_names() const {
  return arm ? arm->joint : std::vector<std::string>();
}

std::string NominalChain::joint_name(std::size_t joint) const {
  const std::vector<std::string> names = joint_names();
  return names.empty() ? "joint " + std::to_string(joint + 1) : names[joint];
}

bool NominalChain::slides(std::size_t joint) const {
  return arm ? arm->arm.links[joint].kind == JointKind::prismatic : end().joint == Sensor::position;
}

}  // namespace plumbline::diagnose
