#include "verify/judging/formula_value.hpp"

#include <plumbline/base/error.hpp>
#include <regex>
#include <sstream>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/expression.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

Rational rational(const GiNaC::numeric& number) {
  std::ostringstream text;
  text << number;
  return Rational(text.str());
}

Interval power(const Interval& base, const ex& exponent) {
  const ex twice = 2 * exponent;
  if (!twice.info(GiNaC::info_flags::integer))
    throw Error("formula", "the power " + proofs::text(exponent), "a half integer");
  const int halves = GiNaC::ex_to<GiNaC::numeric>(twice).to_int(), whole = std::abs(halves) / 2;
  Interval result(1);
  for (int i = 0; i + 1 < whole; i += 2) result *= sqr(base);
  if (whole % 2 == 1) result *= base;
  if (halves % 2 != 0) result *= sqrt(base);
  return halves < 0 ? Interval(1) / result : result;
}

Interval of_function(const ex& e, const Values& values) {
  const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
  const Interval at = value_of(e.op(0), values);
  if (name == "sin") return sin(at);
  if (name == "cos") return cos(at);
  if (name == "tan") return sin(at) / cos(at);
  throw Error("formula", "the function " + name, "sin, cos or tan");
}

}  // namespace

Interval value_of(const ex& e, const Values& values) {
  if (GiNaC::is_a<GiNaC::numeric>(e)) return Interval(rational(GiNaC::ex_to<GiNaC::numeric>(e)));
  if (e.is_equal(GiNaC::Pi)) return Interval::pi();
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(e).get_name();
    const auto found = values.find(name);
    if (found == values.end()) throw Error("formula", "no value of " + name, "one");
    return found->second;
  }
  if (GiNaC::is_a<GiNaC::power>(e)) return power(value_of(e.op(0), values), e.op(1));
  if (GiNaC::is_a<GiNaC::function>(e)) return of_function(e, values);
  const bool sum = GiNaC::is_a<GiNaC::add>(e);
  if (!sum && !GiNaC::is_a<GiNaC::mul>(e)) throw Error("formula", proofs::text(e), "a number");
  Interval result(sum ? 0 : 1);
  for (const ex& part : e) {
    const Interval one = value_of(part, values);
    result = sum ? result + one : result * one;
  }
  return result;
}

std::string with_fractions(const std::string& formula) {
  static const std::regex decimals(R"(\d+\.\d+)");
  std::string result;
  auto rest = formula.begin();
  for (std::sregex_iterator one(formula.begin(), formula.end(), decimals), end; one != end; ++one) {
    const auto at = formula.begin() + one->position();
    result.append(rest, at);
    result += "(" + proofs::parse_decimal(one->str()).value().str() + ")";
    rest = at + one->length();
  }
  return result.append(rest, formula.end());
}

Interval number(const std::string& text) {
  if (const auto decimal = proofs::parse_decimal(text)) return Interval(*decimal);
  static const proofs::Formulas only({"pi"});
  return value_of(only.parse(with_fractions(text)), {{"pi", Interval::pi()}});
}

}  // namespace plumbline::verify
