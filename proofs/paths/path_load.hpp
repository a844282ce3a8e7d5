#pragma once
/// \file
/// The load that a path is followed to.

#include <cmath>

#include "proofs/paths/followed_path.hpp"
#include "proofs/paths/joined_branches.hpp"
#include "proofs/paths/measures.hpp"

namespace plumbline::proofs {

/// Straight from the unloaded state: how far the end point is moved from where it is unloaded, or the force
/// that is reached.
struct PathLoad {
  Control control;
  Point<double> by;

  /// Of any length.
  [[nodiscard]] Point<Rational> direction() const { return {Rational(by.x), Rational(by.y)}; }
};

/// The load as a ray from the unloaded state, and how far it goes along it.
template <Analytic Real>
std::pair<Loading<Real>, Real> loading_of(const PathLoad& load, const Chain<Real>& chain) {
  const Real x = exactly<Real>(load.by.x), y = exactly<Real>(load.by.y);
  const auto length = [&] {
    using std::sqrt;
    if constexpr (std::same_as<Real, double>) {
      return std::hypot(x, y);  // also where the squares are not to be held
    } else {
      return Real(sqrt(x * x + y * y));
    }
  };
  const Real size = length();
  const bool held = load.control == Control::end_point;
  const Point<Real> start = held ? end_point(chain, chain.rest()) : Point<Real>{Real(0), Real(0)};
  return {{load.control, start, {x / size, y / size}}, size};
}

/// \param step, side  as in PathTask
/// \throws Error for a load that is zero or not finite, or an end point out of reach
PathTask path_task(const Chain<Rational>& chain, const PathLoad& load, double step, int side);

/// Proves what was followed.
JoinedBranches certify(const PathReport& report, const Chain<Rational>& chain, const PathLoad& load,
                       ProvedPoints points);

}  // namespace plumbline::proofs
