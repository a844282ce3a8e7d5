#pragma once
/// \file
/// The characteristic function D(factor, x) of a rod: zero where the square x of a circular frequency belongs
/// to a small motion at a load factor, for any loads, those that follow the tangent too.
///
/// Solutions that satisfy what holds the base are handed on from stretch to stretch. What a node holds adds a
/// force that is unknown and the condition that it holds; D is the determinant of all conditions by the
/// unknowns. Nothing is divided: D is entire in both variables, and its power series about 0 is computed once
/// for all, with a bound of the rest on a disc of each variable.

#include "proofs/rod/expansion.hpp"
#include "proofs/rod/rod.hpp"

namespace plumbline::proofs {

/// Value and derivatives of a function of the factor and x.
template <class Real>
struct Jet {
  Real value, by_factor, by_square, by_square_twice;
};

class Characteristic {
 public:
  /// For factors up to `most_factor` and squares of frequencies up to `most_square`, both positive, the
  /// latter in E I / (m length^4). \throws Error for a rod of too many supports, or too long for its loads
  Characteristic(const DividedRod& rod, const Rational& most_factor, const Rational& most_square);

  /// At all points of two spans within those bounds.
  [[nodiscard]] Jet<Span> at(const Span& factor, const Span& x) const;
  /// At one point, to many digits.
  [[nodiscard]] Jet<Interval> at(const Interval& factor, const Interval& x) const;

  /// The function of x for all factors of a span, in which x is narrowed cheaply.
  class Slab {
   public:
    Slab(const Characteristic& function, const Span& factor);
    [[nodiscard]] Jet<Span> at(const Span& x) const;

   private:
    [[nodiscard]] Jet<Span> horner(const Span& x) const;
    const Characteristic& function_;
    std::vector<Span> value_, by_factor_;  ///< coefficients of the powers of x over its bound
  };

 private:
  template <class Real>
  [[nodiscard]] Jet<Real> with_rest(const Jet<Real>& scaled) const;

  double factor_scale_, square_scale_;               ///< of the discs, twice the bounds: powers of two
  std::vector<std::vector<Interval>> coefficients_;  ///< of powers of the factor, then of x, over the scales
  std::vector<std::vector<Span>> rounded_;
  double rest_;
};

}  // namespace plumbline::proofs
