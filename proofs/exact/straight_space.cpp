#include "proofs/exact/straight_space.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <plumbline/base/bordered_band.hpp>

#include "proofs/exact/decimal.hpp"
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

}  // namespace

StraightSpace::StraightSpace(const SpaceChain<Rational>& chain, const SpaceLoad<Rational>& load)
    : axes_(chain.freedoms()), pencil_(space_pencil(chain, load)) {
  for (const SpaceJoint<Rational>& joint : chain.joint) {
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
    const WorkingPrecision precision(2 * sure);
    found.enclose(factors_with(pencil_, modes_).factors, sure);
  }
  return found.all();
}

std::vector<SpaceMode> StraightSpace::in_decimals(std::size_t lowest, int digits) const {
  std::vector<SpaceMode> modes;
  for (const ForceEnclosure& factor : enclose(lowest, digits)) {
    const std::string low = to_decimal(factor.low, digits), high = to_decimal(factor.high, digits);
    const bool upper = low != high && below((*parse_decimal(low) + *parse_decimal(high)) / 2) < factor.index;
    modes.push_back({upper ? high : low, std::vector<double>(axes_, 0.0)});
  }
  const WorkingPrecision precision(60);
  const auto pairs = factors_with(pencil_, modes_);
  const Matrix<Mpfr> basis = rounded(pencil_.basis);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Vector<Mpfr> turns = basis * pairs.vectors[m];
    double largest = 0;
    for (Eigen::Index i = 0; i < turns.size(); ++i) {
      const std::size_t axis = pencil_.axis[static_cast<std::size_t>(i)];
      double& q = modes[m].q[axis];
      q = static_cast<double>(turns(i)) * length_of_axis_[axis];
      largest = std::max(largest, std::abs(q));
    }
    const auto first = std::find_if(modes[m].q.begin(), modes[m].q.end(),
                                    [&](double q) { return std::abs(q) > 1e-12 * largest; });
    for (double& q : modes[m].q)
      q = std::abs(q) < 1e-15 * largest ? 0 : q / (*first < 0 ? -largest : largest);
  }
  return modes;
}

}  // namespace plumbline::proofs
