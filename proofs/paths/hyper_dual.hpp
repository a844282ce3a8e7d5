#pragma once
/// \file
/// A span with its derivatives in two directions and the mixed second one (Fike, Alonso 2011): equations that
/// are written once give their Jacobian and their bend.

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

struct HyperDual {
  Span value, first, second, both;  ///< f, f' v, f' w, f'' v w

  HyperDual() = default;
  /// A constant.
  HyperDual(const Span& constant) : value(constant) {}  // NOLINT(google-explicit-constructor): it is one
  HyperDual(const Span& f, const Span& v, const Span& w, const Span& vw)
      : value(f), first(v), second(w), both(vw) {}

  friend HyperDual operator+(const HyperDual& a, const HyperDual& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second, a.both + b.both};
  }
  friend HyperDual operator-(const HyperDual& a, const HyperDual& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second, a.both - b.both};
  }
  friend HyperDual operator*(const HyperDual& a, const HyperDual& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first, a.second * b.value + a.value * b.second,
            a.both * b.value + a.first * b.second + a.second * b.first + a.value * b.both};
  }
  HyperDual& operator+=(const HyperDual& b) { return *this = *this + b; }
  HyperDual& operator-=(const HyperDual& b) { return *this = *this - b; }
};

/// Cosine and sine of an angle.
struct HyperCircle {
  HyperDual cosine, sine;
};

inline HyperCircle circle(const HyperDual& x) {
  const auto [c, s] = circle(x.value);
  const Span square = x.first * x.second;
  return {{c, -s * x.first, -s * x.second, -s * x.both - c * square},
          {s, c * x.first, c * x.second, c * x.both - s * square}};
}

}  // namespace plumbline::proofs
