#pragma once
/// \file
/// The equations of a chain with a symmetry S at u = m + a v, where S m = m and S v = -v: their symmetric and
/// antisymmetric parts.

#include <Eigen/Core>
#include <plumbline/chain/chain.hpp>
#include <plumbline/loaded/loading.hpp>

#include "proofs/exact/span.hpp"
#include "proofs/paths/symmetry.hpp"

namespace plumbline::proofs {

/// The parts of E(m + a v) and their derivatives, for all angles and both components of the force.
struct Parts {
  Vector<Span> even, odd;  ///< the odd one over a
  Matrix<Span> even_by_mean, even_by_bend, odd_by_mean, odd_by_bend;
  Vector<Span> even_by_load, odd_by_load;
};

/// Unknowns: theta, and where the end point is held the force on it.
class SymmetricParts {
 public:
  SymmetricParts(const Chain<Interval>& chain, const Loading<Interval>& loading, const Symmetry& symmetry);

  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// Columns that span the m, and the v.
  [[nodiscard]] const Eigen::MatrixXd& mean() const { return mean_; }
  [[nodiscard]] const Eigen::MatrixXd& bend_basis() const { return bend_; }
  /// Coordinates of the part of u in a basis of orthogonal columns.
  static Vector<double> coordinates(const Eigen::MatrixXd& basis, const Vector<double>& u) {
    return (basis.transpose() * u).cwiseQuotient(basis.colwise().squaredNorm().transpose());
  }

  /// For all means, loads, bends and amplitudes in the boxes.
  [[nodiscard]] Parts at(const Vector<Span>& m, const Span& load, const Vector<Span>& v, const Span& a) const;

 private:
  [[nodiscard]] Eigen::MatrixXd basis(const Symmetry& symmetry, double sign) const;

  Eigen::Index n_;
  bool held_;
  Eigen::Index size_;
  Point<Span> start_, direction_;
  std::vector<Span> length_, stiffness_, rest_;
  Eigen::MatrixXd mean_, bend_;
};

}  // namespace plumbline::proofs
