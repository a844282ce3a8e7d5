#pragma once
/// \file
/// Units of measurement in experiments, and their conversion to SI.
///
/// A unit is a product of the symbols below, with powers and one or more slashes, and with a number where one
/// count of an instrument stands for so much: "mm", "N mm/rad", "kgf", "mm/s^2", "0.0879 deg", "9.79 mN".
/// Factors are exact but for the degree, whose pi has 50 digits. Sources: BIPM, The International System of
/// Units, 9th ed. (prefixes, min, h, degree); NIST SP 811 (2008), appendix B (inch, foot, pound, kgf, lbf).

#include <plumbline/base/number.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::diagnose {

/// Exponents of length, mass, time, angle and picture elements.
struct Dimension {
  int length = 0, mass = 0, time = 0, angle = 0, pixel = 0;
  bool operator==(const Dimension&) const = default;
};

/// A physical quantity.
struct Quantity {
  const char* name;  ///< "a length"
  Dimension dimension;
  const char* si;        ///< "m"
  const char* examples;  ///< "m, mm, cm, in, ft"
};

namespace quantity {
extern const Quantity length, force, angle, time, mass, stiffness, acceleration, torque, sliding_stiffness,
    pressure, volume, pixel;
}

struct Unit {
  std::string name;
  Mpfr50 factor = 1;  ///< in SI units
  [[nodiscard]] double in_si() const { return factor.convert_to<double>(); }
};

/// \throws Error at the place where the text is no unit of the quantity
Unit parse_unit(const std::string& text, const Quantity& quantity, const std::string& place);

/// The SI unit of a quantity.
Unit si_unit(const Quantity& quantity);

/// A decimal in a unit, converted to SI. It is rounded once: the result is the double nearest to the exact
/// product.
double in_si(std::string_view decimal, const Unit& unit);
/// The same for the shortest decimal of a double.
double in_si(double value, const Unit& unit);

}  // namespace plumbline::diagnose
