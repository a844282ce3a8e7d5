#pragma once
/// \file
/// A buckling mode of the straight chain, paper equations (35) to (39), and the name of its shape.
///
/// \code{.cpp}
/// // The U-shape of the paper's three-link chain (passive base): k / L, (16).
/// const Chain<Rational> chain({1, 1, 1}, {0, 1, 1});
/// const std::vector<Rational> q{1, -1, -1};
/// assert(energy_factor(chain, q) == 1 && lateral_force(chain, Rational(1), q) == 0);
/// assert(sign_pattern(q) == "+--" && shape_name("+--") == "U");
/// \endcode

#include <plumbline/chain/linearised.hpp>
#include <string>

namespace plumbline {

/// One equilibrium shape in the neighbourhood of the straight chain, up to the small factor mu of (35).
template <Number Real>
struct Mode {
  Real force;           ///< critical force F_x, compression positive
  std::vector<Real> q;  ///< joint angles / mu, n of them
  Real fy;              ///< lateral force F_y / mu
};

/// Energy factor (39): strain energy over shortening, both to leading order. It equals the critical force of
/// the mode exactly: multiply (29) by q^T and use (30).
template <Number Real>
Real energy_factor(const Chain<Real>& chain, const std::vector<Real>& q) {
  Real twice_energy(0);
  for (std::size_t i = 0; i < chain.size(); ++i)
    twice_energy = twice_energy + chain.stiffness()[i] * (q[i] * q[i]);
  return twice_energy / (Real(2) * small_deflection(chain, q).x);
}

/// F_y / mu of a mode from its first equation in (29).
template <Number Real>
Real lateral_force(const Chain<Real>& chain, const Real& force, const std::vector<Real>& q) {
  const std::vector<Real> z = distance_to_end(chain);
  Real moment = chain.stiffness()[0] * q[0];
  for (std::size_t j = 0; j < chain.size(); ++j) moment = moment - force * (z[j] * q[j]);
  return -moment / z[0];
}

/// The signs of the joint angles, such as "+--+"; an exact zero is "0".
template <Ordered Real>
std::string sign_pattern(const std::vector<Real>& q) {
  std::string signs;
  for (const Real& angle : q) signs += angle > Real(0) ? '+' : angle < Real(0) ? '-' : '0';
  return signs;
}

/// The paper's name of a shape (Table 3), continued to any n. Read from the end point to the base, two
/// neighbours among joints 2 … n that bend the same way make a U, two that bend opposite ways make a Z, and
/// equal letters in a row are written once: U for an arch, Z for a zigzag, ZU for a zigzag that ends in an
/// arch. A joint that does not bend at all is passed over; fewer than two that bend are a U.
inline std::string shape_name(const std::string& signs) {
  std::string bends, name;
  for (std::size_t i = 1; i < signs.size(); ++i) {
    if (signs[i] != '0') bends += signs[i];
  }
  for (std::size_t i = bends.size(); i-- > 1;) {
    const char letter = bends[i] == bends[i - 1] ? 'U' : 'Z';
    if (name.empty() || name.back() != letter) name += letter;
  }
  return name.empty() ? "U" : name;
}

}  // namespace plumbline
