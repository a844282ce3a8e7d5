#pragma once
/// \file
/// Branches in double precision of chains in any units: followed and proved where lengths and stiffnesses are
/// of ordinary size, so that nothing overflows, and no tolerance is out of proportion.

#include <plumbline/branch/trace.hpp>
#include <plumbline/chain/chain.hpp>
#include <plumbline/loaded/loading.hpp>

namespace plumbline::proofs {

/// What one is, of length and of stiffness: powers of two^32, so that a change is exact, and ordinary units
/// are left as they are.
struct Measures {
  double length, stiffness;

  [[nodiscard]] double force() const { return stiffness / length; }
  [[nodiscard]] double load(Control control) const { return control == Control::force ? force() : length; }
  [[nodiscard]] Measures inverse() const { return {1 / length, 1 / stiffness}; }
};

/// Those in which the longest link and the stiffest joint lie between 2^-16 and 2^16.
/// \throws Error where doubles do not hold forces in the units given
Measures measures_of(const Chain<double>& chain);

/// A power of two in another number type.
template <Analytic Real>
Real exactly(double power) {
  if constexpr (std::same_as<Real, Interval>) {
    return Interval::from_double(power);
  } else {
    return Real(power);
  }
}

/// Divided by the measures.
template <Analytic Real>
Chain<Real> measured(const Chain<Real>& chain, const Measures& m) {
  const auto divided = [](std::vector<Real> values, double unit) {
    for (Real& x : values) x = x / exactly<Real>(unit);
    return values;
  };
  return Chain<Real>(divided(chain.length(), m.length), divided(chain.stiffness(), m.stiffness),
                     chain.rest());
}
template <Analytic Real>
Loading<Real> measured(const Loading<Real>& loading, const Measures& m) {
  const Real unit = exactly<Real>(m.load(loading.control));
  return {loading.control, {loading.start.x / unit, loading.start.y / unit}, loading.direction};
}
Branch<double> measured(Branch<double> branch, const Measures& m, Control control);

/// What loads are measured in where units are left out: max L, or max k / max L.
double load_unit(const Chain<Interval>& chain, Control control);
/// Lengths as shares of max L, stiffnesses of max k, and the loading with them.
std::pair<Chain<Interval>, Loading<Interval>> without_units(const Chain<Interval>& chain,
                                                            const Loading<Interval>& loading);

}  // namespace plumbline::proofs
