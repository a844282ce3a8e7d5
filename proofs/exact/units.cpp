#include "proofs/exact/units.hpp"

namespace plumbline::proofs {

namespace {

/// The power of two just above every value.
Interval unit_above(const std::vector<Interval>& values) {
  Interval::End largest(0);
  for (const Interval& x : values) largest = std::max(largest, x.upper());
  if (largest == 0) return Interval(1);
  int exponent = 0;
  frexp(largest, &exponent);
  const Interval::End unit = ldexp(Interval::End(1), exponent);
  return {unit, unit};
}

std::vector<Interval> measured(const std::vector<Interval>& values, const Interval& unit, const char* list) {
  std::vector<Interval> result;
  for (const Interval& x : values) {
    result.push_back(x / unit);
    if (certainly_positive(x) && result.back().lower() < Interval::End("1e-60"))
      throw Error(list, "values that differ by a factor above 1e60", "a smaller ratio");
  }
  return result;
}

}  // namespace

Units own_units(const Chain<Interval>& chain) {
  return {unit_above(chain.length()), unit_above(chain.stiffness())};
}

Chain<Interval> in_units(const Chain<Interval>& chain, const Units& units) {
  return Chain<Interval>(measured(chain.length(), units.length, "lengths"),
                         measured(chain.stiffness(), units.stiffness, "stiffness"), chain.rest());
}

Point<Interval> in_units(const Point<Interval>& load, Control control, const Units& units) {
  const Interval unit = control == Control::end_point ? units.length : units.force();
  return {load.x / unit, load.y / unit};
}

}  // namespace plumbline::proofs
