#pragma once
/// \file
/// Forward differentiation: numbers that carry their derivatives by several variables.

#include <Eigen/Core>
#include <cmath>

namespace plumbline::motion {

/// A double and its derivatives by `size` variables. Comparisons look at the value alone. Most of the time of
/// a diagnosis is spent in these operators, which are too many for the compiler to inline unasked.
/// \code{.cpp}
/// const Dual<1> x = Dual<1>::variable(0.5, 0);
/// assert((x * x).derivative(0) == 1.0);
/// \endcode
template <int size>
struct Dual {
  using Derivative = Eigen::Array<double, size, 1>;
  double value = 0;
  Derivative derivative = Derivative::Zero();

  Dual() = default;
  Dual(double constant) : value(constant) {}
  Dual(double of, const Derivative& slope) : value(of), derivative(slope) {}
  /// The variable of this number.
  static Dual variable(double value, Eigen::Index number) {
    Dual x(value);
    x.derivative(number) = 1;
    return x;
  }

  [[gnu::always_inline]] friend Dual operator-(const Dual& a) { return {-a.value, -a.derivative}; }
  [[gnu::always_inline]] friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  [[gnu::always_inline]] friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  [[gnu::always_inline]] friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.derivative + b.value * a.derivative};
  }
  [[gnu::always_inline]] friend Dual operator/(const Dual& a, const Dual& b) {
    const double ratio = a.value / b.value, share = 1 / b.value;
    return {ratio, share * (a.derivative - ratio * b.derivative)};
  }
  [[gnu::always_inline]] friend Dual operator+(const Dual& a, double b) {
    return {a.value + b, a.derivative};
  }
  [[gnu::always_inline]] friend Dual operator+(double a, const Dual& b) { return b + a; }
  [[gnu::always_inline]] friend Dual operator-(const Dual& a, double b) {
    return {a.value - b, a.derivative};
  }
  [[gnu::always_inline]] friend Dual operator-(double a, const Dual& b) {
    return {a - b.value, -b.derivative};
  }
  [[gnu::always_inline]] friend Dual operator*(const Dual& a, double b) {
    return {a.value * b, a.derivative * b};
  }
  [[gnu::always_inline]] friend Dual operator*(double a, const Dual& b) { return b * a; }
  [[gnu::always_inline]] friend Dual operator/(const Dual& a, double b) { return a * (1 / b); }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return b < a; }
};

template <int size>
Dual<size> sin(const Dual<size>& x) {
  return {std::sin(x.value), std::cos(x.value) * x.derivative};
}
template <int size>
Dual<size> cos(const Dual<size>& x) {
  return {std::cos(x.value), -std::sin(x.value) * x.derivative};
}
template <int size>
Dual<size> exp(const Dual<size>& x) {
  const double value = std::exp(x.value);
  return {value, value * x.derivative};
}
/// Of slope zero at zero.
template <int size>
Dual<size> abs(const Dual<size>& x) {
  const double sign = x.value > 0 ? 1 : x.value < 0 ? -1 : 0;
  return {std::abs(x.value), sign * x.derivative};
}

/// The value of a number, whether or not it carries derivatives.
inline double value_of(double x) {
  return x;
}
template <int size>
double value_of(const Dual<size>& x) {
  return x.value;
}

/// f(x) where f and its slope at x are known as doubles.
inline double composed(double f, double, double) {
  return f;
}
template <int size>
Dual<size> composed(double f, double slope, const Dual<size>& x) {
  return {f, slope * x.derivative};
}

}  // namespace plumbline::motion
