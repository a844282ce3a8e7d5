/// \file
/// Formulas against those of a chain's model.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <regex>
#include <sstream>

#include "verify/generic/generic.hpp"
#include "verify/generic/symbolic_model.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// A symbol to differentiate by. It is no real one any more: nothing to substitute.
GiNaC::symbol variable(const SymbolicModel& model, const std::string& name) {
  return GiNaC::ex_to<GiNaC::symbol>(model.formulas().symbol(name));
}

/// What is done with the model's formulas: `by` differentiates, each by its own text or all by one, once by
/// each name in it; `at` inserts values, "alpha = 0"; `limit` names what goes to zero; `lowest` leaves the
/// terms of lowest order in the names that it lists together; `to` those up to an order, "phi 2", and is done
/// with the print too.
struct Steps {
  const Parameters& with;
  const SymbolicModel& model;

  [[nodiscard]] ex of_model(ex value, std::size_t place) const {
    const Printed by = with.list("by");
    if (!by.empty() && by.size() != 1 && by.size() != with.list("of").size())
      with.wrong(fmt::format("{} texts as 'by'", by.size()),
                 "one for all or one for each of `of`; \"q1 q2\" differentiates twice");
    if (!by.empty()) {
      std::istringstream names(by.at(by.size() == 1 ? 0 : place));
      for (std::string name; names >> name;) value = value.diff(variable(model, name));
    }
    value = inserted(value);
    if (with.has("limit")) value = proofs::limit_at_zero(value, model.formulas().symbol(with.text("limit")));
    if (with.has("lowest")) value = lowest(value);
    return truncated(value);
  }

  [[nodiscard]] ex inserted(const ex& value) const {
    GiNaC::exmap values;
    for (const std::string& one : with.list("at")) {
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos) with.wrong("at = '" + one + "'", "name = formula");
      const std::string name = one.substr(0, one.find_last_not_of(' ', equals - 1) + 1);
      values[model.formulas().symbol(name)] = model.value(one.substr(equals + 1));
    }
    return value.subs(values);
  }

  [[nodiscard]] ex lowest(const ex& value) const {
    const ex small = GiNaC::realsymbol("small");
    GiNaC::exmap scaled;
    for (const std::string& name : with.list("lowest"))
      scaled[model.formulas().symbol(name)] = small * model.formulas().symbol(name);
    const ex all = value.subs(scaled);
    return proofs::series_coefficient(all, small, proofs::leading_order(all, small));
  }

  [[nodiscard]] ex truncated(const ex& value) const {
    const Printed to = with.list("to");
    if (to.empty()) return value;
    if (to.size() != 2) with.wrong("to", "a name and an order");
    const ex small = model.formulas().symbol(to[0]);
    ex sum = 0;
    for (int power = std::min(0, proofs::leading_order(value, small, 1)); power <= std::stoi(to[1]); ++power)
      sum += proofs::series_coefficient(value, small, power) * pow(small, power);
    return sum;
  }

  [[nodiscard]] std::string said() const {
    std::string text = fmt::format("{} of the model", fmt::join(with.list("of"), ", "));
    for (const char* const step : {"by", "at", "limit", "lowest", "to", "shape"})
      if (with.has(step)) text += fmt::format(", {} {}", step, fmt::join(with.list(step), " "));
    return text;
  }
};

}  // namespace

Judgement generic::formula(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "of", "symbols", "shape", "by", "at", "limit", "lowest", "to", "up to", "names"});
  const SymbolicModel model(given.at(with.text("chain")), with.list("symbols"), with.list("shape"));
  const Steps steps{with, model};
  const Printed of = with.list("of");
  std::vector<ex> computed;
  for (std::size_t i = 0; i < of.size(); ++i) computed.push_back(steps.of_model(model.value(of[i]), i));
  Printed names = with.list("names");
  if (names.empty()) names = of;
  Printed read;
  static const std::regex pi("\\bpi\\b");
  for (const std::string& entry : printed)
    read.push_back(std::regex_replace(with_fractions(entry), pi, "Pi"));
  if (with.has("to"))
    for (std::string& entry : read) entry = proofs::text(steps.truncated(model.formulas().parse(entry)));
  return with.text("up to", "nothing") == "factor"
             ? judge_equations(model.formulas(), read, computed, names, steps.said())
             : judge_formulas(model.formulas(), read, computed, names, steps.said());
}

}  // namespace plumbline::verify
