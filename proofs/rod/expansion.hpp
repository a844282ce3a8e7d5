#pragma once
/// \file
/// Entire functions of two variables s and u as enclosed polynomials with a bound of the rest.
///
/// The norm of Σ a_ij s^i u^j is Σ |a_ij|: it bounds the function where |s|, |u| <= 1, and that of a product
/// is at most the product of the norms. What is not kept as a coefficient is kept as a bound of its norm.

#include <vector>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// Powers of s and of u that are kept.
struct ExpansionSize {
  std::size_t s, u;
};

class Expansion {
 public:
  /// Nought.
  explicit Expansion(ExpansionSize size) : size_(size) {}
  /// a + b s + c u.
  Expansion(ExpansionSize size, const Interval& a, const Interval& b, const Interval& c)
      : size_(size), rows_{{a, c}, {b}} {}

  [[nodiscard]] ExpansionSize size() const { return size_; }
  /// Coefficients of s^i u^0, s^i u^1, … for each i, as far as they are not zero.
  [[nodiscard]] const std::vector<std::vector<Interval>>& rows() const { return rows_; }
  /// Bound of the norm of all that is not among the coefficients.
  [[nodiscard]] double rest() const { return rest_; }
  [[nodiscard]] double norm() const;
  /// Anything up to a bound.
  void add_rest(double bound) { rest_ = upward(rest_ + bound); }

  Expansion operator-() const;
  Expansion& operator+=(const Expansion& other);
  friend Expansion operator+(Expansion a, const Expansion& b) { return a += b; }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + (-b); }
  friend Expansion operator*(const Expansion& a, const Expansion& b);
  friend Expansion operator*(Expansion a, const Interval& b);

 private:
  /// Makes up for the rounding of one operation.
  static double upward(double x) { return x * (1 + 1e-15) + 5e-324; }
  /// To a coefficient, or to the rest where there is none.
  void add(std::size_t i, std::size_t j, const Interval& value);

  ExpansionSize size_;
  std::vector<std::vector<Interval>> rows_;
  double rest_ = 0;
};

inline double size_of(const Interval& x) {
  return Span(x).magnitude();
}
inline double size_of(const Expansion& x) {
  return x.norm();
}
/// Anything up to a bound.
inline void add_remainder(Interval& x, double bound) {
  x += hull(Interval::from_double(-bound), Interval::from_double(bound));
}
inline void add_remainder(Expansion& x, double bound) {
  x.add_rest(bound);
}

}  // namespace plumbline::proofs
