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

bool is_symmetric(const StraightMotion<Rational>& motion) {
  return motion.load == Matrix<Rational>(motion.load.transpose()) &&
         motion.stiffness == Matrix<Rational>(motion.stiffness.transpose());
}

/// Whether there are as many independent shapes as unknowns: always so of a symmetric matrix, and of others
/// exactly where the polynomial with each root once annuls them.
bool shapes_suffice(const StraightMotion<Rational>& motion, const Rational& factor, const Polynomial& p) {
  const Polynomial each_once = squarefree(p);
  if (is_symmetric(motion) || each_once.size() == p.size()) return true;
  Matrix<Rational> B = motion.stiffness - factor * motion.load;
  for (Eigen::Index i = 0; i < B.rows(); ++i) B.row(i) /= motion.mass[static_cast<std::size_t>(i)];
  Matrix<Rational> value = Matrix<Rational>::Constant(B.rows(), B.cols(), Rational(0));
  for (std::size_t power = each_once.size(); power-- > 0;) {
    value = (value * B).eval();
    for (Eigen::Index i = 0; i < B.rows(); ++i) value(i, i) += each_once[power];
  }
  return value == Matrix<Rational>::Constant(B.rows(), B.cols(), Rational(0));
}

/// Sums of the powers 0, 1, … of the roots, by Newton's identities, as the matrix s_(i + j), whose rank is
/// the number of distinct roots (Hermite).
Matrix<Rational> power_sums(const Polynomial& p) {
  const std::size_t n = p.size() - 1;
  std::vector<Rational> s{Rational(n)};
  for (std::size_t k = 1; k + 1 < 2 * n; ++k) {
    Rational sum = k <= n ? Rational(-Rational(k) * p[n - k]) : Rational(0);
    for (std::size_t j = 1; j < k && j <= n; ++j) sum -= p[n - j] * s[k - j];
    s.push_back(sum / p[n]);
  }
  const auto size = static_cast<Eigen::Index>(n);
  Matrix<Rational> H(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) H(i, j) = s[static_cast<std::size_t>(i + j)];
  }
  return H;
}

/// Where the motion can change: a frequency is zero, or two are equal that elsewhere are not.
struct Changes {
  Polynomial zero, equal;
};

/// \throws Error where two frequencies are equal at every factor, and the shapes are not known to suffice
Changes changes_of(const StraightMotion<Rational>& motion) {
  const auto n = static_cast<std::size_t>(motion.stiffness.rows());
  std::vector<Rational> determinants;
  std::vector<Matrix<Rational>> sums;
  std::size_t distinct = 0;  // of so many samples one at least has as many as there are but at some factors
  for (std::size_t i = 0; i <= n * (n - 1) + 1; ++i) {
    const Polynomial p = characteristic_polynomial(motion, Rational(i));
    determinants.push_back(p.front());
    sums.push_back(power_sums(p));
    if (distinct < n) distinct = std::max(distinct, rank(sums.back()));
  }
  if (distinct < n && !is_symmetric(motion))
    throw Error("structure", "two equal frequencies at every factor of loads that have no energy",
                "lengths, springs or masses that tell them apart");
  const auto d = static_cast<Eigen::Index>(distinct);
  std::vector<Rational> minors;
  for (const Matrix<Rational>& H : sums) minors.push_back(determinant(H.topLeftCorner(d, d)));
  determinants.resize(n + 1);
  return {interpolate(determinants), interpolate(minors)};
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

/// The motion at a root beside which it is stable to either side: all frequencies are real there.
Motion at_touch(const StraightMotion<Rational>& motion, const PositiveRoots& roots, const RootBracket& root) {
  if (is_symmetric(motion)) return Motion::stable;
  const auto exact = roots.as_fraction(root);
  return exact ? motion_at(motion, *exact) : Motion::undecided;
}

std::vector<MotionChange> all_changes(const StraightMotion<Rational>& motion, int digits) {
  const Changes where = changes_of(motion);
  const PositiveRoots roots(product(where.zero, where.equal));
  const SturmSequence zeros(where.zero);
  std::vector<MotionChange> changes;
  Motion below = Motion::stable;
  for (const RootBracket& root : roots.all()) {
    const Motion above = motion_at(motion, root.high);
    const bool is_zero = zeros.distinct_roots(root.low, root.high) > 0;
    Motion at = below == above ? below : Motion::undecided;
    if (is_zero) at = Motion::divergence;
    if (!is_zero && below == Motion::stable && above == Motion::stable) at = at_touch(motion, roots, root);
    if (below != above || (at != below && below == Motion::stable)) {
      NarrowBracket found =
          narrowed(root, digits, [&](const Rational& factor) { return roots.reached(root, factor); });
      changes.push_back({std::move(found.low), std::move(found.high), std::move(found.decimal), at, above});
    }
    below = above;
  }
  return changes;
}

StabilityLoss first_of_all(const StraightMotion<Rational>& motion, int digits) {
  std::vector<MotionChange> changes = all_changes(motion, digits);
  for (const MotionChange& one : changes) {
    if (one.above == Motion::stable && (one.at == Motion::stable || one.at == Motion::undecided)) continue;
    const Motion kind = one.above == Motion::stable ? one.at : one.above;
    return {kind, one.low, one.high, one.factor, true, changes};
  }
  throw Error("loads", "none that makes the straight line unstable, at any factor",
              "a follower force that does");
}

/// Somewhat less than what would be critical if all forces were dead, or than the springs over the loads.
Rational first_step(const StraightMotion<Rational>& motion) {
  Rational springs = 0, loads = 0;
  for (Eigen::Index i = 0; i < motion.stiffness.rows(); ++i) {
    springs += motion.stiffness(i, i);
    for (Eigen::Index j = 0; j < motion.load.cols(); ++j) loads += abs(motion.load(i, j));
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
    NarrowBracket at = narrowed({(i - 1) * step, i * step}, digits, lost);
    return {motion_at(motion, at.high), at.low, at.high, at.decimal, false, {}};
  }
  throw Error(
      "loads",
      "none that was found to make the straight line unstable up to the factor " + to_decimal(most * step, 6),
      "a follower force that does");
}

}  // namespace

const char* name_of(Motion motion) {
  switch (motion) {
    case Motion::stable:
      return "stable";
    case Motion::divergence:
      return "divergence";
    case Motion::flutter:
      return "flutter";
    default:
      return "undecided";
  }
}

Polynomial characteristic_polynomial(const StraightMotion<Rational>& motion, const Rational& factor) {
  return pencil_determinant(motion.stiffness - factor * motion.load, -mass_matrix(motion));
}

Motion motion_at(const StraightMotion<Rational>& motion, const Rational& factor) {
  const Polynomial p = characteristic_polynomial(motion, factor);
  if (p.front() == 0 || distinct_negative_roots(p) > 0) return Motion::divergence;
  const bool all_real = distinct_positive_roots(p) + 1 == squarefree(p).size();
  return all_real && shapes_suffice(motion, factor, p) ? Motion::stable : Motion::flutter;
}

StabilityLoss stability_loss(const StraightMotion<Rational>& motion, int digits) {
  if (motion.load == Matrix<Rational>::Constant(motion.load.rows(), motion.load.cols(), Rational(0)))
    throw Error("loads", "none that is multiplied and pushes what can move", "one that does");
  if (motion_at(motion, 0) != Motion::stable)
    throw Error("structure", "one that is not stable before the loads grow",
                "ends, springs and fixed loads that hold it");
  return motion.stiffness.rows() <= most_for_discriminant ? first_of_all(motion, digits)
                                                          : first_of_steps(motion, digits);
}

}  // namespace plumbline::proofs
