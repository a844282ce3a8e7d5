#pragma once
/// \file
/// Several doubles that are computed with at once: vectors of GCC's and Clang's vector extension. The
/// compiler splits them where the machine's registers are narrower; with -march=native it uses the widest
/// there are. The functions take a single number as well, so that one text serves both.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#if defined(__GNUC__) && !defined(__clang__)
// How a vector is passed depends on the machine that is compiled for. None crosses a boundary between
// functions that are compiled apart; GCC warns at the end of the file, so that the pragma cannot be taken
// back.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace plumbline::detail {

/// How many doubles are computed with at once.
inline constexpr std::size_t lane_count = 8;
/// A double in each lane.
typedef double Lanes __attribute__((vector_size(lane_count * sizeof(double))));  // NOLINT
typedef double Pair __attribute__((vector_size(2 * sizeof(double))));            // NOLINT

/// What a comparison yields: -1 or 0 lane by lane, or a bool.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

template <class T>
concept Vectorised = std::same_as<T, Lanes> || std::same_as<T, Pair>;

/// The same number in every lane.
inline Lanes all_lanes(double x) {
  return Lanes{} + x;
}
/// |x|.
template <Vectorised V>
V magnitude(const V& x) {
  return (V)((Mask<V>)x & INT64_MAX);
}
/// The larger number, lane by lane.
template <class T>
T larger(const T& x, const T& y) {
  return x > y ? x : y;
}
/// The smaller number, lane by lane.
template <class T>
T smaller(const T& x, const T& y) {
  return x < y ? x : y;
}
/// -1 in the lanes whose sign bits differ, 0 in the others.
template <Vectorised V>
Mask<V> sign_differs(const V& x, const V& y) {
  return ((Mask<V>)x ^ (Mask<V>)y) >> 63;
}
/// The power of two that brings a positive normal number into [1, 2).
template <Vectorised V>
V to_unit_scale(const V& x) {
  return (V)((INT64_C(2046) - ((Mask<V>)x >> 52)) << 52);
}
/// Lane by lane; by Eigen, whose square roots are the machine's: std::sqrt would stop to set errno.
inline Lanes square_root(const Lanes& x) {
  using Doubles = Eigen::Array<double, lane_count, 1>;
  Lanes root;
  Eigen::Map<Doubles>(reinterpret_cast<double*>(&root)) =
      Eigen::Map<const Doubles>(reinterpret_cast<const double*>(&x)).sqrt();
  return root;
}
/// Of a single number.
template <class T>
T square_root(const T& x) {
  using std::sqrt;
  return sqrt(x);
}

/// Whether a condition holds.
inline bool any(bool mask) {
  return mask;
}
/// Whether a condition holds in some lane.
inline bool any(const Mask<Lanes>& mask) {
  std::int64_t either = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) either |= mask[lane];
  return either != 0;
}

/// v_i + v_{i+1} + … + v_7 in lane i.
inline Lanes suffix_sums(const Lanes& x) {
  Lanes v = x;
  const Lanes none{};
  v += __builtin_shufflevector(v, none, 1, 2, 3, 4, 5, 6, 7, 8);
  v += __builtin_shufflevector(v, none, 2, 3, 4, 5, 6, 7, 8, 9);
  v += __builtin_shufflevector(v, none, 4, 5, 6, 7, 8, 9, 10, 11);
  return v;
}

}  // namespace plumbline::detail
