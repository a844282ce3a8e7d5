#include "proofs/exact/straight_space.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <plumbline/base/bordered_band.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/found_forces.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

Matrix<Mpfr> rounded(const Matrix<Rational>& exact) {
  Matrix<Mpfr> result(exact.rows(), exact.cols());
  for (Eigen::Index i = 0; i < exact.rows(); ++i) {
    for (Eigen::Index j = 0; j < exact.cols(); ++j) result(i, j) = from_rational<Mpfr>(exact(i, j));
  }
  return result;
}

std::size_t negative(Matrix<Rational> matrix) {
  return plumbline::negative_eigenvalues(matrix);
}

struct Pairs {
  std::vector<Mpfr> factors;
  std::vector<Vector<Mpfr>> vectors;
};

/// A row of (K - F G) y that is zero in so many digits of its terms; a shape is shown in doubles.
constexpr int shape_digits = 20;

/// Positive factors, ascending, and their vectors: G y = K y / factor.
Pairs factors_with(const SpacePencil<Rational>& pencil, std::size_t modes) {
  const Matrix<Mpfr> K = rounded(pencil.stiffness), G = rounded(pencil.load);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix<Mpfr>> solver(G, K);
  Pairs pairs;
  for (Eigen::Index i = G.rows(); i-- > 0 && pairs.factors.size() < modes;) {
    pairs.factors.push_back(1 / solver.eigenvalues()(i));
    pairs.vectors.push_back(solver.eigenvectors().col(i));
  }
  return pairs;
}

/// Whether every row of (K - F G) y is zero but for what its terms lose in rounding to so many digits, or to
/// twice as many those of a part that does not bend.
bool balanced(const Matrix<Mpfr>& K, const Matrix<Mpfr>& G, const Mpfr& factor, const Vector<Mpfr>& y) {
  const Mpfr share = pow(Mpfr(10), -shape_digits), largest = y.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    Mpfr sum(0), terms(0);
    for (Eigen::Index j = 0; j < K.cols(); ++j) {
      sum += (K(i, j) - factor * G(i, j)) * y(j);
      terms += (abs(K(i, j)) + factor * abs(G(i, j))) * (abs(y(j)) + share * largest);
    }
    if (abs(sum) > terms * share) return false;
  }
  return true;
}

/// The vectors of factors that are enclosed, computed with so many digits; nothing where these are too few.
std::optional<std::vector<Vector<Mpfr>>> vectors_with(const SpacePencil<Rational>& pencil, std::size_t modes,
                                                      const std::vector<ForceEnclosure>& enclosed) {
  Pairs pairs = factors_with(pencil, modes);
  const Matrix<Mpfr> K = rounded(pencil.stiffness), G = rounded(pencil.load);
  for (std::size_t m = 0; m < enclosed.size(); ++m) {
    const Rational factor = exactly(pairs.factors[m]);
    if (factor < enclosed[m].low || factor > enclosed[m].high ||
        !balanced(K, G, pairs.factors[m], pairs.vectors[m]))
      return std::nullopt;
  }
  return std::move(pairs.vectors);
}

}  // namespace

StraightSpace::StraightSpace(const SpaceStructure<Rational>& structure)
    : axes_(structure.chain.freedoms()), pencil_(space_pencil(structure)) {
  for (const SpaceJoint<Rational>& joint : structure.chain.joint) {
    for (const Axis<Rational>& axis : joint.axes) {
      const auto& a = axis.direction;
      length_of_axis_.push_back(
          std::sqrt(Rational(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).convert_to<double>()));
    }
  }
  if (negative(pencil_.stiffness) > 0)
    throw Error("structure", "one that the fixed loads alone make give way",
                "fixed loads below the critical ones");
  if (negative(-pencil_.stiffness) < static_cast<std::size_t>(pencil_.stiffness.rows()))
    throw Error("structure", "a mechanism, which moves across without any force",
                "ends, springs and stiffnesses that hold it");
  modes_ = negative(-pencil_.load);
  if (modes_ == 0)
    throw Error("structure", "loads that no positive factor makes critical: they pull, or nothing can turn",
                "a load that compresses, and joints that can turn");
}

std::size_t StraightSpace::below(const Rational& factor) const {
  return negative(pencil_.at(factor));
}

std::vector<ForceEnclosure> StraightSpace::enclose(std::size_t lowest, int digits) const {
  FoundForces found(std::min(lowest, modes_), digits, [&](const std::vector<Rational>& factors) {
    std::vector<std::size_t> counts;
    for (const Rational& factor : factors) counts.push_back(below(factor));
    return counts;
  });
  for (int sure = digits + 12; !found.complete(); sure += sure / 2) {
    require_affordable(sure);
    const WorkingPrecision precision(2 * sure);
    found.enclose(factors_with(pencil_, modes_).factors, sure);
  }
  return found.all();
}

std::vector<double> StraightSpace::angles(const Vector<Mpfr>& y) const {
  const Vector<Mpfr> turns = rounded(pencil_.basis) * y;
  std::vector<double> q(axes_, 0.0);
  double largest = 0;
  for (Eigen::Index i = 0; i < turns.size(); ++i) {
    const std::size_t axis = pencil_.axis[static_cast<std::size_t>(i)];
    q[axis] = static_cast<double>(turns(i)) * length_of_axis_[axis];
    largest = std::max(largest, std::abs(q[axis]));
  }
  const double noise = 1e-15 * largest;
  const auto first = std::find_if(q.begin(), q.end(), [&](double angle) { return std::abs(angle) > noise; });
  const double scale = *first < 0 ? -largest : largest;
  for (double& angle : q) angle = std::abs(angle) > noise ? angle / scale : 0;
  return q;
}

std::vector<SpaceMode> StraightSpace::in_decimals(std::size_t lowest, int digits) const {
  const std::vector<ForceEnclosure> enclosed = enclose(lowest, digits);
  std::vector<SpaceMode> modes;
  for (const ForceEnclosure& factor : enclosed) {
    const std::string low = to_decimal(factor.low, digits), high = to_decimal(factor.high, digits);
    const bool upper = low != high && below((*parse_decimal(low) + *parse_decimal(high)) / 2) < factor.index;
    modes.push_back({upper ? high : low, {}});
  }
  for (int working = 2 * (digits + 24);; working *= 2) {
    require_affordable(working);
    const WorkingPrecision precision(working);
    const auto vectors = vectors_with(pencil_, modes_, enclosed);
    if (!vectors) continue;
    for (std::size_t m = 0; m < modes.size(); ++m) modes[m].q = angles((*vectors)[m]);
    return modes;
  }
}

}  // namespace plumbline::proofs
