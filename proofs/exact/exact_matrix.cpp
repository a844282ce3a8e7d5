#include "proofs/exact/exact_matrix.hpp"

#include <utility>
#include <vector>

namespace plumbline::proofs {
namespace {

using IntegerRows = std::vector<std::vector<Integer>>;

struct Elimination {
  std::size_t rank;
  Integer last_minor;  ///< of order `rank`: the determinant of a regular matrix
};

/// Bareiss's elimination. Every division in it is exact.
Elimination eliminate(IntegerRows rows) {
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  Elimination result{0, 1};
  int sign = 1;
  for (std::size_t column = 0; column < columns && result.rank < rows.size(); ++column) {
    const std::size_t top = result.rank;
    std::size_t pivot = top;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    if (pivot != top) sign = -sign;
    std::swap(rows[pivot], rows[top]);
    for (std::size_t i = top + 1; i < rows.size(); ++i) {
      for (std::size_t j = column + 1; j < columns; ++j) {
        rows[i][j] = (rows[top][column] * rows[i][j] - rows[i][column] * rows[top][j]) / result.last_minor;
      }
      rows[i][column] = 0;
    }
    result.last_minor = rows[top][column];
    ++result.rank;
  }
  result.last_minor *= sign;
  return result;
}

/// The matrix times the least number that makes it integer.
std::pair<IntegerRows, Integer> cleared(const Matrix<Rational>& matrix) {
  Integer scale = 1;
  for (const Rational& x : matrix.reshaped()) scale = mp::lcm(scale, mp::denominator(x));
  IntegerRows rows(static_cast<std::size_t>(matrix.rows()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      rows[static_cast<std::size_t>(i)].push_back(mp::numerator(Rational(matrix(i, j) * scale)));
  }
  return {std::move(rows), std::move(scale)};
}

}  // namespace

Rational determinant(const Matrix<Rational>& matrix) {
  auto [rows, scale] = cleared(matrix);
  const std::size_t size = rows.size();
  const Elimination result = eliminate(std::move(rows));
  if (result.rank < size) return 0;
  return Rational(result.last_minor, mp::pow(scale, static_cast<unsigned>(size)));
}

std::size_t rank(const Matrix<Rational>& matrix) {
  return eliminate(cleared(matrix).first).rank;
}

Polynomial pencil_determinant(const Matrix<Rational>& P, const Matrix<Rational>& Q) {
  std::vector<Rational> values;
  for (long x = 0; x <= P.rows(); ++x) values.push_back(determinant(P + Q * Rational(x)));
  return interpolate(values);
}

}  // namespace plumbline::proofs
