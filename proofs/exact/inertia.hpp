#pragma once
/// \file
/// How many eigenvalues of an enclosed symmetric matrix are negative.

#include <optional>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// The middles of all entries.
Eigen::MatrixXd middle(const Matrix<Span>& A);

/// The number of negative eigenvalues of every symmetric matrix inside K; nothing where that is open, such as
/// where one of them is singular. O(n^3). By Sylvester's law: with X close to the eigenvectors, X^T K X is
/// diagonally dominant, which proves X and K regular and shows the signs.
std::optional<std::size_t> negative_eigenvalues(const Matrix<Span>& K);

}  // namespace plumbline::proofs
