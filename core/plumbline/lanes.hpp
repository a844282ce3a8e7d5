#pragma once
/// \file
/// Eight doubles that are computed with at once: a vector of GCC's and Clang's vector extension. The compiler
/// splits it where the machine's registers are narrower; with -march=native it uses the widest there are.

#include <cstddef>
#include <cstdint>

namespace plumbline {

inline constexpr std::size_t lane_count = 8;
typedef double Lanes __attribute__((vector_size(lane_count * sizeof(double))));           // NOLINT
typedef std::int64_t LaneBits __attribute__((vector_size(lane_count * sizeof(double))));  // NOLINT

/// Values and bit patterns of the same lanes.
union LaneView {
  Lanes values;
  LaneBits bits;
};

inline LaneBits bits_of(const Lanes& x) {
  return (LaneBits)x;
}  // NOLINT: a view, not a conversion
inline Lanes from_bits(const LaneBits& bits) {
  return (Lanes)bits;
}  // NOLINT
inline Lanes all_lanes(double x) {
  return Lanes{} + x;
}

/// |x|, lane by lane.
inline Lanes magnitude(const Lanes& x) {
  return from_bits(bits_of(x) & INT64_MAX);
}
inline Lanes larger(const Lanes& x, const Lanes& y) {
  return x > y ? x : y;
}
inline Lanes smaller(const Lanes& x, const Lanes& y) {
  return x < y ? x : y;
}
/// -1 in the lanes whose sign bits differ, 0 in the others.
inline LaneBits sign_differs(const Lanes& x, const Lanes& y) {
  return (bits_of(x) ^ bits_of(y)) >> 63;
}
/// The power of two that brings a positive normal number into [1, 2).
inline Lanes to_unit_scale(const Lanes& x) {
  return from_bits((INT64_C(2046) - (bits_of(x) >> 52)) << 52);
}

/// v_i + v_{i+1} + … + v_7 in lane i.
inline Lanes suffix_sums(Lanes v) {
  const Lanes none{};
  v += __builtin_shufflevector(v, none, 1, 2, 3, 4, 5, 6, 7, 8);
  v += __builtin_shufflevector(v, none, 2, 3, 4, 5, 6, 7, 8, 9);
  v += __builtin_shufflevector(v, none, 4, 5, 6, 7, 8, 9, 10, 11);
  return v;
}

}  // namespace plumbline
