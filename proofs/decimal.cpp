#include "proofs/decimal.hpp"

#include <charconv>

namespace plumbline::proofs {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

Integer power_of_ten(unsigned exponent) {
  return mp::pow(Integer(10), exponent);
}

/// The integer nearest to a non-negative fraction, ties upwards.
Integer nearest_integer(const Rational& x) {
  return (2 * mp::numerator(x) + mp::denominator(x)) / (2 * mp::denominator(x));
}

/// The e with 10^e <= x < 10^(e+1), for x > 0.
int decimal_exponent(const Rational& x) {
  const auto digits = [](const Integer& i) {
    return static_cast<int>(mpz_sizeinbase(i.backend().data(), 10));
  };
  int e = digits(mp::numerator(x)) - digits(mp::denominator(x));
  while (shifted(Rational(1), e) > x) --e;
  while (shifted(Rational(1), e + 1) <= x) ++e;
  return e;
}

}  // namespace

std::optional<Rational> parse_decimal(std::string_view text) {
  std::string digits;
  int exponent = 0;
  std::size_t at = 0;
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++at;
  for (; at < text.size() && is_digit(text[at]); ++at) digits += text[at];
  if (at < text.size() && text[at] == '.') {
    for (++at; at < text.size() && is_digit(text[at]); ++at, --exponent) digits += text[at];
  }
  if (digits.empty()) return std::nullopt;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const bool plus = at < text.size() && text[at] == '+';
    if (plus) ++at;
    if (plus && (at == text.size() || !is_digit(text[at]))) return std::nullopt;
    int power = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), power);
    if (error != std::errc() || power > 100000 || power < -100000) return std::nullopt;
    at = static_cast<std::size_t>(end - text.data());
    exponent += power;
  }
  if (at != text.size()) return std::nullopt;
  const std::size_t first = digits.find_first_not_of('0');  // GMP reads a leading zero as octal
  const Rational value =
      shifted(Rational(Integer(first == std::string::npos ? "0" : digits.substr(first))), exponent);
  return negative ? Rational(-value) : value;
}

Rational shifted(const Rational& x, int exponent) {
  const Integer scale = power_of_ten(static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(x / scale) : Rational(x * scale);
}

Rational unit_in_digit(const Rational& x, int digit) {
  return shifted(Rational(1), decimal_exponent(x < 0 ? Rational(-x) : x) - digit + 1);
}

std::string to_exact(const Rational& x) {
  Integer rest = mp::denominator(x);
  int twos = 0, fives = 0;
  for (; rest % 2 == 0; rest /= 2) ++twos;
  for (; rest % 5 == 0; rest /= 5) ++fives;
  return rest == 1 ? to_fixed(x, std::max(twos, fives)) : x.str();
}

std::string to_fixed(const Rational& x, int places) {
  const Rational magnitude = x < 0 ? Rational(-x) : x;
  std::string digits = nearest_integer(shifted(magnitude, places)).str();
  const auto behind = static_cast<std::size_t>(places);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - behind, ".");
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return x < 0 && !zero ? "-" + digits : digits;
}

std::string to_decimal(const Rational& x, int digits) {
  if (x == 0) return "0";
  const Rational magnitude = x < 0 ? Rational(-x) : x;
  int e = decimal_exponent(magnitude);
  Integer mantissa = nearest_integer(shifted(magnitude, digits - 1 - e));
  if (mantissa == power_of_ten(static_cast<unsigned>(digits))) {
    mantissa /= 10;
    ++e;
  }
  if (e >= -5 && e < digits)
    return to_fixed(shifted(Rational(x < 0 ? -mantissa : mantissa), e - digits + 1), digits - 1 - e);
  std::string text = mantissa.str();
  if (digits > 1) text.insert(1, ".");
  return (x < 0 ? "-" : "") + text + "e" + (e < 0 ? "-" : "+") + std::to_string(e < 0 ? -e : e);
}

}  // namespace plumbline::proofs
