#pragma once
/// \file
/// Certified enclosures.
///
/// The contract, once for all: the result of every operation contains the true value for every choice of
/// values inside its arguments. There is no `<` and no `==`, which could not always be decided; the
/// comparisons below answer "certainly" or not at all.
///
/// \code{.cpp}
/// const Interval tenth(Rational(1, 10));  // which no binary number is
/// assert(tenth.contains(Rational(1, 10)) && tenth.width() > 0);
/// const Interval one = sqr(sin(tenth)) + sqr(cos(tenth));
/// assert(one.contains(Rational(1)));
/// assert(certainly_less(tenth, one) && !certainly_less(one, one));
/// \endcode

#include <boost/multiprecision/mpfi.hpp>
#include <optional>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>

namespace plumbline {

/// A closed interval with 64-digit MPFR ends: wide enough to certify 50 digits.
class Interval {
 public:
  /// What holds the two ends.
  using Enclosure = mp::number<mp::mpfi_float_backend<64>, mp::et_off>;
  /// The type of an end; its precision is that of the interval.
  using End = mp::number<mp::mpfr_float_backend<64>, mp::et_off>;

  Interval() : value_(0) {}
  /// The integer itself.
  Interval(int exact) : value_(exact) {}  // NOLINT(google-explicit-constructor): an integer is exact
  /// The double itself, which is rarely the decimal that was typed.
  static Interval from_double(double exact) { return Interval(Enclosure(exact)); }
  /// The smallest interval around an exact fraction.
  explicit Interval(const Rational& exact) { mpfi_set_q(value_.backend().data(), exact.backend().data()); }
  /// From low to high; an Error when they are out of order or not numbers.
  Interval(const End& low, const End& high) {
    if (!(low <= high)) throw Error("interval", "ends out of order", "low <= high");
    mpfi_interv_fr(value_.backend().data(), low.backend().data(), high.backend().data());
  }

  /// The tightest enclosure of pi.
  static Interval pi() {
    Interval result;
    mpfi_const_pi(result.value_.backend().data());
    return result;
  }

  /// The lower end.
  [[nodiscard]] End lower() const {
    End end;
    mpfi_get_left(end.backend().data(), value_.backend().data());
    return end;
  }
  /// The upper end.
  [[nodiscard]] End upper() const {
    End end;
    mpfi_get_right(end.backend().data(), value_.backend().data());
    return end;
  }
  /// A number near the middle, inside.
  [[nodiscard]] End middle() const {
    End end;
    mpfi_mid(end.backend().data(), value_.backend().data());
    return end;
  }
  /// An upper bound of the distance between the ends.
  [[nodiscard]] End width() const {
    End end;
    mpfi_diam_abs(end.backend().data(), value_.backend().data());
    return end;
  }
  /// Whether the fraction lies inside, ends included.
  [[nodiscard]] bool contains(const Rational& x) const {
    return mpfr_cmp_q(&value_.backend().data()->left, x.backend().data()) <= 0 &&
           mpfr_cmp_q(&value_.backend().data()->right, x.backend().data()) >= 0;
  }
  /// Whether zero lies inside, ends included.
  [[nodiscard]] bool contains_zero() const { return mpfi_has_zero(value_.backend().data()) != 0; }
  /// Whether every value of this interval lies in the other one.
  [[nodiscard]] bool inside(const Interval& other) const {
    return mpfi_is_inside(value_.backend().data(), other.value_.backend().data()) != 0;
  }

  /// Of the opposite numbers.
  Interval operator-() const { return Interval(Enclosure(-value_)); }
  /// Of every sum.
  friend Interval operator+(const Interval& a, const Interval& b) {
    return Interval(Enclosure(a.value_ + b.value_));
  }
  /// Of every difference.
  friend Interval operator-(const Interval& a, const Interval& b) {
    return Interval(Enclosure(a.value_ - b.value_));
  }
  /// Of every product.
  friend Interval operator*(const Interval& a, const Interval& b) {
    return Interval(Enclosure(a.value_ * b.value_));
  }
  /// A divisor that contains zero gives the whole line.
  friend Interval operator/(const Interval& a, const Interval& b) {
    return Interval(Enclosure(a.value_ / b.value_));
  }
  /// See operator+.
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  /// See operator-.
  Interval& operator-=(const Interval& b) { return *this = *this - b; }
  /// See operator*.
  Interval& operator*=(const Interval& b) { return *this = *this * b; }
  /// See operator/.
  Interval& operator/=(const Interval& b) { return *this = *this / b; }

  /// Of every sine.
  friend Interval sin(const Interval& x) {
    Interval result;
    mpfi_sin(result.value_.backend().data(), x.value_.backend().data());
    return result;
  }
  /// Of every cosine.
  friend Interval cos(const Interval& x) {
    Interval result;
    mpfi_cos(result.value_.backend().data(), x.value_.backend().data());
    return result;
  }
  /// x squared: tighter than x * x, whose factors would be taken as independent.
  friend Interval sqr(const Interval& x) {
    Interval result;
    mpfi_sqr(result.value_.backend().data(), x.value_.backend().data());
    return result;
  }
  /// An Error where x is not certainly non-negative.
  friend Interval sqrt(const Interval& x) {
    if (mpfi_is_nonneg(x.value_.backend().data()) == 0) {
      throw Error("square root of an interval", x.text(6), "no negative value in it");
    }
    Interval result;
    mpfi_sqrt(result.value_.backend().data(), x.value_.backend().data());
    return result;
  }

  /// Whether every value of a is less than every value of b.
  friend bool certainly_less(const Interval& a, const Interval& b) { return a.upper() < b.lower(); }
  /// Whether every value is above zero.
  friend bool certainly_positive(const Interval& x) {
    return mpfi_is_strictly_pos(x.value_.backend().data()) != 0;
  }
  /// Whether every value is below zero.
  friend bool certainly_negative(const Interval& x) {
    return mpfi_is_strictly_neg(x.value_.backend().data()) != 0;
  }
  /// What both contain; nothing when they are certainly disjoint.
  friend std::optional<Interval> intersection(const Interval& a, const Interval& b) {
    if (certainly_less(a, b) || certainly_less(b, a)) return std::nullopt;
    return Interval(std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper()));
  }
  /// The smallest interval that holds both.
  friend Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
  }

  /// `[low, high]`, each end to so many digits and rounded outwards.
  [[nodiscard]] std::string text(int digits) const {
    return "[" + end_text(&value_.backend().data()->left, digits, MPFR_RNDD) + ", " +
           end_text(&value_.backend().data()->right, digits, MPFR_RNDU) + "]";
  }

 private:
  explicit Interval(Enclosure value) : value_(std::move(value)) {}
  static std::string end_text(mpfr_srcptr end, int digits, mpfr_rnd_t rounding) {
    char* buffer = nullptr;
    mpfr_asprintf(&buffer, "%.*R*g", digits, rounding, end);
    std::string result(buffer);
    mpfr_free_str(buffer);
    return result;
  }

  Enclosure value_;
};

}  // namespace plumbline

/// \cond
template <>
struct Eigen::NumTraits<plumbline::Interval> : plumbline::EigenScalar<plumbline::Interval> {};
/// \endcond
