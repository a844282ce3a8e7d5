#pragma once
/// \file
/// How a chain is loaded.
///
/// \code{.cpp}
/// const Loading<double> push{Control::end_point, {4, 0}, {-1, 0}};  // from (4, 0) on towards the base
/// assert(push.at(0.5).x == 3.5);
/// \endcode

#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/control.hpp>

namespace plumbline {

/// What is imposed grows along a ray: start + load · direction, an end point or a force. The direction is a
/// unit vector, so the load is a length or a force.
template <Number Real>
struct Loading {
  Control control;        ///< what the ray lies in
  Point<Real> start;      ///< at load 0
  Point<Real> direction;  ///< a unit vector

  /// What is imposed at a load.
  [[nodiscard]] Point<Real> at(const Real& load) const {
    return {start.x + load * direction.x, start.y + load * direction.y};
  }
};

}  // namespace plumbline
