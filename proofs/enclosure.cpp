#include "proofs/enclosure.hpp"

#include <algorithm>
#include <plumbline/critical_force.hpp>
#include <string>

#include "proofs/exact_count.hpp"

namespace plumbline {
namespace {

/// Sets the precision of Mpfr, in decimal digits, for a while.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(int digits) : before_(Mpfr::default_precision()) {
    Mpfr::default_precision(static_cast<unsigned>(digits));
  }
  ~WorkingPrecision() { Mpfr::default_precision(before_); }
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

 private:
  unsigned before_;
};

Integer power_of_ten(long exponent) {
  return mp::pow(Integer(10), static_cast<unsigned>(exponent));
}

Rational decimal(const Integer& mantissa, long exponent) {
  return exponent < 0 ? Rational(mantissa, power_of_ten(-exponent))
                      : Rational(mantissa * power_of_ten(exponent));
}

/// Two units on either side of x in the digit after `kept` + `guard` significant ones. Nothing when the two
/// ends round to different decimals of `kept` digits.
std::optional<std::pair<Rational, Rational>> bounds(const Mpfr& x, int kept, int guard) {
  long exponent = 0;
  const auto digits = static_cast<std::size_t>(kept + guard);
  char* const text = mpfr_get_str(nullptr, &exponent, 10, digits, x.backend().data(), MPFR_RNDN);
  const Integer mantissa(text), tail = power_of_ten(guard);
  mpfr_free_str(text);
  const auto rounded = [&](const Integer& m) { return Integer((m + tail / 2) / tail); };
  const Integer low = mantissa - 2, high = mantissa + 2;
  if (rounded(low) != rounded(high)) return std::nullopt;
  const long place = exponent - static_cast<long>(digits);
  return std::pair(decimal(low, place), decimal(high, place));
}

}  // namespace
}  // namespace plumbline
