/// \file
/// Numbers to their digits, and signs on ranges.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <plumbline/base/error.hpp>

#include "verify/generic/generic.hpp"
#include "verify/generic/symbolic_model.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {

Judgement generic::value(const Parameters& with, const Printed& printed, const Premises& given, int digits) {
  with.known({"chain", "of", "symbols", "shape", "at"});
  const SymbolicModel model(given.at(with.text("chain")), with.list("symbols"), with.list("shape"));
  Values values;
  for (const std::string& one : with.list("at")) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos) with.wrong("at = '" + one + "'", "name = number");
    values[one.substr(0, one.find_last_not_of(' ', equals - 1) + 1)] = number(one.substr(equals + 2));
  }
  const Printed of = with.list("of");
  std::vector<Interval> computed;
  std::string shown;
  for (const std::string& formula : of) {
    computed.push_back(value_of(model.value(formula), values));
    shown += (shown.empty() ? "" : "; ") + certified_decimal(computed.back(), digits);
  }
  Judgement result = judge_decimals(
      printed, computed, of,
      fmt::format("{} in intervals, at {}", fmt::join(of, ", "), fmt::join(with.list("at"), ", ")));
  result.value = shown;
  return result;
}

Judgement generic::sign(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "of", "symbols", "shape", "by", "range"});
  const SymbolicModel model(given.at(with.text("chain")), with.list("symbols"), with.list("shape"));
  const Printed range = with.list("range");
  if (range.size() != 3) with.wrong("range", "a name, from and to");
  GiNaC::ex formula = model.value(with.text("of"));
  if (with.has("by"))
    formula = formula.diff(GiNaC::ex_to<GiNaC::symbol>(model.formulas().symbol(with.text("by"))));
  const auto sign = certain_sign(
      [&](const Interval& at) {
        return value_of(formula, {{range[0], at}});
      },
      number(range[1]), number(range[2]));
  const std::string what = with.has("by") ? (!sign       ? "not monotonic"
                                             : *sign > 0 ? "increasing"
                                                         : "decreasing")
                                          : (!sign       ? "both signs"
                                             : *sign > 0 ? "positive"
                                                         : "negative");
  return judge_word(
      printed.at(0), what, fmt::format("{} is {}", with.text("of"), what),
      {{EvidenceKind::interval,
        fmt::format("{}{} for {} from {} to {} by subdivision: {}", with.has("by") ? "derivative of " : "",
                    with.text("of"), range[0], range[1], range[2], what)}});
}

}  // namespace plumbline::verify
