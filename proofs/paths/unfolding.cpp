#include "proofs/paths/unfolding.hpp"

#include "proofs/paths/measures.hpp"
#include "proofs/paths/moore_system.hpp"

namespace plumbline::proofs {
namespace {

using Index = Eigen::Index;

}  // namespace

bool unfolded(const Chain<Interval>& chain, const Loading<Interval>& loading, const Vector<double>& crossing,
              double distance) {
  const auto [bare, load] = without_units(chain, loading);
  const IntervalEquations equations(bare, load);
  const Index m = equations.size();
  const MooreSystem moore(equations, crossing);
  IntervalVector w(2 * m + 2);
  w.head(m + 1) = crossing.unaryExpr([=](double x) { return around(x, distance); });
  const auto psi = moore.null_vectors(w.head(m + 1));
  if (!psi) return false;
  w.segment(m + 1, m) = *psi;
  w(2 * m + 1) = Interval(Interval::End(-distance), Interval::End(distance));

  constexpr int rounds = 12;  // the width is squared in each
  for (int round = 0; round < rounds; ++round) {
    const IntervalVector centre =
        w.unaryExpr([](const Interval& x) { return Interval(x.middle(), x.middle()); });
    const IntervalVector step = moore(centre).first;
    const Matrix<Interval> A = moore(w).second;
    const Eigen::MatrixXd Y = inverse_of_middle(A);
    if (!Y.allFinite()) return false;
    IntervalVector image = centre - product(Y, step);
    const Matrix<Interval> D = defect(Y, A);
    for (Index i = 0; i < w.size(); ++i)
      for (Index j = 0; j < w.size(); ++j) image(i) = image(i) + D(i, j) * (w(j) - centre(j));
    if (!image(2 * m + 1).contains_zero()) return true;
    for (Index i = 0; i < w.size(); ++i) {
      if (certainly_less(image(i), w(i)) || certainly_less(w(i), image(i))) return false;
      w(i) = Interval(std::max(image(i).lower(), w(i).lower()), std::min(image(i).upper(), w(i).upper()));
    }
  }
  return false;
}

}  // namespace plumbline::proofs
