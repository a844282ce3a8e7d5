/// \file
/// Numbers to their digits, and signs on ranges.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <plumbline/base/error.hpp>
#include <set>

#include "verify/generic/generic.hpp"
#include "verify/generic/symbolic_model.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {

Judgement generic::value(const Parameters& with, const Printed& printed, const Premises& given, int digits) {
  with.known({"chain", "of", "symbols", "shape", "at"});
  const SymbolicModel model(given.guided(with.text("chain")), with.list("symbols"), with.list("shape"));
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
  for (std::size_t i = 0; i < of.size() && result.verdict == Verdict::confirmed; ++i)
    result.statement += fmt::format("{}{} is {}", i == 0 ? "" : ", ", of[i], printed[i]);
  return result;
}

namespace {

/// "positive" or "increasing" and the like. \throws Error where the sign is undecided
std::string word_of(const Parameters& with, SignOnRange sign) {
  const bool slope = with.has("by");
  switch (sign) {
    case SignOnRange::positive:
      return slope ? "increasing" : "positive";
    case SignOnRange::negative:
      return slope ? "decreasing" : "negative";
    case SignOnRange::both:
      return slope ? "not monotonic" : "both signs";
    case SignOnRange::undecided:
      break;
  }
  with.wrong("a sign that subdivision does not decide", "a function that keeps off zero on the range");
}

}  // namespace

Judgement generic::sign(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "of", "symbols", "shape", "by", "range"});
  const SymbolicModel model(given.guided(with.text("chain")), with.list("symbols"), with.list("shape"));
  const Printed range = with.list("range");
  if (range.size() != 3) with.wrong("range", "a name, from and to");
  const auto symbol = [&](const std::string& name) {
    return GiNaC::ex_to<GiNaC::symbol>(model.formulas().symbol(name));
  };
  GiNaC::ex formula = model.value(with.text("of"));
  if (with.has("by")) formula = formula.diff(symbol(with.text("by")));
  const GiNaC::ex slope = formula.diff(symbol(range[0]));
  const auto value = [&](const GiNaC::ex& e, const Interval& at) { return value_of(e, {{range[0], at}}); };
  // by the mean value too: near a zero the slope decides where values on a whole piece do not
  const auto enclosed = [&](const Interval& at) {
    const Interval middle(at.middle(), at.middle()), whole = value(formula, at);
    return intersection(whole, value(formula, middle) + value(slope, at) * (at - middle)).value_or(whole);
  };
  const std::string what = word_of(with, sign_on(enclosed, number(range[1]), number(range[2])));
  Judgement result = judge_word(
      printed.at(0), what, fmt::format("{} is {}", with.text("of"), what),
      {{EvidenceKind::interval,
        fmt::format("{}{} for {} from {} to {} by subdivision: {}", with.has("by") ? "derivative of " : "",
                    with.text("of"), range[0], range[1], range[2], what)}});
  result.statement =
      fmt::format("{} is {} for {} from {} to {}", with.text("of"), what, range[0], range[1], range[2]);
  return result;
}

Judgement generic::names(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"of", "in"});
  std::set<std::string> found;
  std::vector<std::string> list;
  for (const std::string& id : with.list("in")) {
    const Premise& premise = given.at(id);
    const auto value = premise.parts.find("value");
    const std::string name = value == premise.parts.end() ? "" : value->second.front();
    if (name.empty() || premise.quote.find(name) == std::string::npos)
      with.wrong("premise " + id + " with the value '" + name + "'", "words of its quote");
    if (found.insert(name).second) list.push_back(fmt::format("{} in {}", name, premise.where));
  }
  const std::string count = std::to_string(found.size()),
                    all = fmt::format("{} is {}", with.text("of"), fmt::join(list, ", and "));
  const bool right = printed.at(0) == count;
  return {right                  ? Verdict::confirmed
          : printed.at(0) == "1" ? Verdict::convention
                                 : Verdict::refuted,
          right ? "" : all,
          {{EvidenceKind::exact, "as quoted: " + all}},
          ""};
}

}  // namespace plumbline::verify
