#pragma once
/// \file
/// Moore's system, regular where two branches cross and where they pass each other closely.
///
/// With the load among the unknowns u, equilibria E(u) = 0 branch only where a vector psi, other than zero,
/// has psi^T E'(u) = 0. Let x be the unknowns but the load, and b a vector. The system
///
///     E(u) + tau b = 0,    psi^T dE/dx = 0,    psi^T dE/dload = 0,    b · psi = 1
///
/// says by how much tau a term tau b makes two passing branches cross.

#include <optional>

#include "proofs/paths/interval_equations.hpp"

namespace plumbline::proofs {

/// The system with b close to the null vector at a point.
class MooreSystem {
 public:
  /// \param equations  have to outlive it
  MooreSystem(const IntervalEquations& equations, const Vector<double>& crossing);

  /// All psi with psi^T dE/dx = 0, b · psi = 1 at any u in a box; nothing where that is open.
  [[nodiscard]] std::optional<IntervalVector> null_vectors(const IntervalVector& u) const;

  /// Its value and its derivative at all w = (u, psi, tau) in a box.
  [[nodiscard]] std::pair<IntervalVector, Matrix<Interval>> operator()(const IntervalVector& w) const;

 private:
  const IntervalEquations* equations_;
  Eigen::Index m_;
  Vector<double> left_, right_;
};

}  // namespace plumbline::proofs
