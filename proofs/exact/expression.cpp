#include "proofs/exact/expression.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <plumbline/base/error.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace plumbline::proofs {
namespace {

using GiNaC::ex;

/// Replaces sines and cosines by rational functions of the half-angle tangents of their symbols.
class HalfAngles : public GiNaC::map_function {
 public:
  ex operator()(const ex& e) override {
    if (GiNaC::is_a<GiNaC::function>(e)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
      if (name == "sin") return turn(e.op(0)).second;
      if (name == "cos") return turn(e.op(0)).first;
      throw Error("formula", text(e), "no function but sin and cos");
    }
    return e.map(*this);
  }

 private:
  using Turn = std::pair<ex, ex>;  // cosine and sine

  static Turn add(const Turn& a, const Turn& b) {
    return {a.first * b.first - a.second * b.second, a.second * b.first + a.first * b.second};
  }

  Turn turn(const ex& angle) {
    Turn result{1, 0};
    const ex sum = angle.expand();
    const std::size_t terms = GiNaC::is_a<GiNaC::add>(sum) ? sum.nops() : 1;
    for (std::size_t i = 0; i < terms; ++i) {
      const ex term = GiNaC::is_a<GiNaC::add>(sum) ? sum.op(i) : sum;
      result = add(result, multiple(term));
    }
    return result;
  }

  Turn multiple(const ex& term) {
    if (term.is_zero()) return {1, 0};
    ex symbol = term;
    ex factor = 1;
    if (GiNaC::is_a<GiNaC::mul>(term) && term.nops() == 2 && GiNaC::is_a<GiNaC::numeric>(term.op(1))) {
      symbol = term.op(0);
      factor = term.op(1);
    }
    if (!GiNaC::is_a<GiNaC::symbol>(symbol) || !factor.info(GiNaC::info_flags::integer)) {
      throw Error("formula", "the angle " + text(term), "an integer multiple of a symbol");
    }
    const ex t = tangent(symbol);
    const Turn once{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
    const int times = GiNaC::ex_to<GiNaC::numeric>(factor).to_int();
    Turn result{1, 0};
    for (int i = 0; i < std::abs(times); ++i) result = add(result, once);
    if (times < 0) result.second = -result.second;
    return result;
  }

  ex tangent(const ex& symbol) {
    auto [at, is_new] = tangents_.try_emplace(symbol, 0);
    if (is_new) at->second = GiNaC::symbol("t_" + text(symbol));
    return at->second;
  }

  std::map<ex, ex, GiNaC::ex_is_less> tangents_;
};

/// In brackets unless it binds closer than any operator.
std::string operand(const ex& e) {
  const bool closed = GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::function>(e) ||
                      e.info(GiNaC::info_flags::nonnegint);
  return closed ? text(e) : "(" + text(e) + ")";
}

std::vector<std::string> terms_of(const ex& sum) {
  std::vector<std::string> terms;
  for (const ex& term : sum) terms.push_back(text(term));
  std::sort(terms.begin(), terms.end());
  return terms;
}

bool negative(const std::string& term) {
  return term[0] == '-';
}

/// Whether a sum is turned round within a product: its first term, signs aside, is subtracted. GiNaC turns
/// sums by an order of its own, which is another one at every run.
bool upside_down(const ex& sum) {
  if (!GiNaC::is_a<GiNaC::add>(sum)) return false;
  const std::vector<std::string> terms = terms_of(sum);
  const auto unsigned_text = [](const std::string& term) { return term.substr(negative(term) ? 1 : 0); };
  return negative(*std::min_element(terms.begin(), terms.end(), [&](const auto& a, const auto& b) {
    return unsigned_text(a) < unsigned_text(b);
  }));
}

/// A factor of a product as the power that it is, its base the right way up.
struct Factor {
  ex base, exponent;
  bool negated;  ///< whether turning the base has changed the sign
};

Factor upright(const ex& e) {
  const bool power = GiNaC::is_a<GiNaC::power>(e);
  const ex base = power ? e.op(0) : e, exponent = power ? e.op(1) : ex(1);
  if (!exponent.info(GiNaC::info_flags::integer) || !upside_down(base)) return {base, exponent, false};
  return {(-base).expand(), exponent, exponent.info(GiNaC::info_flags::odd)};
}

std::string power_text(const ex& base, const ex& exponent) {
  if (exponent.is_equal(1)) return operand(base);
  if (exponent.is_equal(GiNaC::numeric(1, 2))) return "sqrt(" + text(base) + ")";
  return operand(base) + "^" + operand(exponent);
}

std::string product_text(const std::vector<ex>& all) {
  ex number = 1;
  std::vector<std::string> factors, divisors;
  for (const ex& one : all) {
    if (GiNaC::is_a<GiNaC::numeric>(one)) {
      number = number * one;
      continue;
    }
    const Factor factor = upright(one);
    if (factor.negated) number = -number;
    if (factor.exponent.info(GiNaC::info_flags::negative))
      divisors.push_back(power_text(factor.base, -factor.exponent));
    else
      factors.push_back(power_text(factor.base, factor.exponent));
  }
  std::sort(factors.begin(), factors.end());
  std::sort(divisors.begin(), divisors.end());
  const bool sign_alone = number.is_equal(-1) && !factors.empty();
  if (!number.is_equal(1) && !sign_alone) factors.insert(factors.begin(), text(number));
  if (factors.empty()) factors.emplace_back("1");
  std::string result = sign_alone ? "-" : "";
  for (std::size_t i = 0; i < factors.size(); ++i) result += (i > 0 ? "*" : "") + factors[i];
  for (const std::string& divisor : divisors) result += "/" + divisor;
  return result;
}

std::string sum_text(const ex& e) {
  std::vector<std::string> terms = terms_of(e);
  std::stable_partition(terms.begin(), terms.end(), std::not_fn(negative));
  std::string result;
  for (const std::string& term : terms) result += (result.empty() || negative(term) ? "" : "+") + term;
  return result;
}

}  // namespace

Formulas::Formulas(const std::vector<std::string>& names) {
  for (const std::string& name : names) symbols_[name] = GiNaC::realsymbol(name);
}

ex Formulas::symbol(const std::string& name) const {
  const auto found = symbols_.find(name);
  if (found == symbols_.end()) throw Error("formula", "the symbol " + name, "a declared symbol");
  return found->second;
}

ex Formulas::parse(const std::string& formula) const {
  GiNaC::parser reader(symbols_, true);
  try {
    return reader(formula);
  } catch (const std::exception&) {  // whose words are those of a library
    throw Error("formula", "'" + formula + "'", "a formula in the declared symbols");
  }
}

bool identical(const ex& a, const ex& b) {
  HalfAngles rational;
  return rational(a - b).normal().expand().is_zero();
}

bool proportional(const ex& a, const ex& b) {
  HalfAngles rational;
  const ex ratio = (rational(a) / rational(b)).normal();
  return GiNaC::is_a<GiNaC::numeric>(ratio) && !ratio.is_zero();
}

ex series_coefficient(const ex& e, const ex& x, int power) {
  const ex series = e.series(x == 0, power + 1);
  return GiNaC::series_to_poly(series).expand().coeff(x, power).normal();
}

int leading_order(const ex& e, const ex& x, int none) {
  for (int order = std::min(2, none);;
       order = std::min(2 * order, none)) {  // long series are dear, short ones mostly do
    const ex terms = GiNaC::series_to_poly(e.series(x == 0, order)).expand();
    if (!terms.is_zero()) return terms.ldegree(x);
    if (order == none) return none;
  }
}

ex limit_at_zero(const ex& e, const ex& x) {
  if (leading_order(e, x, 1) < 0) throw Error("limit", text(e) + " without a bound", "a finite limit");
  return series_coefficient(e, x, 0);
}

std::string text(const ex& e) {
  if (GiNaC::is_a<GiNaC::add>(e)) return sum_text(e);
  if (GiNaC::is_a<GiNaC::mul>(e)) return product_text({e.begin(), e.end()});
  if (GiNaC::is_a<GiNaC::power>(e)) return product_text({e});
  std::ostringstream out;
  if (GiNaC::is_a<GiNaC::function>(e) && e.nops() == 1)
    out << GiNaC::ex_to<GiNaC::function>(e).get_name() << '(' << text(e.op(0)) << ')';
  else
    out << e;
  return out.str();
}

}  // namespace plumbline::proofs
