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

/// Something that can be loaded: `size()` angles, `expand(theta, F, expansion)`, and `reach(p)`, which throws
/// an Error where the end point cannot be, or leaves no freedom.
template <class M>
concept LoadedModel = requires(const M& model, const Vector<typename M::Real>& theta,
                               const Point<typename M::Real>& load,
                               Expansion<typename M::Real, M::bandwidth>& at) {
  { model.size() } -> std::convertible_to<std::size_t>;
  model.expand(theta, load, at);
  model.require_reach(load);
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

/// The nominal chain: rigid links, linear springs V = sum k_i (q_i - rest_i)^2 / 2, q_i = theta_i -
/// theta_(i-1).
template <Analytic Number_>
class NominalModel {
 public:
  /// The number type.
  using Real = Number_;
  /// Half-width of the Hessian: neighbours alone share a spring.
  static constexpr int bandwidth = 1;

  /// Of a chain, which is copied.
  explicit NominalModel(Chain<Real> chain) : chain_(std::move(chain)) {}

  /// The chain.
  [[nodiscard]] const Chain<Real>& chain() const { return chain_; }
  /// Number of links.
  [[nodiscard]] std::size_t size() const { return chain_.size(); }

  /// The model at a shape and a force, to second order.
  void expand(const Vector<Real>& theta, const Point<Real>& force, Expansion<Real, 1>& at) const {
    using std::cos, std::sin;
    const auto n = static_cast<Eigen::Index>(size());
    at.residual.resize(n);
    at.hessian.resize(2, n);
    at.end_point_gradient.resize(n, 2);
    at.energy = at.end_point.x = at.end_point.y = Real(0);
    Real torque(0);  // of joint i
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(i);
      const Real &k = chain_.stiffness()[j], &L = chain_.length()[j];
      const Real d = (i > 0 ? Real(theta(i) - theta(i - 1)) : theta(i)) - chain_.rest()[j];
      torque = k * d;
      at.energy = at.energy + torque * d;
      const Real x = L * cos(theta(i)), y = L * sin(theta(i));
      at.end_point.x = at.end_point.x + x;
      at.end_point.y = at.end_point.y + y;
      at.end_point_gradient(i, 0) = -y;
      at.end_point_gradient(i, 1) = x;
      at.residual(i) = torque + y * force.x - x * force.y;
      at.hessian(0, i) = k + x * force.x + y * force.y;
      at.hessian(1, i) = Real(0);
      if (i > 0) {
        at.residual(i - 1) = at.residual(i - 1) - torque;
        at.hessian(0, i - 1) = at.hessian(0, i - 1) + k;
        at.hessian(1, i - 1) = -k;
      }
    }
    at.energy = at.energy / Real(2);
    at.force_gradient = at.end_point_gradient;
    at.compliance.setConstant(Real(0));
  }

  /// Second derivative of the equations in the directions v and w: its moments, and of the end point.
  void second_derivative(const Expansion<Real, 1>& at, const Point<Real>& force, const Variation<Real>& v,
                         const Variation<Real>& w, Vector<Real>& moment, Point<Real>& place) const {
    const Eigen::Index n = v.theta.size();
    moment.resize(n);
    place.x = place.y = Real(0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Real x = at.end_point_gradient(i, 1), y = -at.end_point_gradient(i, 0);  // of link i
      const Real turn = v.theta(i) * w.theta(i);
      moment(i) = (x * force.y - y * force.x) * turn + x * (v.theta(i) * w.force.x + w.theta(i) * v.force.x) +
                  y * (v.theta(i) * w.force.y + w.theta(i) * v.force.y);
      place.x = place.x - x * turn;
      place.y = place.y - y * turn;
    }
  }

  /// The rest of the equations is linear.
  void begin_series(const Expansion<Real, 1>& at, Eigen::Index order, LinkSeries<Real>& links) const {
    links.begin(at.end_point_gradient, order);
  }

  /// \throws Error where the end point p is out of reach, on the edge of reach (where only the stretched or
  ///         folded chain fits, and the force along it is open), or where the chain has a single link
  void require_reach(const Point<Real>& p) const requires Ordered<Real> {
    if (size() == 1)
      throw Error("end point", "a chain of one link", "two links or more: one leaves no freedom");
    const auto& length = chain_.length();
    Real sum(0), longest(0);
    for (const Real& L : length) {
      sum += L;
      if (L > longest) longest = L;
    }
    const Real square = p.x * p.x + p.y * p.y, inner = longest + longest - sum;
    if (!(square < sum * sum) || (inner > Real(0) && !(square > inner * inner))) {
      using std::sqrt;
      const auto text = [](const Real& x) { return std::to_string(static_cast<double>(x)); };
      throw Error("end point", "distance " + text(sqrt(square)) + " from the base",
                  "between " + text(inner > Real(0) ? inner : Real(0)) + " and " + text(sum) +
                      ", both excluded: the reach of the chain");
    }
  }

 private:
  Chain<Real> chain_;
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
