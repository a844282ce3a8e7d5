#include "proofs/exact/decimal.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cstdint>
#include <numeric>

namespace plumbline::proofs {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

Integer power_of_ten(int exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// A fraction of integers that may share a factor: nothing here needs it in lowest terms, which cost more
/// than the rest.
struct Quotient {
  Integer over, under;
};

/// |x| 10^exponent.
Quotient shifted_size(const Rational& x, int exponent) {
  Quotient size{abs(mp::numerator(x)), mp::denominator(x)};
  (exponent < 0 ? size.under : size.over) *= power_of_ten(std::abs(exponent));
  return size;
}

/// The integer nearest to |x| 10^exponent, ties upwards.
Integer nearest_integer(const Rational& x, int exponent) {
  const auto [over, under] = shifted_size(x, exponent);
  return (2 * over + under) / (2 * under);
}

/// The e with 10^e <= |x| < 10^(e+1), for x other than 0.
int decimal_exponent(const Rational& x) {
  const auto digits = [](const Integer& i) {
    return static_cast<int>(mpz_sizeinbase(i.backend().data(), 10));
  };
  const auto reaches = [&](int e) {
    const auto [over, under] = shifted_size(x, -e);
    return over >= under;
  };
  int e = digits(mp::numerator(x)) - digits(mp::denominator(x));
  while (!reaches(e)) --e;
  while (reaches(e + 1)) ++e;
  return e;
}

/// digits 10^exponent.
Rational from_digits(const std::string& digits, int exponent) {
  constexpr int of_a_word = 18;  // such numbers, and such powers of ten, fit into 64 bits
  if (static_cast<int>(digits.size()) <= of_a_word && exponent <= 0 && exponent >= -of_a_word) {
    std::uint64_t over = 0, under = 1;
    std::from_chars(digits.data(), digits.data() + digits.size(), over);
    for (int e = 0; e > exponent; --e) under *= 10;
    const std::uint64_t common = std::gcd(over, under);
    Rational value;
    mpq_set_ui(value.backend().data(), over / common, under / common);
    return value;
  }
  const std::size_t first = digits.find_first_not_of('0');  // GMP reads a leading zero as octal
  return shifted(Rational(Integer(first == std::string::npos ? "0" : digits.substr(first))), exponent);
}

/// An integer with so many of its digits behind the point.
std::string with_point(std::string digits, int places) {
  const auto behind = static_cast<std::size_t>(places);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - behind, ".");
  return digits;
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
  Rational value = from_digits(digits, exponent);
  if (negative) value.backend().negate();
  return value;
}

Rational shifted(const Rational& x, int exponent) {
  const Integer scale = power_of_ten(std::abs(exponent));
  return exponent < 0 ? Rational(x / scale) : Rational(x * scale);
}

Rational unit_in_digit(const Rational& x, int digit) {
  return shifted(Rational(1), decimal_exponent(x) - digit + 1);
}

std::string to_exact(const Rational& x) {
  Integer rest = mp::denominator(x);
  int twos = 0, fives = 0;
  for (; rest % 2 == 0; rest /= 2) ++twos;
  for (; rest % 5 == 0; rest /= 5) ++fives;
  return rest == 1 ? to_fixed(x, std::max(twos, fives)) : x.str();
}

std::string to_fixed(const Rational& x, int places) {
  const Integer nearest = nearest_integer(x, places);
  return (x < 0 && nearest != 0 ? "-" : "") + with_point(nearest.str(), places);
}

std::string to_decimal(const Rational& x, int digits) {
  if (x == 0) return "0";
  int e = decimal_exponent(x);
  std::string text = nearest_integer(x, digits - 1 - e).str();
  if (text.size() > static_cast<std::size_t>(digits)) {  // 10^digits
    text.pop_back();
    ++e;
  }
  const std::string sign = x < 0 ? "-" : "";
  if (e >= -5 && e < digits) return sign + with_point(std::move(text), digits - 1 - e);
  if (digits > 1) text.insert(1, ".");
  return fmt::format("{}{}e{:+}", sign, text, e);
}

}  // namespace plumbline::proofs
