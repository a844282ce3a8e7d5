#pragma once
/// \file
/// How a chain is loaded.

#include <plumbline/chain/kinematics.hpp>

namespace plumbline {

/// What the environment prescribes.
enum class Control { end_point, force };

/// What is imposed grows along a ray: start + load · direction, an end point or a force. The direction is a
/// unit vector, so the load is a length or a force.
template <Number Real>
struct Loading {
  Control control;
  Point<Real> start;
  Point<Real> direction;

  [[nodiscard]] Point<Real> at(const Real& load) const {
    return {start.x + load * direction.x, start.y + load * direction.y};
  }
};

}  // namespace plumbline
