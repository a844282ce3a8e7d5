#pragma once
/// \file
/// Linear algebra of a loaded chain in O(n): a symmetric band with a few borders.
///
/// In absolute angles the Hessian T of a chain is a band (tridiagonal for the nominal chain); each imposed
/// coordinate of the end point adds a border. T may be singular where the bordered matrix is not: a chain
/// whose end point is held can be stable where the same chain under a dead load is not. So a pivot of T that
/// is small beside its row is enlarged on purpose, T' = T + sum s_i e_i e_i^T, and every enlargement becomes
/// one more border, which undoes it exactly:
///
///     [ T'   E S  C ]        E = (e_i),  S = diag(s_i)
///     [ S E' S    0 ]        its Schur complement of S is the matrix asked for,
///     [ R    0    D ]        its Schur complement of T' is small and dense.
///
/// All entries of that are in the unit of T and the borders, so that its pivots are chosen alike in any unit.
/// No row moves, so the work stays O(n); Haynsworth's inertia additivity, used twice, counts negative
/// directions: n_-[T C; C' D] = n_-(T') + n_-(G) - n_-(S), where G is the small dense matrix.

#include <algorithm>
#include <array>
#include <plumbline/base/number.hpp>
#include <utility>
#include <vector>

namespace plumbline {

/// Symmetric band matrix of half bandwidth B: entry (d, i) is T(i + d, i), d = 0 … B.
template <Number Real, int B>
using Band = Eigen::Matrix<Real, B + 1, Eigen::Dynamic>;

/// Number of negative eigenvalues of a symmetric matrix, which is destroyed: Bunch and Parlett's diagonal
/// pivoting, 1 x 1 and 2 x 2. An exactly singular rest counts as not negative.
template <Ordered Real>
std::size_t negative_eigenvalues(Matrix<Real>& G) {
  using std::abs, std::max;
  std::size_t negative = 0;
  const Eigen::Index size = G.rows();
  for (Eigen::Index k = 0; k < size;) {
    Eigen::Index diagonal = k, row = k, column = k;
    Real largest_diagonal(0), largest(0);
    for (Eigen::Index j = k; j < size; ++j) {
      if (abs(G(j, j)) > largest_diagonal) largest_diagonal = abs(G(j, j)), diagonal = j;
      for (Eigen::Index i = j + 1; i < size; ++i) {
        if (abs(G(i, j)) > largest) largest = abs(G(i, j)), row = i, column = j;
      }
    }
    const auto bring = [&](Eigen::Index from, Eigen::Index to) {
      G.row(from).swap(G.row(to));
      G.col(from).swap(G.col(to));
    };
    if (!(max(largest, largest_diagonal) > Real(0))) break;
    if (largest_diagonal >= Real(16) / Real(25) * largest) {
      bring(diagonal, k);
      if (G(k, k) < Real(0)) ++negative;
      for (Eigen::Index j = k + 1; j < size; ++j) {
        const Real factor = G(k, j) / G(k, k);
        for (Eigen::Index i = k + 1; i < size; ++i) G(i, j) -= G(i, k) * factor;
      }
      k += 1;
    } else {  // the off-diagonal entry dominates: one eigenvalue of the block is negative, one positive
      bring(column, k);
      bring(row, k + 1);
      ++negative;
      const Real a = G(k, k), b = G(k, k + 1), c = G(k + 1, k + 1), determinant = a * c - b * b;
      for (Eigen::Index j = k + 2; j < size; ++j) {
        const Real u = (c * G(k, j) - b * G(k + 1, j)) / determinant;
        const Real v = (a * G(k + 1, j) - b * G(k, j)) / determinant;
        for (Eigen::Index i = k + 2; i < size; ++i) G(i, j) -= G(i, k) * u + G(i, k + 1) * v;
      }
      k += 2;
    }
  }
  return negative;
}

/// Factors and solves [ T C; R^T D ] with T an n x n symmetric band of half bandwidth B, and p borders: C and
/// R are n x p, D is p x p. Storage is kept from one use to the next.
template <Ordered Real, int B>
class BorderedBand {
 public:
  BorderedBand() : BorderedBand(default_pivot()) {}
  /// \param smallest_pivot  share of its row below which a pivot of T is enlarged: each elimination step may
  ///        lose as many digits as that has; 0 for exact numbers, of which only zeros are
  explicit BorderedBand(Real smallest_pivot) : small_(std::move(smallest_pivot)) {}

  /// Takes the band; the borders come with border().
  void factor(const Band<Real, B>& T) {
    using std::abs, std::max, std::min;
    const Eigen::Index n = T.cols();
    L_ = T;
    shifts_.clear();
    negative_ = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      Real scale = abs(T(0, i));
      for (Eigen::Index d = 1; d <= min<Eigen::Index>(B, n - 1 - i); ++d) scale = max(scale, abs(T(d, i)));
      for (Eigen::Index d = 1; d <= min<Eigen::Index>(B, i); ++d) scale = max(scale, abs(T(d, i - d)));
      if (!(scale > Real(0))) scale = largest(T);
      Real& pivot = L_(0, i);
      if (pivot == Real(0) || !(abs(pivot) >= small_ * scale)) {
        const Real shift = pivot < Real(0) ? Real(-scale) : scale;
        shifts_.emplace_back(i, shift);
        pivot += shift;
      }
      if (pivot < Real(0)) ++negative_;
      eliminate(i, min<Eigen::Index>(B, n - 1 - i));
    }
  }

  /// Adds the borders and factors the small dense matrix. False when the whole is singular.
  template <class Columns, class Rows, class Corner>
  bool border(const Columns& C, const Rows& R, const Corner& D) {
    const Eigen::Index n = L_.cols(), p = C.cols(), m = shifted();
    X_.resize(n, m + p);
    X_.leftCols(m).setConstant(Real(0));
    for (Eigen::Index a = 0; a < m; ++a) {
      const auto& [i, shift] = shifts_[static_cast<std::size_t>(a)];
      X_(i, a) = shift;
    }
    X_.rightCols(p) = C;
    for (Eigen::Index a = 0; a < m + p; ++a) solve_band(X_.col(a));
    R_ = R;
    G_.resize(m + p, m + p);
    for (Eigen::Index b = 0; b < m + p; ++b) {
      for (Eigen::Index a = 0; a < m; ++a) {
        const auto& [i, shift] = shifts_[static_cast<std::size_t>(a)];
        G_(a, b) = (a == b ? shift : Real(0)) - shift * X_(i, b);
      }
      for (Eigen::Index a = 0; a < p; ++a) {
        Real sum = b >= m ? Real(D(a, b - m)) : Real(0);
        for (Eigen::Index i = 0; i < n; ++i) sum -= R_(i, a) * X_(i, b);
        G_(m + a, b) = sum;
      }
    }
    LU_ = G_;
    return factor_dense();
  }

  /// Leaves the band without borders. False when it is singular.
  bool no_border() {
    const Eigen::Index n = L_.cols();
    return border(Matrix<Real>(n, 0), Matrix<Real>(n, 0), Matrix<Real>(0, 0));
  }

  /// Negative eigenvalues of the matrix with only the first so many borders; presumes it is symmetric there.
  [[nodiscard]] std::size_t negative(Eigen::Index borders) {
    if (shifts_.empty() && borders == 0) return negative_;
    if (shifts_.empty() && borders == 2) {
      const bool mixed = G_(0, 0) * G_(1, 1) < G_(0, 1) * G_(1, 0);
      return negative_ + (mixed ? 1 : G_(0, 0) + G_(1, 1) < Real(0) ? 2 : 0);
    }
    scratch_ = G_.topLeftCorner(shifted() + borders, shifted() + borders);
    std::size_t count = negative_ + negative_eigenvalues(scratch_);
    for (const auto& shift : shifts_) count -= shift.second < Real(0) ? 1 : 0;
    return count;
  }

  /// Replaces (v, w), the right-hand side, by the solution.
  template <class V, class W>
  void solve(V&& v, W&& w) {
    const Eigen::Index n = L_.cols(), m = shifted(), p = R_.cols();
    solve_band(v);
    if (m + p == 0) return;
    if (m == 0 && p == 2) return solve_two(v, w);
    z_.resize(m + p);
    for (Eigen::Index a = 0; a < m; ++a) {
      const auto& [i, shift] = shifts_[static_cast<std::size_t>(a)];
      z_(a) = -shift * v(i);
    }
    for (Eigen::Index a = 0; a < p; ++a) {
      Real sum = w(a);
      for (Eigen::Index i = 0; i < n; ++i) sum -= R_(i, a) * v(i);
      z_(m + a) = sum;
    }
    solve_dense();
    for (Eigen::Index i = 0; i < n; ++i) {
      Real x = v(i);
      for (Eigen::Index b = 0; b < m + p; ++b) x -= X_(i, b) * z_(b);
      v(i) = x;
    }
    for (Eigen::Index a = 0; a < p; ++a) w(a) = z_(m + a);
  }

 private:
  static Real default_pivot() {
    using std::sqrt;
    return sqrt(sqrt(epsilon<Real>()));
  }
  /// The size of the largest entry, for rows of zeros, which have no scale of their own; 1 where all are
  /// zero.
  static Real largest(const Band<Real, B>& T) {
    using std::abs, std::max, std::min;
    Real result(0);
    for (Eigen::Index i = 0; i < T.cols(); ++i) {
      for (Eigen::Index d = 0; d <= min<Eigen::Index>(B, T.cols() - 1 - i); ++d)
        result = max(result, abs(T(d, i)));
    }
    return result > Real(0) ? result : Real(1);
  }
  [[nodiscard]] Eigen::Index shifted() const { return static_cast<Eigen::Index>(shifts_.size()); }

  void eliminate(Eigen::Index i, Eigen::Index reach) {
    L_(0, i) = Real(1) / L_(0, i);
    for (Eigen::Index d = reach; d > 0; --d) {
      const Real factor = L_(d, i) * L_(0, i);
      for (Eigen::Index e = d; e <= reach; ++e) L_(e - d, i + d) -= L_(e, i) * factor;
    }
    for (Eigen::Index d = 1; d <= reach; ++d) L_(d, i) *= L_(0, i);
  }

  template <class V>
  void solve_band(V&& v) const {
    const Eigen::Index n = L_.cols();
    std::array<Real, B> last;  // the entries behind, or ahead: at hand without a way through memory
    last.fill(Real(0));
    const auto keep = [&last](const Real& x) {
      for (std::size_t d = B - 1; d > 0; --d) last[d] = last[d - 1];
      last[0] = x;
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      Real x = v(i);
      for (Eigen::Index d = 1; d <= B && d <= i; ++d)
        x -= L_(d, i - d) * last[static_cast<std::size_t>(d - 1)];
      v(i) = x * L_(0, i);
      keep(x);
    }
    for (Eigen::Index i = n; i-- > 0;) {
      Real x = v(i);
      for (Eigen::Index d = 1; d <= B && i + d < n; ++d)
        x -= L_(d, i) * last[static_cast<std::size_t>(d - 1)];
      v(i) = x;
      keep(x);
    }
  }

  /// The rest of solve() with two borders and no enlarged pivot, an equilibrium's usual case: in registers.
  template <class V, class W>
  void solve_two(V& v, W& w) const {
    Real a = w(0), b = w(1);
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      a -= R_(i, 0) * v(i);
      b -= R_(i, 1) * v(i);
    }
    if (rows_[0] == 1) std::swap(a, b);
    b -= LU_(1, 0) * a;
    b *= LU_(1, 1);
    a -= LU_(0, 1) * b;
    a *= LU_(0, 0);
    for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = Real(v(i) - X_(i, 0) * a) - X_(i, 1) * b;
    w(0) = a;
    w(1) = b;
  }

  bool factor_dense() {
    using std::abs;
    const Eigen::Index size = LU_.rows();
    rows_.resize(static_cast<std::size_t>(size));
    for (Eigen::Index k = 0; k < size; ++k) {
      Eigen::Index best = k;
      for (Eigen::Index i = k + 1; i < size; ++i) {
        if (abs(LU_(i, k)) > abs(LU_(best, k))) best = i;
      }
      rows_[static_cast<std::size_t>(k)] = best;
      if (best != k) LU_.row(best).swap(LU_.row(k));
      if (!(abs(LU_(k, k)) > Real(0)) || !is_finite(LU_(k, k))) return false;
      LU_(k, k) = Real(1) / LU_(k, k);
      for (Eigen::Index i = k + 1; i < size; ++i) {
        LU_(i, k) *= LU_(k, k);
        for (Eigen::Index j = k + 1; j < size; ++j) LU_(i, j) -= LU_(i, k) * LU_(k, j);
      }
    }
    return true;
  }

  void solve_dense() {
    for (Eigen::Index k = 0; k < z_.size(); ++k) std::swap(z_(k), z_(rows_[static_cast<std::size_t>(k)]));
    if (z_.size() == 3) {  // along a branch: few enough for registers
      Eigen::Matrix<Real, 3, 1> z = z_;
      substitute(z);
      z_ = z;
    } else {
      substitute(z_);
    }
  }
  template <class Column>
  void substitute(Column& z) const {
    const Eigen::Index size = z.size();
    for (Eigen::Index k = 0; k < size; ++k) {
      for (Eigen::Index i = k + 1; i < size; ++i) z(i) -= LU_(i, k) * z(k);
    }
    for (Eigen::Index k = size; k-- > 0;) {
      for (Eigen::Index j = k + 1; j < size; ++j) z(k) -= LU_(k, j) * z(j);
      z(k) *= LU_(k, k);
    }
  }

  Real small_;
  Band<Real, B> L_;  // unit lower band below, reciprocals of the pivots in row 0
  std::vector<std::pair<Eigen::Index, Real>> shifts_;
  std::size_t negative_ = 0;
  Matrix<Real> X_, R_, G_, LU_, scratch_;  // LU_ with reciprocals of its pivots
  std::vector<Eigen::Index> rows_;
  Vector<Real> z_;
};

}  // namespace plumbline
