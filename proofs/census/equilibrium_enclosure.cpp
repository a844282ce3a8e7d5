#include "proofs/census/equilibrium_enclosure.hpp"

#include <Eigen/LU>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {

namespace {

using Exact = NominalModel<Interval>;
using Unknowns = std::vector<Interval>;

Mpfr50 middle(const Interval& x) {
  return Mpfr50(x.middle());
}

/// Unknowns theta and, where held, F, of the root in fifty digits.
std::vector<Mpfr50> refine(const Chain<Interval>& chain, Control control, const Point<Interval>& load,
                           const Box& box) {
  const NominalModel<Mpfr50> model(convert<Mpfr50>(chain, middle));
  const auto n = static_cast<Eigen::Index>(chain.size());
  Vector<Mpfr50> theta(n);
  for (Eigen::Index j = 0; j < n; ++j) theta(j) = Mpfr50(box[static_cast<std::size_t>(j)].middle());
  EquilibriumSolver<NominalModel<Mpfr50>> solver(model);
  const Point<Mpfr50> at{middle(load.x), middle(load.y)};
  const bool held = control == Control::end_point;
  const std::size_t f = chain.size();
  const auto found =
      held ? solver.at_end_point(at, theta, {Mpfr50(box[f].middle()), Mpfr50(box[f + 1].middle())})
           : solver.under_force(at, theta);
  std::vector<Mpfr50> z(found.theta.begin(), found.theta.end());
  if (held) z.push_back(found.force.x), z.push_back(found.force.y);
  return z;
}

/// The equations and their derivative, dense, over intervals.
struct LoadedEquations {
  Unknowns value;
  Matrix<Interval> derivative;
  Expansion<Interval, 1> at;
};

LoadedEquations equations(const Exact& model, Control control, const Point<Interval>& load,
                          const Unknowns& z) {
  const auto n = static_cast<Eigen::Index>(model.size());
  const bool held = control == Control::end_point;
  Vector<Interval> theta(n);
  for (Eigen::Index j = 0; j < n; ++j) theta(j) = z[static_cast<std::size_t>(j)];
  const Point<Interval> force = held ? Point<Interval>{z[model.size()], z[model.size() + 1]} : load;
  LoadedEquations e;
  model.expand(theta, force, e.at);
  const auto size = static_cast<Eigen::Index>(z.size());
  e.derivative = Matrix<Interval>::Constant(size, size, Interval(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    e.value.push_back(e.at.residual(i));
    e.derivative(i, i) = e.at.hessian(0, i);
    if (i + 1 < n) e.derivative(i, i + 1) = e.derivative(i + 1, i) = e.at.hessian(1, i);
    for (Eigen::Index a = 0; a < size - n; ++a) {
      e.derivative(i, n + a) = -e.at.force_gradient(i, a);
      e.derivative(n + a, i) = e.at.end_point_gradient(i, a);
    }
  }
  if (held) {
    e.value.push_back(e.at.end_point.x - load.x);
    e.value.push_back(e.at.end_point.y - load.y);
  }
  return e;
}

Matrix<Span> rounded(const Matrix<Interval>& A) {
  return A.unaryExpr([](const Interval& x) { return Span(x); });
}

/// Krawczyk's operator over the box of a radius around m; nothing unless it maps the box strictly into
/// itself.
std::optional<Unknowns> krawczyk(const Exact& model, Control control, const Point<Interval>& load,
                                 const std::vector<Mpfr50>& m, const Mpfr50& radius) {
  Unknowns point, box;
  for (const Mpfr50& x : m) {
    const Interval::End low(x - radius), high(x + radius), centre(x);
    point.emplace_back(centre, centre);
    box.emplace_back(low, high);
  }
  const LoadedEquations at_point = equations(model, control, load, point),
                        over_box = equations(model, control, load, box);
  const Eigen::MatrixXd Y = middle(rounded(over_box.derivative)).inverse();
  const Eigen::Index size = Y.rows();
  if (!Y.allFinite()) return std::nullopt;
  Unknowns image;
  for (Eigen::Index i = 0; i < size; ++i) {
    Interval sum = point[static_cast<std::size_t>(i)];
    for (Eigen::Index l = 0; l < size; ++l)
      sum -= Interval::from_double(Y(i, l)) * at_point.value[static_cast<std::size_t>(l)];
    for (Eigen::Index j = 0; j < size; ++j) {
      Interval defect(i == j ? 1 : 0);
      for (Eigen::Index l = 0; l < size; ++l)
        defect -= Interval::from_double(Y(i, l)) * over_box.derivative(l, j);
      const auto c = static_cast<std::size_t>(j);
      sum += defect * (box[c] - point[c]);
    }
    const auto r = static_cast<std::size_t>(i);
    if (!(box[r].lower() < sum.lower() && sum.upper() < box[r].upper())) return std::nullopt;
    image.push_back(sum);
  }
  return image;
}

/// K is symmetric in (theta, -F), where each border adds one negative eigenvalue.
std::optional<std::size_t> negative_directions(const LoadedEquations& e, Control control) {
  Matrix<Span> K = rounded(e.derivative);
  const Eigen::Index size = K.rows(), borders = control == Control::end_point ? 2 : 0;
  for (Eigen::Index a = size - borders; a < size; ++a) {
    for (Eigen::Index i = 0; i < size; ++i) K(i, a) = -K(i, a);
  }
  const auto negative = negative_eigenvalues(K);
  if (!negative) return std::nullopt;
  return *negative - static_cast<std::size_t>(borders);
}

}  // namespace

std::optional<CertifiedEquilibrium> enclose(const Chain<Interval>& chain, Control control,
                                            const Point<Interval>& load, const Box& isolated) {
  const Exact model(chain);
  std::optional<Unknowns> z;
  try {
    const std::vector<Mpfr50> root = refine(chain, control, load, isolated);
    // from the tightest box that Newton's last digits allow; wider where the root is ill conditioned
    for (Mpfr50 radius("1e-45"); !z && radius < Mpfr50("1e-9"); radius *= 1000)
      z = krawczyk(model, control, load, root, radius);
  } catch (const Error&) {  // Newton's method does not settle
  }
  if (!z) return std::nullopt;
  for (std::size_t j = 0; j < z->size(); ++j) {
    if (!Span((*z)[j]).inside(isolated[j])) return std::nullopt;
  }
  const LoadedEquations e = equations(model, control, load, *z);
  CertifiedEquilibrium found;
  for (std::size_t j = 0; j < chain.size(); ++j) found.q.push_back(j > 0 ? (*z)[j] - (*z)[j - 1] : (*z)[j]);
  const bool held = control == Control::end_point;
  found.fx = held ? (*z)[chain.size()] : load.x;
  found.fy = held ? (*z)[chain.size() + 1] : load.y;
  found.x = held ? load.x : e.at.end_point.x;
  found.y = held ? load.y : e.at.end_point.y;
  found.energy = e.at.energy;
  found.negative_directions = negative_directions(e, control);
  return found;
}

}  // namespace plumbline::proofs
