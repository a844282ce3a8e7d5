#include "proofs/exact/follower.hpp"

#include <algorithm>
#include <optional>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_matrix.hpp"

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

/// Beyond all roots: Cauchy's bound.
Rational beyond_roots(const Polynomial& p) {
  Rational largest = 0;
  for (const Rational& c : p) largest = std::max(largest, Rational(abs(Rational(c / p.back()))));
  Rational power = 1;
  while (power <= largest + 1) power *= 2;
  return power;
}

struct Bracket {
  Rational low, high;
};

/// The next root above `from`, alone in its bracket, neither end of which is a root; nothing where there is
/// none.
std::optional<Bracket> next_root(const SturmSequence& sturm, const Polynomial& p, const Rational& from,
                                 const Rational& end) {
  Bracket bracket{from, end};
  if (sturm.distinct_roots(from, end) == 0) return std::nullopt;
  while (sturm.distinct_roots(bracket.low, bracket.high) > 1 || bracket.low == 0 ||
         evaluate(p, bracket.high) == 0) {
    Rational middle = (bracket.low + bracket.high) / 2;
    while (evaluate(p, middle) == 0) middle = (bracket.low + 2 * middle) / 3;
    (sturm.distinct_roots(bracket.low, middle) > 0 ? bracket.high : bracket.low) = middle;
  }
  return bracket;
}

/// A bracket, halved until both ends round alike, or a root half-way between two decimals is all that is left.
template <class AboveLoss>
StabilityLoss narrowed(const StraightMotion<Rational>& motion, Bracket bracket, int digits, bool first,
                       const AboveLoss& above_loss) {
  for (;;) {
    const Rational width = bracket.high - bracket.low;
    const bool narrow = bracket.low > 0 && 2 * width < unit_in_digit(bracket.low, digits);
    const std::string text = to_decimal(bracket.low, digits);
    if (narrow && (text == to_decimal(bracket.high, digits) ||
                   width < shifted(unit_in_digit(bracket.low, digits), -20)))
      return {motion_at(motion, bracket.high), bracket.low, bracket.high, text, first};
    // a short decimal near the middle: what is to be checked by others stays short
    const Rational middle = (bracket.low + bracket.high) / 2;
    const auto places = static_cast<int>(
        mpz_sizeinbase(mpq_denref(Rational(width).backend().data()), 10));
    Rational decimal = *parse_decimal(to_fixed(middle, places));
    if (!(bracket.low < decimal && decimal < bracket.high)) decimal = middle;
    (above_loss(decimal) ? bracket.high : bracket.low) = decimal;
  }
}

StabilityLoss first_of_all(const StraightMotion<Rational>& motion, int digits) {
  const Polynomial p = losses(motion);
  const SturmSequence sturm(p);
  const Rational end = beyond_roots(p);
  Rational from = 0;
  while (const auto root = next_root(sturm, p, from, end)) {
    from = root->high;
    if (motion_at(motion, root->high) == Motion::stable) continue;
    return narrowed(motion, *root, digits, true, [&](const Rational& factor) {
      return evaluate(p, factor) == 0 || sturm.distinct_roots(root->low, factor) > 0;
    });
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
    return narrowed(motion, {(i - 1) * step, i * step}, digits, false, [&](const Rational& factor) {
      return motion_at(motion, factor) != Motion::stable;
    });
  }
  throw Error("loads", "none that was found to make the straight line unstable up to the factor " +
                           to_decimal(most * step, 6),
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
