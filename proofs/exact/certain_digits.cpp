#include "proofs/exact/certain_digits.hpp"

namespace plumbline::proofs {

std::string certain_digits(const Interval& x, int most) {
  if (x.contains_zero()) return "0";
  for (int digits = most; digits > 0; --digits) {
    std::string low = x.lower().str(digits);
    if (low == x.upper().str(digits)) return low;
  }
  throw Error("equilibrium", x.text(6), "an enclosure of a digit or more");
}

Interval::End magnitude(const Interval& x) {
  return std::max(abs(x.lower()), abs(x.upper()));
}

}  // namespace plumbline::proofs
