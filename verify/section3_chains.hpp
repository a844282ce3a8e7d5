#pragma once
/// \file
/// The loaded chains of section 3, and where their events lie, to fifty digits.

#include <plumbline/trace.hpp>
#include <utility>
#include <vector>

namespace plumbline {

/// pi, to 62 digits.
Interval pi_enclosure();

/// Section 3.1: three links, passive base, L = k = 1, rest angles given as fractions of pi.
Chain<Interval> three_link_chain_at(const Rational& alpha1_over_pi, const Rational& alpha2_over_pi);

/// Distance of the unloaded end point from the base.
Interval unloaded_reach(const Chain<Interval>& chain);

/// Table 1: four links, L = k = 1.
Chain<Interval> u_shaped_chain();
Chain<Interval> z_shaped_chain();

/// Digits of a located event that Newton's method in fifty digits leaves no doubt about.
inline constexpr int located_digits = 40;

/// What happens to the Z-shape of Fig. 8 where it loses stability.
struct ZigzagBuckling {
  BranchPoint<Mpfr50> point;
  bool continuous;  ///< the stable shapes leave the zigzag there, for growing deflection, to both sides
};
ZigzagBuckling zigzag_buckling();

/// The quasi-buckling points of the slowly compressed chains of Table 1 up to 1.5 L, from the end point (3.8,
/// 0), and the tangent stiffness at the beginning and the end.
struct QuasiBuckling {
  std::vector<BranchPoint<Mpfr50>> points;
  Mpfr50 first_stiffness, last_stiffness;
  bool stable;  ///< the whole path
};
QuasiBuckling quasi_buckling(const Chain<Interval>& chain);

}  // namespace plumbline
