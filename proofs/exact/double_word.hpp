#pragma once
/// \file
/// Sums of two doubles that are added and multiplied to more than a hundred bits, in many lanes at once.
///
/// With u = 2^-53, a sum is within 3 u^2 / (1 - 4u) of the true one, relatively, whatever the signs, and a
/// product within 7 u^2: Joldes, Muller and Popescu, ACM TOMS 44 (2017), algorithms 6 and 10; Muller and
/// Rideau, ACM TOMS 48 (2022), have checked these by machine, the product to within 5 u^2. That holds as long
/// as no number on the way is above 2^990 or, but for zero, so small that its rounding error underflows. The
/// compiler must not contract products and sums here (-ffp-contract=off).

namespace plumbline::proofs {

/// high + low, where high is the double nearest to the sum. T: double, or a vector of doubles.
template <class T>
struct DoubleWord {
  T high, low;
};

/// A bound on the relative error of a sum and of a product: 64 u^2, far from tight.
constexpr double double_word_unit = 0x1p-100;

/// a + b without an error (Knuth).
template <class T>
[[gnu::always_inline]] inline DoubleWord<T> exact_sum(const T& a, const T& b) {
  const T sum = a + b, of_b = sum - a, of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}

/// The same where |a| >= |b|, or a = 0 (Dekker).
template <class T>
[[gnu::always_inline]] inline DoubleWord<T> exact_sum_of_ordered(const T& a, const T& b) {
  const T sum = a + b;
  return {sum, b - (sum - a)};
}

/// x as a sum of two numbers of 26 bits (Veltkamp).
template <class T>
[[gnu::always_inline]] inline DoubleWord<T> halves(const T& x) {
  const T large = x * 0x1.0000002p27, high = large - (large - x);
  return {high, x - high};
}

template <class T>
[[gnu::always_inline]] inline DoubleWord<T> operator+(const DoubleWord<T>& x, const DoubleWord<T>& y) {
  const DoubleWord<T> high = exact_sum(x.high, y.high), low = exact_sum(x.low, y.low);
  const DoubleWord<T> sum = exact_sum_of_ordered(high.high, T(high.low + low.high));
  return exact_sum_of_ordered(sum.high, T(low.low + sum.low));
}

/// A: that of one factor, the same for all lanes of the other, or T.
template <class A, class T>
[[gnu::always_inline]] inline DoubleWord<T> operator*(const DoubleWord<A>& x, const DoubleWord<T>& y) {
  const DoubleWord<A> a = halves(x.high);
  const DoubleWord<T> b = halves(y.high);
  const T product = x.high * y.high;
  const T error = a.low * b.low - (((product - a.high * b.high) - a.low * b.high) - a.high * b.low);
  return exact_sum_of_ordered(product, T(error + (x.high * y.low + x.low * y.high)));
}

}  // namespace plumbline::proofs
