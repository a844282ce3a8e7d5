#pragma once
/// \file
/// The number types that the core is instantiated with, and the concepts that say what each can do.
///
/// | type       | is                                   | Ordered | Analytic | Floating |
/// |------------|--------------------------------------|---------|----------|----------|
/// | `double`   | 53-bit floating point                | yes     | yes      | yes      |
/// | `Mpfr50`   | 50-digit floating point              | yes     | yes      | yes      |
/// | `Mpfr`     | floating point, precision set at run time | yes | yes     | yes      |
/// | `Rational` | exact fraction                       | yes     | no       | no       |
/// | `Interval` | certified enclosure (interval.hpp)   | no      | yes      | no       |
///
/// A function that a type cannot serve does not compile for it.
///
/// \code{.cpp}
/// // a third, as far as each type has it
/// assert(Rational(1) / Rational(3) * Rational(3) == Rational(1));
/// assert(from_rational<double>(Rational(1, 3)) == 1.0 / 3.0);
/// const Mpfr50 third = from_rational<Mpfr50>(Rational(1, 3));
/// assert(abs(third * Mpfr50(3) - Mpfr50(1)) < epsilon<Mpfr50>());
/// \endcode

#include <Eigen/Core>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <concepts>
#include <limits>
#include <vector>

namespace plumbline {

namespace mp = boost::multiprecision;

/// Expression templates are off: `auto` and Eigen's expressions would keep references to dead temporaries.
using Mpfr50 = mp::number<mp::mpfr_float_backend<50, mp::allocate_stack>, mp::et_off>;
/// Precision in decimal digits is `Mpfr::default_precision()` at construction.
using Mpfr = mp::number<mp::mpfr_float_backend<0>, mp::et_off>;
/// Exact fraction.
using Rational = mp::number<mp::gmp_rational, mp::et_off>;
/// Integer of any size.
using Integer = mp::number<mp::gmp_int, mp::et_off>;

/// Has the four operations of a field.
template <class T>
concept Number = std::copyable<T> && requires(const T a, const T b) {
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a* b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { -a } -> std::convertible_to<T>;
  T(1);
};

/// Every comparison is decided.
template <class T>
concept Ordered = Number<T> && std::totally_ordered<T>;

/// Has sine and cosine.
template <class T>
concept Analytic = Number<T> && !std::same_as<T, Rational>;

/// Rounds: square roots and eigenvalues exist, to working precision.
template <class T>
concept Floating = Ordered<T> && Analytic<T>;

/// A column.
template <Number Real>
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
/// A matrix of any size.
template <Number Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Whether x is a number at all: neither infinite nor NaN.
template <Number Real>
bool is_finite(const Real& x) {
  if constexpr (Floating<Real>) {
    using std::isfinite;
    return isfinite(x);
  } else {
    return true;
  }
}

/// The number nearest to an exact fraction (Floating), the fraction itself (Rational).
template <Ordered Real>
Real from_rational(const Rational& x) {
  if constexpr (std::same_as<Real, Rational>) {
    return x;
  } else if constexpr (std::same_as<Real, double>) {
    mpfr_t nearest;  // 53 bits: mpq's own conversion to double truncates
    mpfr_init2(nearest, 53);
    mpfr_set_q(nearest, x.backend().data(), MPFR_RNDN);
    const double result = mpfr_get_d(nearest, MPFR_RNDN);
    mpfr_clear(nearest);
    return result;
  } else {
    Real nearest(0);
    mpfr_set_q(nearest.backend().data(), x.backend().data(), MPFR_RNDN);
    return nearest;
  }
}

/// Relative distance from 1 to the next larger number.
template <Floating Real>
Real epsilon() {
  if constexpr (std::same_as<Real, Mpfr>) {
    using std::ldexp;
    return ldexp(Real(1), 1 - static_cast<int>(mpfr_get_prec(Real(1).backend().data())));
  } else {
    return std::numeric_limits<Real>::epsilon();
  }
}

/// What Eigen asks of a scalar that it does not know. Boost 1.74's own version lacks members that Eigen 3.4
/// needs.
template <class T>
struct EigenScalar : Eigen::GenericNumTraits<T> {
  using Real = T;
  using NonInteger = T;
  using Nested = T;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 40,
    MulCost = 80
  };
  static T epsilon() {
    if constexpr (Floating<T>) {
      return plumbline::epsilon<T>();
    } else {
      return T(0);
    }
  }
  static T dummy_precision() { return epsilon() * 1000; }
  static T highest() { return (std::numeric_limits<T>::max)(); }
  static T lowest() { return (std::numeric_limits<T>::lowest)(); }
  static T infinity() { return std::numeric_limits<T>::infinity(); }
  static int digits10() { return std::numeric_limits<T>::digits10; }
};

}  // namespace plumbline

/// \cond
template <>
struct Eigen::NumTraits<plumbline::Mpfr50> : plumbline::EigenScalar<plumbline::Mpfr50> {};
template <>
struct Eigen::NumTraits<plumbline::Mpfr> : plumbline::EigenScalar<plumbline::Mpfr> {};
template <>
struct Eigen::NumTraits<plumbline::Rational> : plumbline::EigenScalar<plumbline::Rational> {};

// Products of fractions are computed entry by entry. Eigen's kernels for large products arrange numbers for
// registers and caches, which fractions never see, and take a compiler longer than most files.
template <class Left, class Right>
requires std::same_as<typename Left::Scalar, plumbline::Rational>
struct Eigen::internal::generic_product_impl<Left, Right, Eigen::DenseShape, Eigen::DenseShape,
                                             Eigen::GemmProduct>
    : Eigen::internal::generic_product_impl<Left, Right, Eigen::DenseShape, Eigen::DenseShape,
                                            Eigen::CoeffBasedProductMode> {
};
template <class Left, class Right>
requires std::same_as<typename Left::Scalar, plumbline::Rational>
struct Eigen::internal::generic_product_impl<Left, Right, Eigen::DenseShape, Eigen::DenseShape,
                                             Eigen::GemvProduct>
    : Eigen::internal::generic_product_impl<Left, Right, Eigen::DenseShape, Eigen::DenseShape,
                                            Eigen::CoeffBasedProductMode> {
};
/// \endcond
