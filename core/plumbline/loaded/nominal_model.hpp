#pragma once
/// \file
/// The nominal chain as a model that can be loaded, paper equations (6), (8): what paths, certificates, the
/// blind trial and the diagnosis all call nominal.

#include <plumbline/loaded/loaded_model.hpp>

namespace plumbline {

/// The nominal chain: rigid links, linear springs V = sum k_i (q_i - rest_i)^2 / 2, q_i = theta_i -
/// theta_(i-1), and the weight of the links where it is given, each at the middle of its link.
template <Analytic Number_>
class NominalModel {
 public:
  using Real = Number_;                ///< kind of number
  static constexpr int bandwidth = 1;  ///< of the Hessian: each link has a spring to its neighbours alone

  /// \param weight  force of gravity on each link; none where it is left out
  /// \throws Error where the weights are not one a link
  explicit NominalModel(Chain<Real> chain, const std::vector<Point<Real>>& weight = {})
      : chain_(std::move(chain)), carried_(weight) {
    if (weight.empty()) return;
    if (weight.size() != size())
      throw Error("weight", std::to_string(weight.size()) + " values",
                  "one per link, " + std::to_string(size()));
    Point<Real> beyond{Real(0), Real(0)};
    for (std::size_t j = size(); j-- > 0;) {
      carried_[j] = {beyond.x + weight[j].x / Real(2), beyond.y + weight[j].y / Real(2)};
      beyond = {beyond.x + weight[j].x, beyond.y + weight[j].y};
    }
  }

  [[nodiscard]] const Chain<Real>& chain() const { return chain_; }  ///< as given
  [[nodiscard]] std::size_t size() const { return chain_.size(); }   ///< links
  /// Energy, residual and derivatives at absolute link angles: see LoadedModel.
  void expand(const Vector<Real>& theta, const Point<Real>& force, Expansion<Real, 1>& at) const {
    using std::cos, std::sin;
    const auto n = static_cast<Eigen::Index>(size());
    at.residual.resize(n);
    at.hessian.resize(Eigen::NoChange, n);
    at.end_point_gradient.resize(n, Eigen::NoChange);
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
      const Point<Real> load = passed_on(j, force);
      at.residual(i) = torque + y * load.x - x * load.y;
      at.hessian(0, i) = k + x * load.x + y * load.y;
      at.hessian(1, i) = Real(0);
      if (i > 0) {
        at.residual(i - 1) = at.residual(i - 1) - torque;
        at.hessian(0, i - 1) = at.hessian(0, i - 1) + k;
        at.hessian(1, i - 1) = -k;
      }
    }
    at.energy = at.energy / Real(2);
    for (std::size_t j = 0; j < carried_.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      at.energy = at.energy - at.end_point_gradient(i, 1) * carried_[j].x +
                  at.end_point_gradient(i, 0) * carried_[j].y;
    }
    at.force_gradient = at.end_point_gradient;
    at.compliance.setConstant(Real(0));
  }
  /// Of residual and end point along two variations: see LoadedModel.
  void second_derivative(const Expansion<Real, 1>& at, const Point<Real>& force, const Variation<Real>& v,
                         const Variation<Real>& w, Vector<Real>& moment, Point<Real>& place) const {
    const Eigen::Index n = v.theta.size();
    moment.resize(n);
    place.x = place.y = Real(0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Real x = at.end_point_gradient(i, 1), y = -at.end_point_gradient(i, 0);  // of link i
      const Real turn = v.theta(i) * w.theta(i);
      const Point<Real> load = passed_on(static_cast<std::size_t>(i), force);
      moment(i) = (x * load.y - y * load.x) * turn + x * (v.theta(i) * w.force.x + w.theta(i) * v.force.x) +
                  y * (v.theta(i) * w.force.y + w.theta(i) * v.force.y);
      place.x = place.x - x * turn;
      place.y = place.y - y * turn;
    }
  }

  /// The rest of the equations is linear.
  void begin_series(const Expansion<Real, 1>& at, Eigen::Index order, LinkSeries<Real>& links) const {
    links.begin(at.end_point_gradient, order, carried_);
  }

  /// \throws Error where the end point p is out of reach, on the edge of reach (where only the stretched or
  ///         folded chain fits, and the force along it is open), or where the chain has a single link
  void require_reach(const Point<Real>& p) const requires Ordered<Real> {
    if (size() == 1)
      throw Error("end point", "a chain of one link", "two links or more: one leaves no freedom");
    const auto [inner, outer] = reach(chain_.length());
    const Real square = p.x * p.x + p.y * p.y;
    if (!(square < outer * outer) || (inner > Real(0) && !(square > inner * inner))) {
      using std::sqrt;
      const auto text = [](const Real& x) { return std::to_string(static_cast<double>(x)); };
      throw Error(
          "end point", "distance " + text(sqrt(square)) + " from the base",
          "between " + text(inner) + " and " + text(outer) + ", both excluded: the reach of the chain");
    }
  }

 private:
  /// The force that link j passes on, at its middle: the end force and the weights from there on.
  [[nodiscard]] Point<Real> passed_on(std::size_t j, const Point<Real>& force) const {
    if (carried_.empty()) return force;
    return {force.x + carried_[j].x, force.y + carried_[j].y};
  }

  Chain<Real> chain_;
  std::vector<Point<Real>> carried_;  ///< weight beyond the middle of each link; empty without weight
};

}  // namespace plumbline
