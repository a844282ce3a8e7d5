#include "proofs/exact/follower.hpp"

#include "proofs/exact/exact_matrix.hpp"
#include "proofs/exact/real_roots.hpp"

namespace plumbline::proofs {
namespace {

Matrix<Rational> mass_matrix(const StraightMotion<Rational>& motion) {
  const Eigen::Index n = motion.stiffness.rows();
  Matrix<Rational> M = Matrix<Rational>::Constant(n, n, Rational(0));
  for (Eigen::Index i = 0; i < n; ++i) M(i, i) = motion.mass[static_cast<std::size_t>(i)];
  return M;
}

/// The polynomial of degree below `count` that a function of the factor is.
template <class Function>
Polynomial interpolated(std::size_t count, const Function& function) {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(function(Rational(i)));
  return interpolate(values);
}

/// Where stability can be lost: a frequency is zero, or two are equal.
Polynomial losses(const StraightMotion<Rational>& motion) {
  const auto n = static_cast<std::size_t>(motion.stiffness.rows());
  const Polynomial zero = interpolated(n + 1, [&](const Rational& factor) {
    return determinant(Matrix<Rational>(motion.stiffness - factor * motion.load));
  });
  const Polynomial equal = interpolated(n * (n - 1) + 1, [&](const Rational& factor) {
    return discriminant(characteristic_polynomial(motion, factor));
  });
  Polynomial product(zero.size() + equal.size() - 1, Rational(0));
  for (std::size_t i = 0; i < zero.size(); ++i) {
    for (std::size_t j = 0; j < equal.size(); ++j) product[i + j] += zero[i] * equal[j];
  }
  return product;
}

StabilityLoss loss_in(const StraightMotion<Rational>& motion, NarrowBracket at, bool first) {
  return {motion_at(motion, at.high), std::move(at.low), std::move(at.high), std::move(at.decimal), first};
}

StabilityLoss first_of_all(const StraightMotion<Rational>& motion, int digits) {
  const PositiveRoots roots(losses(motion));
  Rational from = 0;
  while (const auto root = roots.next(from)) {
    from = root->high;
    if (motion_at(motion, root->high) == Motion::stable) continue;
    const auto reached = [&](const Rational& factor) { return roots.reached(*root, factor); };
    return loss_in(motion, narrowed(*root, digits, reached), true);
  }
  throw Error("loads", "none that makes the straight line unstable, at any factor",
              "a follower force that does");
}

/// Somewhat less than what would be critical if all forces were dead, or than the springs over the loads.
Rational first_step(const StraightMotion<Rational>& motion) {
  Rational springs = 0, loads = 0;
  for (Eigen::Index i = 0; i < motion.stiffness.rows(); ++i) {
    springs += motion.stiffness(i, i);
    loads += abs(motion.load(i, i));
  }
  const auto n = static_cast<long>(motion.stiffness.rows());
  return springs / loads / (n * n);
}

StabilityLoss first_of_steps(const StraightMotion<Rational>& motion, int digits) {
  const Rational step = *parse_decimal(to_decimal(first_step(motion), 3));
  constexpr int most = 400;
  for (int i = 1; i <= most; ++i) {
    if (motion_at(motion, i * step) == Motion::stable) continue;
    const auto lost = [&](const Rational& factor) { return motion_at(motion, factor) != Motion::stable; };
    return loss_in(motion, narrowed({(i - 1) * step, i * step}, digits, lost), false);
  }
  throw Error(
      "loads",
      "none that was found to make the straight line unstable up to the factor " + to_decimal(most * step, 6),
      "a follower force that does");
}

}  // namespace

Polynomial characteristic_polynomial(const StraightMotion<Rational>& motion, const Rational& factor) {
  return pencil_determinant(motion.stiffness - factor * motion.load, -mass_matrix(motion));
}

Motion motion_at(const StraightMotion<Rational>& motion, const Rational& factor) {
  const Polynomial p = characteristic_polynomial(motion, factor);
  if (distinct_positive_roots(p) == static_cast<std::size_t>(motion.stiffness.rows())) return Motion::stable;
  return p.front() == 0 || distinct_negative_roots(p) > 0 ? Motion::divergence : Motion::flutter;
}

StabilityLoss stability_loss(const StraightMotion<Rational>& motion, int digits) {
  if (motion_at(motion, 0) != Motion::stable)
    throw Error("structure", "one that is not stable before the loads grow, or has two equal frequencies",
                "ends, springs and fixed loads that hold it");
  return motion.stiffness.rows() <= most_for_discriminant ? first_of_all(motion, digits)
                                                          : first_of_steps(motion, digits);
}

}  // namespace plumbline::proofs
