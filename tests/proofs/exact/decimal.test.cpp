#include "proofs/exact/decimal.hpp"

#include <algorithm>

#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("decimals are read exactly") {
  CHECK(parse_decimal("-1.25e-3") == Rational(-1, 800));
  CHECK(parse_decimal("007") == Rational(7));
  CHECK(parse_decimal(".5") == Rational(1, 2));
  CHECK(parse_decimal("+2.") == Rational(2));
  CHECK(parse_decimal("1E+2") == Rational(100));
  CHECK(parse_decimal("1e400").value() > Rational(1));
  CHECK(parse_decimal("0.1") != Rational(0.1));  // the double nearest to a tenth is not a tenth
}

TEST_CASE("a decimal ends where its view does, whatever stands behind it") {
  const std::string_view text = "12.5e123";
  CHECK(parse_decimal(text.substr(0, 2)) == Rational(12));
  CHECK(parse_decimal(text.substr(0, 4)) == Rational(25, 2));
  CHECK_FALSE(parse_decimal(text.substr(0, 5)));
  CHECK(parse_decimal(text.substr(0, 6)) == Rational(125));
  CHECK(parse_decimal(text.substr(0, 7)) == shifted(Rational(25, 2), 12));
  CHECK(parse_decimal(text) == shifted(Rational(25, 2), 123));
}

TEST_CASE("what is not a decimal is nothing") {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "nan", "inf", "0x10", "1,5", " 1", "1 ", "1.2.3",
                           "--1", "1e+-5", "1e1000000000"}) {
    CHECK_MESSAGE(!parse_decimal(text), std::string(text));
  }
}

TEST_CASE("rounding is to nearest, ties away from zero") {
  CHECK(to_fixed(Rational(1, 3), 4) == "0.3333");
  CHECK(to_fixed(Rational(-5, 1000), 2) == "-0.01");
  CHECK(to_fixed(Rational(-4, 1000), 2) == "0.00");
  CHECK(to_fixed(Rational(1999, 1000), 2) == "2.00");
  CHECK(to_fixed(Rational(7, 2), 0) == "4");
  CHECK(to_decimal(Rational(2, 3), 3) == "0.667");
  CHECK(to_decimal(Rational(9999), 3) == "1.00e+4");
  CHECK(to_decimal(Rational(-1, 3000000), 2) == "-3.3e-7");
  CHECK(to_decimal(0, 5) == "0");
}

TEST_CASE("a decimal that is written and read again is within half a unit of its last digit") {
  check_property("round trip", [] {
    const auto numerator = *rc::gen::inRange(-1000000L, 1000000L);
    const auto denominator = *rc::gen::inRange(1L, 1000000L);
    const auto digits = *rc::gen::inRange(1, 40);
    RC_PRE(numerator != 0);
    const Rational x(numerator, denominator);
    const std::string text = to_decimal(x, digits);
    const Rational read = parse_decimal(text).value();
    // half a unit in the last of the digits is at most half of 10^(1 - digits) of the number
    const Rational error = abs(Rational(read - x));
    RC_ASSERT(2 * error * mp::pow(Integer(10), static_cast<unsigned>(digits - 1)) <= abs(x));
    RC_ASSERT(to_decimal(read, digits) == text);
  });
}

TEST_CASE("zeros behind the point change nothing, however many") {
  check_property("zeros", [] {
    const auto whole = *rc::gen::inRange(0L, 1000000000L);
    const auto behind = *rc::gen::inRange(0, 30);
    const auto exponent = *rc::gen::inRange(-30, 30);
    std::string digits = std::to_string(whole);
    digits.insert(0, static_cast<std::size_t>(behind), '0');  // leading ones neither
    const std::string tail = "e" + std::to_string(exponent);
    const Rational value = Rational(whole) * mp::pow(Integer(10), static_cast<unsigned>(30 + exponent)) /
                           mp::pow(Integer(10), 30u);
    RC_ASSERT(parse_decimal(digits + tail).value() == value);
    RC_ASSERT(parse_decimal("-" + digits + "." + std::string(20, '0') + tail).value() == -value);
  });
}

TEST_CASE("where exponents begin") {
  CHECK(to_decimal(Rational(12, 1000000), 2) == "0.000012");
  CHECK(to_decimal(Rational(12, 10000000), 2) == "1.2e-6");
}

TEST_CASE("a unit in a digit, at powers of ten and beside them") {
  const Rational tiny(1, 1000000000);
  for (int e = -3; e <= 3; ++e) {
    const Rational power = shifted(Rational(1), e);
    CHECK(unit_in_digit(power, 3) == shifted(Rational(1), e - 2));
    CHECK(unit_in_digit(-power, 1) == power);
    CHECK(unit_in_digit(power * (1 - tiny), 3) == shifted(Rational(1), e - 3));
    CHECK(unit_in_digit(power * (1 + tiny), 3) == shifted(Rational(1), e - 2));
  }
}
