#pragma once
/// \file
/// What a chain under load is to the solvers: its energy and its end point, to second order, in the absolute
/// angles theta_j = q_1 + … + q_j.

#include <plumbline/base/bordered_band.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/link_series.hpp>

namespace plumbline {

/// A model at (theta, F) to second order. With the stored energy V and the end point p, the equilibria under
/// the force F that the environment exerts on the end point are the zeros of `residual`, V' - (p')^T F.
template <Number Real, int Bandwidth>
struct Expansion {
  Real energy;                    ///< stored energy: springs, and weight where a model has it
  Vector<Real> residual;          ///< n: moment that is missing, conjugate to theta
  Band<Real, Bandwidth> hessian;  ///< derivative of the residual with respect to theta
  Point<Real> end_point;          ///< the point whose place is imposed, or read
  Eigen::Matrix<Real, Eigen::Dynamic, 2> end_point_gradient;  ///< n x 2: its derivative, transposed
  Eigen::Matrix<Real, Eigen::Dynamic, 2> force_gradient;  ///< n x 2: minus the residual's derivative by F;
                                                          ///< equal to the above but for eccentric loads
  Eigen::Matrix<Real, 2, 2> compliance;  ///< derivative of the end point by F at fixed theta; 0 if rigid
};

/// Something that can be loaded: `size()` angles and `expand(theta, F, expansion)`. A model whose reach is
/// known beforehand has `require_reach(p)` too, which throws an Error where the end point cannot be, or
/// leaves no freedom.
template <class M>
concept LoadedModel = requires(const M& model, const Vector<typename M::Real>& theta,
                               const Point<typename M::Real>& load,
                               Expansion<typename M::Real, M::bandwidth>& at) {
  { model.size() } -> std::convertible_to<std::size_t>;
  model.expand(theta, load, at);
};

/// A change of shape, force and load; a tangent of a branch, for one.
template <Number Real>
struct Variation {
  Vector<Real> theta;  ///< of the absolute angles
  Point<Real> force;   ///< of the force on the end point
  Real load;           ///< of the load
};

/// A model whose branches can be followed: `second_derivative(at, F, v, w, moment, place)` gives, where the
/// model was expanded, the second derivative of residual (n) and end point in the directions v and w; and its
/// nonlinear part is that of links that turn, `begin_series(at, order, links)`.
template <class M>
concept SmoothModel = LoadedModel<M> && Floating<typename M::Real> &&
    requires(const M& model, const Expansion<typename M::Real, M::bandwidth>& at,
             const Point<typename M::Real>& force, const Variation<typename M::Real>& v,
             Vector<typename M::Real>& moment, Point<typename M::Real>& place,
             LinkSeries<typename M::Real>& links) {
  model.second_derivative(at, force, v, v, moment, place);
  model.begin_series(at, 1, links);
};

/// Relative joint angles q of absolute ones.
template <Number Real>
std::vector<Real> joint_angles(const Vector<Real>& theta) {
  std::vector<Real> q(static_cast<std::size_t>(theta.size()));
  for (Eigen::Index i = 0; i < theta.size(); ++i)
    q[static_cast<std::size_t>(i)] = i > 0 ? Real(theta(i) - theta(i - 1)) : theta(i);
  return q;
}

/// Absolute angles of relative ones; of the unloaded shape, say.
template <Number Real>
Vector<Real> absolute_angles(const std::vector<Real>& q) {
  const std::vector<Real> theta = orientations(q);
  return Eigen::Map<const Vector<Real>>(theta.data(), static_cast<Eigen::Index>(theta.size()));
}

}  // namespace plumbline
