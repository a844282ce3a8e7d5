#pragma once
/// \file
/// A straight chain under compression as its string with beads sees it (bead_string.hpp): with its end point
/// guided on the line, or free.
///
/// Guided, the equations of the string have the lever arms z_i = L_i + … + L_n about the end point, for the
/// force across the chain that the guide exerts passes through it. Free, there is no such force, as if the
/// guide were infinitely far: all arms are alike, and one by choice of the unit (theorem "Free end point").

#include <plumbline/chain/chain.hpp>

namespace plumbline {

/// What the end point of a straight chain may do across it.
enum class EndPoint {
  guided,  ///< nothing: it is led along the line
  free     ///< move
};

/// A chain, looked at with its end point guided or free. It has to outlive this view.
///
/// With a free end point `length` holds what compresses each link times its length, and there is one entry
/// more of both lists: the stiffness that holds the direction of the last link, none where that is free, and
/// a length without meaning. In a mode, the last angle is then that of the ground against the last link.
template <Number Real>
struct StraightChain {
  const Chain<Real>& chain;  ///< lengths and stiffnesses
  EndPoint end_point;        ///< what it may do

  /// With the end point guided, as in the paper.
  StraightChain(const Chain<Real>& guided) : StraightChain(guided, EndPoint::guided) {}  // NOLINT
  /// With the end point guided or free.
  StraightChain(const Chain<Real>& of, EndPoint end) : chain(of), end_point(end) {}

  /// The lever arms z_1 … z_n.
  [[nodiscard]] std::vector<Real> arms() const {
    return end_point == EndPoint::guided ? distance_to_end(chain) : std::vector<Real>(chain.size(), Real(1));
  }
};

}  // namespace plumbline
