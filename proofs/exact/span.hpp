#pragma once
/// \file
/// A fast interval of doubles for searches that visit millions of boxes.
///
/// The contract is that of Interval: every result contains the true value. Sums, products and quotients are
/// rounded to nearest, each within half a unit in the last place, and widened by a whole one; no rounding
/// mode is switched. Sine and cosine trust the C library to four units in the last place (glibc documents
/// one). Where doubles overflow the result is the whole line, or not a number, which contains everything.

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/interval.hpp>

namespace plumbline::proofs {

struct Span {
  double low = 0, high = 0;

  Span() = default;
  Span(double exact) : low(exact), high(exact) {}  // NOLINT(google-explicit-constructor): a double is exact
  Span(double low_, double high_) : low(low_), high(high_) {}
  explicit Span(const Interval& x)
      : low(mpfr_get_d(x.lower().backend().data(), MPFR_RNDD)),
        high(mpfr_get_d(x.upper().backend().data(), MPFR_RNDU)) {}

  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double middle() const { return low + (high - low) / 2; }
  /// The largest absolute value inside.
  [[nodiscard]] double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] bool inside(const Span& other) const { return other.low <= low && high <= other.high; }
  /// Certainly nothing; an end that is not a number excludes nothing.
  [[nodiscard]] bool empty() const { return low > high; }
  static Span everything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  static constexpr double ulp = 2.3e-16, tiny = 5e-324;
  static double down(double x, double ulps = 1) { return x - (std::abs(x) * (ulp * ulps) + tiny); }
  static double up(double x, double ulps = 1) { return x + (std::abs(x) * (ulp * ulps) + tiny); }

  /// The whole line where an end is not a number.
  static Span lined(double low, double high) {
    return std::isnan(low + high) ? everything() : Span(low, high);
  }

  friend Span operator-(const Span& a) { return {-a.high, -a.low}; }
  friend Span operator+(const Span& a, const Span& b) {
    return lined(down(a.low + b.low), up(a.high + b.high));
  }
  friend Span operator-(const Span& a, const Span& b) {
    return lined(down(a.low - b.high), up(a.high - b.low));
  }
  friend Span operator*(const Span& a, const Span& b) {
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    if (std::isnan(p + q + r + s)) return everything();
    return {down(std::min(std::min(p, q), std::min(r, s))), up(std::max(std::max(p, q), std::max(r, s)))};
  }
  friend Span operator*(double a, const Span& b) {
    const double p = a * b.low, q = a * b.high;
    if (std::isnan(p + q)) return everything();
    return {down(std::min(p, q)), up(std::max(p, q))};
  }
  /// The whole line where the divisor contains zero.
  friend Span operator/(const Span& a, const Span& b) {
    if (b.contains(0)) return everything();
    const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
    if (std::isnan(p + q + r + s)) return everything();
    return {down(std::min(std::min(p, q), std::min(r, s))), up(std::max(std::max(p, q), std::max(r, s)))};
  }
  friend bool certainly_positive(const Span& x) { return x.low > 0; }
  friend bool certainly_negative(const Span& x) { return x.high < 0; }

  Span& operator+=(const Span& b) { return *this = *this + b; }
  Span& operator-=(const Span& b) { return *this = *this - b; }

  friend Span intersection(const Span& a, const Span& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
  }
  friend Span hull(const Span& a, const Span& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
  }
};

/// For the entries of a vector or a matrix.
inline constexpr auto magnitude_of = [](const Span& x) { return x.magnitude(); };

/// `[low, high]`, each end to so many digits and rounded outwards.
inline std::string text(const Span& x, int digits) {
  return hull(Interval::from_double(x.low), Interval::from_double(x.high)).text(digits);
}

/// Cosine and sine of every angle in a span.
struct Circle {
  Span cosine, sine;
};

inline Circle circle(const Span& x) {
  constexpr double quarter = 1.5707963267948966;
  if (!(x.width() < 6.28) || !(x.magnitude() < 1e6)) return {{-1, 1}, {-1, 1}};
  const double c0 = std::cos(x.low), c1 = std::cos(x.high), s0 = std::sin(x.low), s1 = std::sin(x.high);
  Span c{Span::down(std::min(c0, c1), 4), Span::up(std::max(c0, c1), 4)};
  Span s{Span::down(std::min(s0, s1), 4), Span::up(std::max(s0, s1), 4)};
  // the quarter turns inside, or so near an end that rounding leaves it open: there an extreme value may lie
  const double slack = 1e-9;  // far above the rounding of x / quarter below the million
  const auto first = static_cast<long>(std::ceil(x.low / quarter - slack));
  const auto last = static_cast<long>(std::floor(x.high / quarter + slack));
  for (long turn = first; turn <= last; ++turn) {
    switch (((turn % 4) + 4) % 4) {
      case 0:
        c.high = 1;
        break;
      case 1:
        s.high = 1;
        break;
      case 2:
        c.low = -1;
        break;
      default:
        s.low = -1;
        break;
    }
  }
  return {{std::max(c.low, -1.0), std::min(c.high, 1.0)}, {std::max(s.low, -1.0), std::min(s.high, 1.0)}};
}

inline Span cos(const Span& x) {
  return circle(x).cosine;
}
inline Span sin(const Span& x) {
  return circle(x).sine;
}

}  // namespace plumbline::proofs

template <>
struct Eigen::NumTraits<plumbline::proofs::Span> : plumbline::EigenScalar<plumbline::proofs::Span> {};
