#pragma once
/// \file
/// Direct kinematics of the planar chain, paper equations (4), (5), (12), (21), (23).
///
/// \code{.cpp}
/// const Chain<double> chain({2, 1}, {1, 1});
/// const double right_angle = std::acos(-1.0) / 2;
/// const Point<double> tip = end_point(chain, {right_angle, -right_angle});  // up, then along x
/// assert(std::abs(tip.x - 1) < 1e-15 && std::abs(tip.y - 2) < 1e-15);
/// const Matrix<double> J = jacobian(chain, {right_angle, -right_angle});
/// assert(J.cols() == 2 && std::abs(J(0, 0) + tip.y) < 1e-15);  // about the base the end point turns
/// \endcode

#include <plumbline/chain/chain.hpp>

namespace plumbline {

/// End point in the base frame: x along the straight chain, y to its left.
template <Number Real>
struct Point {
  Real x;  ///< along the straight chain
  Real y;  ///< to its left
};

/// Absolute link orientations theta_j = q_1 + … + q_j.
template <Number Real>
std::vector<Real> orientations(const std::vector<Real>& q) {
  std::vector<Real> theta(q.size());
  Real sum(0);
  for (std::size_t j = 0; j < q.size(); ++j) theta[j] = sum = sum + q[j];
  return theta;
}

/// End point (x, y) = sum_j L_j (cos theta_j, sin theta_j) at the joint angles q (n of them).
/// The deflection of (21) from the straight chain is (sum L - x, y).
template <Analytic Real>
Point<Real> end_point(const Chain<Real>& chain, const std::vector<Real>& q) {
  using std::cos, std::sin;
  Point<Real> p{Real(0), Real(0)};
  const std::vector<Real> theta = orientations(q);
  for (std::size_t j = 0; j < chain.size(); ++j) {
    p.x = p.x + chain.length()[j] * cos(theta[j]);
    p.y = p.y + chain.length()[j] * sin(theta[j]);
  }
  return p;
}

/// Where joints 1 … n are, and last the end point; joint 1 is at the base.
template <Analytic Real>
std::vector<Point<Real>> joint_places(const Chain<Real>& chain, const std::vector<Real>& q) {
  using std::cos, std::sin;
  std::vector<Point<Real>> places{{Real(0), Real(0)}};
  const std::vector<Real> theta = orientations(q);
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const Point<Real>& last = places.back();
    places.push_back(
        {last.x + chain.length()[j] * cos(theta[j]), last.y + chain.length()[j] * sin(theta[j])});
  }
  return places;
}

/// Smallest and largest distance of the end point from the base.
template <Number Real>
struct Reach {
  Real smallest /** when folded */, largest /** when stretched */;
};

/// Largest for the stretched chain; smallest for the folded one, zero unless one link is longer than all
/// others together.
template <Ordered Real>
Reach<Real> reach(const std::vector<Real>& length) {
  Real sum(0), longest(0);
  for (const Real& L : length) {
    sum += L;
    if (L > longest) longest = L;
  }
  const Real inner = longest + longest - sum;
  return {inner > Real(0) ? inner : Real(0), sum};
}

/// Jacobian (23), 2 x n: column i holds the derivative of (x, y) with respect to q_i.
template <Analytic Real>
Matrix<Real> jacobian(const Chain<Real>& chain, const std::vector<Real>& q) {
  using std::cos, std::sin;
  const auto n = static_cast<Eigen::Index>(chain.size());
  Matrix<Real> J(2, n);
  const std::vector<Real> theta = orientations(q);
  Real x(0), y(0);
  for (Eigen::Index i = n; i-- > 0;) {
    const auto j = static_cast<std::size_t>(i);
    x = x + chain.length()[j] * cos(theta[j]);
    y = y + chain.length()[j] * sin(theta[j]);
    J(0, i) = -y;
    J(1, i) = x;
  }
  return J;
}

}  // namespace plumbline
