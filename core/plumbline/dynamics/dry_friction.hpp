#pragma once
/// \file
/// The rates that dry friction leaves: those that stick are exactly zero.

#include <Eigen/Cholesky>
#include <plumbline/base/number.hpp>
#include <vector>

namespace plumbline {

/// Rates of given directions that balance: inertia v = momentum - limit sign(v) at those that move.
template <Floating Real>
Vector<Real> rates_in(const std::vector<int>& direction, const Matrix<Real>& inertia,
                      const Vector<Real>& momentum, const Vector<Real>& limit) {
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < momentum.size(); ++i)
    if (direction[static_cast<std::size_t>(i)] != 0) moving.push_back(i);
  Vector<Real> pushed(static_cast<Eigen::Index>(moving.size()));
  for (std::size_t k = 0; k < moving.size(); ++k)
    pushed(static_cast<Eigen::Index>(k)) =
        momentum(moving[k]) - limit(moving[k]) * direction[static_cast<std::size_t>(moving[k])];
  Vector<Real> rate = Vector<Real>::Zero(momentum.size());
  if (moving.empty()) return rate;
  const Matrix<Real> own = inertia(moving, moving);
  const Vector<Real> balanced = own.llt().solve(pushed);
  rate(moving) = balanced;
  return rate;
}

/// Whether all that move do so in their directions, and friction holds those that stick.
template <Floating Real>
bool balances(const Vector<Real>& rate, const std::vector<int>& direction, const Matrix<Real>& inertia,
              const Vector<Real>& momentum, const Vector<Real>& limit) {
  const Vector<Real> left = momentum - inertia * rate;
  for (Eigen::Index i = 0; i < rate.size(); ++i) {
    const int way = direction[static_cast<std::size_t>(i)];
    if (way != 0 ? !(rate(i) * way > Real(0)) : !(left(i) <= limit(i) && -left(i) <= limit(i))) return false;
  }
  return true;
}

/// Rates v with inertia v - momentum = -f, where f is limit sign(v) where v moves, and at most the limit
/// where it sticks: the minimum of v' inertia v / 2 - momentum' v + limit' |v|, which is one. A rate that
/// sticks is exactly zero.
///
/// Sweeps of coordinate descent find the directions; one solution of the linear system gives the rates.
/// \param inertia  symmetric, positive definite
/// \param momentum  that there would be without friction, N m s or N s
/// \param limit  impulse of sliding friction at each joint, zero or positive, N m s or N s
template <Floating Real>
Vector<Real> rates_under_dry_friction(const Matrix<Real>& inertia, const Vector<Real>& momentum,
                                      const Vector<Real>& limit) {
  using std::abs;
  constexpr int most_sweeps = 10000;  // a sweep gains at least a fixed part; the bound is for rounding alone
  Vector<Real> rate = Vector<Real>::Zero(momentum.size());
  std::vector<int> direction(static_cast<std::size_t>(momentum.size()), 2), tried = direction;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    for (Eigen::Index i = 0; i < rate.size(); ++i) {
      const Real push = momentum(i) - inertia.row(i).dot(rate) + inertia(i, i) * rate(i);
      const int way = abs(push) <= limit(i) ? 0 : push > Real(0) ? 1 : -1;
      direction[static_cast<std::size_t>(i)] = way;
      rate(i) = (push - limit(i) * way) / inertia(i, i) * (way == 0 ? 0 : 1);
    }
    if (direction == tried) continue;
    tried = direction;
    const Vector<Real> exact = rates_in(direction, inertia, momentum, limit);
    if (balances(exact, direction, inertia, momentum, limit)) return exact;
  }
  return rate;
}

}  // namespace plumbline
