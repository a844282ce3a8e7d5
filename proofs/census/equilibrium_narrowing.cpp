#include "proofs/census/equilibrium_box.hpp"

namespace plumbline::proofs {

namespace {

/// a Fx + b Fy = moment: about the base, or of a link.
struct ForceRow {
  Span a, b, moment;
};

bool finite(const Span& x) {
  return std::isfinite(x.low) && std::isfinite(x.high);
}

}  // namespace

bool EquilibriumBox::bounded_force(Box& z) const {
  std::array<ForceRow, most_links + 1> rows;
  const auto torque = [&](std::size_t i) { return i < n_ ? torque_in(z, i) : Span(0); };
  rows[0] = {-load_y_, load_x_, torque(0)};
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(z[i]);
    rows[i + 1] = {length_[i] * t.sine, -(length_[i] * t.cosine), torque(i + 1) - torque(i)};
  }
  Span &x = z[n_], &y = z[n_ + 1];
  const bool unbounded = !finite(x) || !finite(y);
  for (std::size_t i = 0; i <= n_ && unbounded; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ForceRow &r = rows[j], &s = rows[i];
      const Span det = r.a * s.b - r.b * s.a;
      if (det.contains(0)) continue;
      if (!bind(x, (r.moment * s.b - r.b * s.moment) / det)) return false;
      if (!bind(y, (r.a * s.moment - r.moment * s.a) / det)) return false;
    }
  }
  for (std::size_t i = 0; i <= n_; ++i) {
    const ForceRow& r = rows[i];
    if (!r.a.contains(0) && !bind(x, (r.moment - r.b * y) / r.a)) return false;
    if (!r.b.contains(0) && !bind(y, (r.moment - r.a * x) / r.b)) return false;
  }
  return true;
}

bool EquilibriumBox::narrow(Box& z) const {
  constexpr int rounds = 8;
  constexpr double newton_pays = 2;  // radians
  for (int round = 0; round < rounds; ++round) {
    double before = 0, after = 0, widest = 0;
    for (std::size_t j = 0; j < n_; ++j) before += z[j].width();
    if (!ranges(z) || (held_ && !bounded_force(z)) || !recursion(z)) return false;
    for (std::size_t j = 0; j < n_; ++j) widest = std::max(widest, z[j].width());
    if (finite(fx(z)) && finite(fy(z)) && widest < newton_pays && !newton(z)) return false;
    for (std::size_t j = 0; j < n_; ++j) after += z[j].width();
    if (after > 0.8 * before) break;
  }
  return true;
}

bool EquilibriumBox::contracts(const Midpoint& centre, double radius, double force_radius) const {
  Box point, box;
  std::array<double, most_links + 2> r;
  for (std::size_t j = 0; j < size_; ++j) {
    r[j] = j < n_ ? radius : force_radius;
    point[j] = Span(centre[j]);
    box[j] = Span(centre[j] - r[j], centre[j] + r[j]);
  }
  Matrix Y;
  if (!inverse_of_middle(derivative(point), Y)) return false;
  const Box f = residual(point);
  const SpanMatrix A = derivative(box);
  for (std::size_t i = 0; i < size_; ++i) {
    Span offset(0);
    double image = 0;
    for (std::size_t l = 0; l < size_; ++l) offset += Y.entry[i][l] * f[l];
    for (std::size_t j = 0; j < size_; ++j) {
      Span defect(i == j ? 1 : 0);
      for (std::size_t l = 0; l < size_; ++l) defect -= Y.entry[i][l] * A.entry[l][j];
      image += defect.magnitude() * r[j];
    }
    if (!(image + offset.magnitude() < 0.95 * r[i]))
      return false;  // well inside: the centre is rounded later
  }
  return true;
}

}  // namespace plumbline::proofs
