#include "proofs/paths/regular_tube.hpp"

#include <Eigen/LU>

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {

namespace {

constexpr int most_rounds = 12;

/// R x for entries that are not negative, rounded up.
Vector<double> bound(const Eigen::MatrixXd& R, const Vector<double>& x) {
  const auto rounded_terms = static_cast<double>(2 * R.cols() + 2);
  return (R * x).unaryExpr([=](double sum) { return Span::up(sum, rounded_terms); });
}

/// |I - Y M|
Eigen::MatrixXd defect(const Eigen::MatrixXd& Y, const Matrix<Span>& M) {
  const Eigen::Index size = Y.rows();
  Matrix<Span> D = Matrix<Span>::Constant(size, size, Span(0));
  for (Eigen::Index j = 0; j < size; ++j) {
    D(j, j) = Span(1);
    for (Eigen::Index l = 0; l < size; ++l) {
      if (M(l, j).low == 0 && M(l, j).high == 0) continue;
      for (Eigen::Index i = 0; i < size; ++i) D(i, j) -= Y(i, l) * M(l, j);
    }
  }
  return D.unaryExpr(magnitude_of);
}

/// Widens a box around all the centres until it is mapped into its inside.
/// \param margin  how much wider than its image a box is tried
/// \param offset  z as a function of Y
template <class Offset>
std::optional<Tube> inflate(TubeEquations& equations, const Vector<Span>& centres, const Vector<Span>& normal,
                            double margin, Offset offset) {
  Tube tube;
  tube.inverse = middle(equations.derivative(centres, normal)).inverse();
  if (!tube.inverse.allFinite()) return std::nullopt;
  const Vector<double> z = offset(tube.inverse);
  const auto wider = [=](const Vector<double>& m) -> Vector<double> {
    return margin * (m + Vector<double>::Constant(m.size(), 1e-15));
  };
  tube.radius = wider(z);
  for (int round = 0; round < most_rounds; ++round) {
    const Matrix<Span> M = equations.derivative(widened(centres, tube.radius), normal);
    tube.defect = defect(tube.inverse, M);
    tube.image = bound(tube.defect, tube.radius);
    for (Eigen::Index i = 0; i < z.size(); ++i) tube.image(i) = Span::up(tube.image(i) + z(i));
    if (!tube.image.allFinite()) return std::nullopt;
    if ((tube.image.array() < tube.radius.array()).all()) return tube;
    tube.radius = wider(tube.image);
  }
  return std::nullopt;
}

}  // namespace

Vector<Span> product(const Eigen::MatrixXd& Y, const Vector<Span>& x) {
  Vector<Span> result = Vector<Span>::Constant(Y.rows(), Span(0));
  for (Eigen::Index j = 0; j < Y.cols(); ++j) {
    for (Eigen::Index i = 0; i < Y.rows(); ++i) result(i) += Y(i, j) * x(j);
  }
  return result;
}

Vector<Span> hull(const Vector<Span>& a, const Vector<Span>& b) {
  return a.binaryExpr(b, [](const Span& x, const Span& y) { return hull(x, y); });
}

Vector<Span> widened(const Vector<Span>& centre, const Vector<double>& radius) {
  return centre.binaryExpr(radius.cast<Span>(),
                           [](const Span& x, const Span& r) { return hull(x - r, x + r); });
}

std::optional<Tube> tube_along(TubeEquations& equations, const Vector<Span>& a, const Vector<Span>& b,
                               const Vector<Span>& normal) {
  const Vector<Span> chord = hull(a, b), first = equations.value(a), last = equations.value(b);
  const Vector<Span> second = equations.second(chord, b - a, b - a);
  const Span share(0, 0.125);  // s (1 - s) / 2
  return inflate(equations, chord, normal, 4, [&](const Eigen::MatrixXd& Y) -> Vector<double> {
    const Vector<Span> ends = hull(product(Y, first), product(Y, last)), between = product(Y, second);
    return ends.binaryExpr(between, [&](const Span& x, const Span& y) { return x - share * y; })
        .unaryExpr(magnitude_of);
  });
}

std::optional<Tube> tube_at(TubeEquations& equations, const Vector<Span>& point,
                            const Vector<Span>& normals) {
  const Vector<Span> value = equations.value(point);
  return inflate(equations, point, normals, 1.25, [&](const Eigen::MatrixXd& Y) -> Vector<double> {
    return product(Y, value).unaryExpr(magnitude_of);
  });
}

Vector<Span> solve(const Tube& tube, const Vector<Span>& preconditioned) {
  // x = Y y + (I - Y M) x, so that v = |x - Y y| <= R |Y y| + R v: whatever satisfies the inequality turned
  // round bounds v, for R contracts. A multiple of the radius does, and each round makes it less.
  const Vector<double> size = preconditioned.unaryExpr(magnitude_of), r = bound(tube.defect, size),
                       Rm = bound(tube.defect, tube.radius);
  double factor = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    factor = std::max(factor, Span::up(r(i) / Span::down(tube.radius(i) - Rm(i)), 2));
  Vector<double> v = (factor * tube.radius).unaryExpr([](double x) { return Span::up(x); });
  for (int round = 0; round < most_rounds; ++round) {
    const Vector<double> next = bound(tube.defect, v);
    for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = std::min(v(i), Span::up(r(i) + next(i)));
  }
  return widened(preconditioned, v);
}

Vector<Span> tangent(const Tube& tube) {
  return solve(tube, tube.inverse.rightCols<1>().cast<Span>());
}

std::array<Vector<Span>, 3> rates(BranchEquations& equations, const Tube& tube,
                                  const Vector<Span>& everywhere) {
  // 0 = E' u' = E' u'' + E'' u' u' = E' u''' + 3 E'' u' u'' + E''' u' u' u'
  const auto answer = [&tube](const Vector<Span>& right) -> Vector<Span> {
    return solve(tube, -product(tube.inverse, right));
  };
  const Vector<Span> first = tangent(tube), second = answer(equations.second(everywhere, first, first));
  const Vector<Span> bent = equations.second(everywhere, first, second);
  return {first, second, answer(equations.third(everywhere, first) + Span(3) * bent)};
}

}  // namespace plumbline::proofs
