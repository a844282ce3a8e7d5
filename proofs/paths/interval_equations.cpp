#include "proofs/paths/interval_equations.hpp"

namespace plumbline::proofs {
namespace {

using Index = Eigen::Index;

}  // namespace

LocalEquations IntervalEquations::at(const IntervalVector& u, const IntervalVector& psi) const {
  const Index m = size();
  LocalEquations all{IntervalVector::Constant(m, Interval(0)),
                     Matrix<Interval>::Constant(m, m + 1, Interval(0)),
                     Matrix<Interval>::Constant(m + 1, m + 1, Interval(0))};
  const Point<Interval>& d = loading_->direction;
  const Point<Interval> ray{loading_->start.x + u(m) * d.x, loading_->start.y + u(m) * d.y};
  const Point<Interval> force = held_ ? Point<Interval>{u(n_), u(n_ + 1)} : ray;
  springs(u, all);
  if (held_) {
    all.value(n_) = -ray.x, all.value(n_ + 1) = -ray.y;
    all.derivative(n_, m) = -d.x, all.derivative(n_ + 1, m) = -d.y;
  }
  for (Index i = 0; i < n_; ++i) link(i, force, u(i), psi, all);
  return all;
}

void IntervalEquations::springs(const IntervalVector& u, LocalEquations& all) const {
  for (Index i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Interval &k = chain_->stiffness()[at],
                   moment = k * ((i > 0 ? u(i) - u(i - 1) : u(i)) - chain_->rest()[at]);
    all.value(i) = all.value(i) + moment;
    all.derivative(i, i) = all.derivative(i, i) + k;
    if (i == 0) continue;
    all.value(i - 1) = all.value(i - 1) - moment;
    all.derivative(i - 1, i - 1) = all.derivative(i - 1, i - 1) + k;
    all.derivative(i, i - 1) = all.derivative(i - 1, i) = -k;
  }
}

/// What link i contributes: L (Fx sin theta - Fy cos theta) to its moment, L (cos, sin) theta to the end
/// point.
void IntervalEquations::link(Index i, const Point<Interval>& force, const Interval& theta,
                             const IntervalVector& psi, LocalEquations& all) const {
  const Index m = size();
  const Interval& L = chain_->length()[static_cast<std::size_t>(i)];
  const Interval x = L * cos(theta), y = L * sin(theta);
  const Interval pull = force.x * y - force.y * x;
  auto& bend = all.bend;
  all.value(i) = all.value(i) + pull;
  all.derivative(i, i) = all.derivative(i, i) + force.x * x + force.y * y;
  bend(i, i) = -(psi(i) * pull);
  if (!held_) {
    const Point<Interval>& d = loading_->direction;
    all.derivative(i, m) = d.x * y - d.y * x;
    bend(i, m) = bend(m, i) = psi(i) * (d.x * x + d.y * y);
    return;
  }
  all.value(n_) = all.value(n_) + x, all.value(n_ + 1) = all.value(n_ + 1) + y;
  all.derivative(i, n_) = y, all.derivative(i, n_ + 1) = -x;
  all.derivative(n_, i) = -y, all.derivative(n_ + 1, i) = x;
  bend(i, i) = bend(i, i) - psi(n_) * x - psi(n_ + 1) * y;
  bend(i, n_) = bend(n_, i) = psi(i) * x;
  bend(i, n_ + 1) = bend(n_ + 1, i) = psi(i) * y;
}

}  // namespace plumbline::proofs
