#include "tests/proofs/exact/dense_factors.hpp"

#include <Eigen/Eigenvalues>

using namespace plumbline;

namespace {

using Square = Matrix<Mpfr50>;
using Form = std::vector<Mpfr50>;  ///< a linear form in the deflections that are unknown

/// What each node's deflection is: one of the unknowns, or nought (-1).
std::vector<Eigen::Index> numbered(const Structure<Mpfr50>& structure) {
  const std::size_t n = structure.chain.size();
  std::vector<std::size_t> moves_with(n + 1);
  for (std::size_t i = 0; i <= n; ++i) moves_with[i] = i;
  if (structure.base.turn.is_held()) moves_with[1] = 0;
  if (structure.end_point.turn.is_held()) moves_with[n] = moves_with[n - 1];
  std::vector<bool> nought(n + 1, false);
  for (std::size_t i = 0; i <= n; ++i) {
    if (structure.across_at(i).is_held()) nought[moves_with[i]] = true;
  }
  std::vector<Eigen::Index> number(n + 1, -1);
  Eigen::Index count = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    if (nought[moves_with[i]]) continue;
    number[i] = moves_with[i] == i ? count++ : number[moves_with[i]];
  }
  return number;
}

void add_square(Square& to, const Form& form, const Mpfr50& factor) {
  for (std::size_t i = 0; i < form.size(); ++i) {
    for (std::size_t j = 0; j < form.size(); ++j)
      to(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) += factor * form[i] * form[j];
  }
}

/// C^-1 G C^-T, where K = C C^T.
Square reduced(Square K, Square G) {
  const Eigen::Index n = K.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index k = 0; k < j; ++k) {
      for (Eigen::Index i = j; i < n; ++i) K(i, j) -= K(i, k) * K(j, k);
    }
    const Mpfr50 root = sqrt(K(j, j));
    for (Eigen::Index i = j; i < n; ++i) K(i, j) /= root;
  }
  for (int side = 0; side < 2; ++side) {
    for (Eigen::Index column = 0; column < n; ++column) {
      for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index k = 0; k < i; ++k) G(i, column) -= K(i, k) * G(k, column);
        G(i, column) /= K(i, i);
      }
    }
    G.transposeInPlace();
  }
  return G;
}

}  // namespace

std::vector<Mpfr50> dense_factors(const Structure<Rational>& exact) {
  const auto structure = from_rational<Mpfr50>(exact);
  const std::vector<Eigen::Index> number = numbered(structure);
  const Eigen::Index unknowns = *std::max_element(number.begin(), number.end()) + 1;
  const std::size_t n = structure.chain.size();
  const auto deflection = [&](std::size_t node) {
    Form form(static_cast<std::size_t>(unknowns), Mpfr50(0));
    if (number[node] >= 0) form[static_cast<std::size_t>(number[node])] = 1;
    return form;
  };
  const auto difference = [](Form a, const Form& b, const Mpfr50& factor) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = (a[i] - b[i]) * factor;
    return a;
  };
  const auto slope = [&](std::size_t link) {
    return difference(deflection(link + 1), deflection(link), 1 / structure.chain.length()[link]);
  };
  Square K = Square::Constant(unknowns, unknowns, Mpfr50(0)), G = K;
  for (std::size_t i = 0; i < n; ++i) {
    add_square(K, i == 0 ? slope(0) : difference(slope(i), slope(i - 1), 1), structure.chain.stiffness()[i]);
    for (const auto& load : structure.loads) {
      if (load.node > i)
        add_square(load.multiplied ? G : K, slope(i),
                   (load.multiplied ? -1 : 1) * load.force.x * structure.chain.length()[i]);
    }
  }
  add_square(K, slope(n - 1), structure.end_point.turn.stiffness);
  for (std::size_t i = 0; i <= n; ++i) add_square(K, deflection(i), structure.across_at(i).stiffness);
  const Eigen::SelfAdjointEigenSolver<Square> solver(reduced(K, G), Eigen::EigenvaluesOnly);
  std::vector<Mpfr50> factors;
  for (Eigen::Index i = unknowns; i-- > 0;) {
    if (solver.eigenvalues()(i) > Mpfr50("1e-30")) factors.push_back(1 / solver.eigenvalues()(i));
  }
  return factors;
}
