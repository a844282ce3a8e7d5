#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

bool NominalChain::slides(std::size_t joint) const {
  return arm ? arm->arm.links[joint].kind == JointKind::prismatic : end().joint == Sensor::position;
}

}  // namespace plumbline::diagnose
