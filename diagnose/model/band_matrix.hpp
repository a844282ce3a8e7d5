#pragma once
/// \file
/// A symmetric band matrix and its LDL^T factors: O(n) for the chains' stiffness matrices.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace plumbline::diagnose {

/// Symmetric, of half-bandwidth w; only the lower triangle is kept.
class BandMatrix {
 public:
  BandMatrix(std::size_t size, std::size_t half_width)
      : size_(size), width_(half_width), entry_(size * (half_width + 1)) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  void set_zero() { std::fill(entry_.begin(), entry_.end(), 0.0); }
  /// Entry (row, column), row - half_width <= column <= row.
  double& operator()(std::size_t row, std::size_t column) {
    return entry_[row * (width_ + 1) + width_ + column - row];
  }
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
    return entry_[row * (width_ + 1) + width_ + column - row];
  }

  /// Replaces the matrix by its factors L and 1/D. A pivot smaller than `smallest` is put at that size: the
  /// solution then errs, which costs a Newton iteration and no more.
  /// \returns the number of negative pivots, which is the number of negative eigenvalues (Sylvester)
  std::size_t factorise(double smallest) {
    std::size_t negative = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t first = i > width_ ? i - width_ : 0;
      double pivot = (*this)(i, i);
      for (std::size_t j = first; j < i; ++j) {
        double sum = (*this)(i, j);
        for (std::size_t m = std::max(first, j > width_ ? j - width_ : 0); m < j; ++m)
          sum -= (*this)(i, m) * (*this)(j, m);
        // Rows keep L D until their pivot is done, then L.
        (*this)(i, j) = sum;
      }
      for (std::size_t j = first; j < i; ++j) {
        const double scaled = (*this)(i, j) * (*this)(j, j);
        pivot -= scaled * (*this)(i, j);
        (*this)(i, j) = scaled;
      }
      if (std::abs(pivot) < smallest) pivot = pivot < 0 ? -smallest : smallest;
      negative += pivot < 0;
      (*this)(i, i) = 1 / pivot;
    }
    return negative;
  }

  /// Overwrites `x` by the solution, after factorise().
  template <class Vector>
  void solve(Vector& x) const {
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = i > width_ ? i - width_ : 0; j < i; ++j) x[i] -= (*this)(i, j) * x[j];
    for (std::size_t i = 0; i < size_; ++i) x[i] *= (*this)(i, i);
    for (std::size_t i = size_; i-- > 0;)
      for (std::size_t j = i > width_ ? i - width_ : 0; j < i; ++j) x[j] -= (*this)(i, j) * x[i];
  }

 private:
  std::size_t size_, width_;
  std::vector<double> entry_;
};

}  // namespace plumbline::diagnose
