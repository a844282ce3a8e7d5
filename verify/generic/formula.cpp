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

/// "name = formula".
struct Assignment {
  std::string name, formula;
};

Assignment assignment(const Parameters& with, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) with.wrong("'" + text + "'", "name = formula");
  return {text.substr(0, text.find_last_not_of(' ', equals - 1) + 1), text.substr(equals + 1)};
}

/// What is done with the model's formulas: `by` differentiates, each by its own text or all by one, once by
/// each name in it; `at` inserts values, "alpha = 0"; `solve` and `eliminate` take the formulas for sides of
/// equations "side = 0" and name their unknowns, those of `solve` being what is compared; `limit` names what
/// goes to zero; `lowest` leaves the terms of lowest order in the names that it lists together; `to` those up
/// to an order, "phi 2", and is done with the print too; `meaning` says what names of the print stand for.
struct Steps {
  const Parameters& with;
  const SymbolicModel& model;

  /// What the print is compared with.
  [[nodiscard]] std::vector<ex> of_model() const {
    const Printed of = with.list("of");
    std::vector<ex> values;
    for (std::size_t i = 0; i < of.size(); ++i) values.push_back(inserted(derivative(model.value(of[i]), i)));
    if (with.has("solve")) values = solved(values);
    for (ex& value : values) {
      if (with.has("limit"))
        value = proofs::limit_at_zero(value, model.formulas().symbol(with.text("limit")));
      if (with.has("lowest")) value = lowest(value);
      value = truncated(value);
    }
    return values;
  }

  /// A print as it is compared.
  [[nodiscard]] std::string of_print(const std::string& entry) const {
    static const std::regex pi("\\bpi\\b");
    const std::string exact = std::regex_replace(with_fractions(entry), pi, "Pi");
    if (!with.has("meaning") && !with.has("to")) return exact;
    GiNaC::exmap meaning;
    for (const std::string& one : with.list("meaning")) {
      const auto [name, formula] = assignment(with, one);
      meaning[model.formulas().symbol(name)] = model.value(formula);
    }
    return proofs::text(truncated(model.formulas().parse(exact).subs(meaning)));
  }

  [[nodiscard]] ex derivative(ex value, std::size_t place) const {
    const Printed by = with.list("by");
    if (!by.empty() && by.size() != 1 && by.size() != with.list("of").size())
      with.wrong(fmt::format("{} texts as 'by'", by.size()),
                 "one for all or one for each of `of`; \"q1 q2\" differentiates twice");
    if (!by.empty()) {
      std::istringstream names(by.at(by.size() == 1 ? 0 : place));
      for (std::string name; names >> name;) value = value.diff(variable(model, name));
    }
    return value;
  }

  /// The unknowns of `solve` by as many of the equations as there are unknowns, the last ones, linear in
  /// them. \throws Error where the others do not hold then
  [[nodiscard]] std::vector<ex> solved(const std::vector<ex>& sides) const {
    const Printed wanted = with.list("solve"), others = with.list("eliminate");
    GiNaC::lst unknowns, equations;
    for (const Printed* const names : {&wanted, &others})
      for (const std::string& name : *names) unknowns.append(model.formulas().symbol(name));
    const std::size_t count = wanted.size() + others.size();
    if (count > sides.size()) with.wrong(fmt::format("{} equations", sides.size()), "one for each unknown");
    for (std::size_t i = sides.size() - count; i < sides.size(); ++i) equations.append(sides[i] == 0);
    GiNaC::exmap solution;
    std::vector<ex> values;
    for (const ex& one : GiNaC::lsolve(equations, unknowns)) {
      solution[one.lhs()] = one.rhs();
      if (values.size() < wanted.size()) values.push_back(one.rhs());
    }
    if (solution.size() != count) with.wrong("equations without a solution", "one");
    for (const ex& side : sides)
      if (!proofs::identical(side.subs(solution), 0))
        with.wrong("equations that contradict", "a solution of all");
    return values;
  }

  [[nodiscard]] ex inserted(const ex& value) const {
    GiNaC::exmap values;
    for (const std::string& one : with.list("at")) {
      const auto [name, formula] = assignment(with, one);
      values[model.formulas().symbol(name)] = model.value(formula);
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
    for (const char* const step : {"by", "at", "solve", "limit", "lowest", "to", "shape"})
      if (with.has(step)) text += fmt::format(", {} {}", step, fmt::join(with.list(step), " "));
    return text;
  }
};

}  // namespace

Judgement generic::formula(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "of", "symbols", "shape", "by", "at", "solve", "eliminate", "limit", "lowest", "to",
              "meaning", "up to", "names"});
  const SymbolicModel model(given.guided(with.text("chain")), with.list("symbols"), with.list("shape"));
  const Steps steps{with, model};
  const std::vector<ex> computed = steps.of_model();
  Printed names = with.list("names");
  if (names.empty()) names = with.has("solve") ? with.list("solve") : with.list("of");
  Printed read;
  for (const std::string& entry : printed) read.push_back(steps.of_print(entry));
  return with.text("up to", "nothing") == "factor"
             ? judge_equations(model.formulas(), read, computed, names, steps.said())
             : judge_formulas(model.formulas(), read, computed, names, steps.said());
}

}  // namespace plumbline::verify
