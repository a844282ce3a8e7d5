/// \file
/// Section 4.2, the linearised model: equations (21), (23), (25) to (28) and the sentences around them.

#include <fmt/core.h>

#include <algorithm>

#include "proofs/exact/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

constexpr unsigned printed_links = 4;  // printed general formulas are read for four links

/// Symbols L1…L4, k1…k4, q1…q4, Fx, Fy, lambda.
const proofs::Formulas& general_formulas() {
  static const proofs::Formulas instance([] {
    std::vector<std::string> names{"Fx", "Fy", "lambda"};
    for (unsigned i = 1; i <= printed_links; ++i) {
      for (const char* name : {"L", "k", "q"}) names.push_back(fmt::format("{}{}", name, i));
    }
    return names;
  }());
  return instance;
}

std::vector<ex> symbols(const std::string& name) {
  std::vector<ex> result;
  for (unsigned i = 1; i <= printed_links; ++i)
    result.push_back(general_formulas().symbol(fmt::format("{}{}", name, i)));
  return result;
}

proofs::SymbolicShape general_shape() {
  return {symbols("L"), symbols("k"), symbols("q")};
}

/// All joint angles multiplied by one symbol, to read orders of smallness.
struct Scaled {
  ex epsilon = GiNaC::realsymbol("epsilon");
  proofs::SymbolicShape shape = general_shape();
  Scaled() {
    for (ex& angle : shape.q) angle *= epsilon;
  }
};

/// Shortening and lateral deflection of the straight chain's end point.
std::vector<ex> deflections(const proofs::SymbolicShape& shape) {
  proofs::SymbolicShape straight = shape;
  straight.q.assign(printed_links, 0);
  const GiNaC::matrix from = end_point(straight);
  const GiNaC::matrix to = end_point(shape);
  return {from(0, 0) - to(0, 0), to(1, 0) - from(1, 0)};
}

/// (29) and (30) in symbols, row by row, from the kinematics.
std::vector<ex> linear_rows() {
  const Scaled scaled;
  const GiNaC::matrix balance = proofs::torque_balance(scaled.shape, general_formulas().symbol("Fx"),
                                                       scaled.epsilon * general_formulas().symbol("Fy"));
  std::vector<ex> rows;
  for (unsigned i = 0; i < printed_links; ++i)
    rows.push_back(proofs::series_coefficient(balance(i, 0), scaled.epsilon, 1));
  rows.push_back(proofs::series_coefficient(deflections(scaled.shape)[1], scaled.epsilon, 1));
  return rows;
}

std::vector<ex> linear_unknowns() {
  std::vector<ex> unknowns = symbols("q");
  unknowns.push_back(general_formulas().symbol("Fx"));
  unknowns.push_back(general_formulas().symbol("Fy"));
  return unknowns;
}

Judgement counts(const Printed& printed, int) {
  const std::vector<ex> rows = linear_rows(), candidates = linear_unknowns();
  const auto occurs = [&](const ex& unknown) {
    return std::any_of(rows.begin(), rows.end(), [&](const ex& row) { return row.has(unknown); });
  };
  const auto unknowns = static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(), occurs));
  const std::string found =
      fmt::format("n+{} equations, n+{} unknowns", rows.size() - printed_links, unknowns - printed_links);
  return judge_word(
      printed.at(0), found, found,
      {{EvidenceKind::symbolic,
        fmt::format("n = 4: the first-order parts of (22) and of delta_y are {} rows, in which {} of "
                    "q_1 … q_4, F_x, F_y occur",
                    rows.size(), unknowns)}});
}

/// The highest degree of (29) and (30) in all unknowns together, and at a given F_x.
Judgement degree(const Printed& printed, int) {
  const ex t = GiNaC::realsymbol("t");
  const auto together = [&](const std::vector<ex>& unknowns) {
    GiNaC::lst scaled;
    for (const ex& unknown : unknowns) scaled.append(unknown == t * unknown);
    int most = 0;
    for (const ex& row : linear_rows()) most = std::max(most, row.subs(scaled).expand().degree(t));
    return most;
  };
  std::vector<ex> all = linear_unknowns(), at_force = symbols("q");
  at_force.push_back(general_formulas().symbol("Fy"));
  const int both = together(all), given = together(at_force);
  const std::string found = both == 1 ? "linear" : "bilinear";
  return {
      printed.at(0) == found                    ? Verdict::confirmed
      : printed.at(0) == "linear" && given == 1 ? Verdict::convention
                                                : Verdict::refuted,
      printed.at(0) == found ? ""
                             : "linear in q and F_y at a given F_x; in all n + 2 unknowns bilinear, by q F_x",
      {{EvidenceKind::symbolic,
        fmt::format("n = 4: degree of the rows in q, F_x, F_y together {}, in q and F_y {}", both, given)}},
      ""};
}

Judgement nonlinear_counts(const Printed& printed, int) {
  const proofs::SymbolicShape shape = general_shape();
  const std::size_t balances =
      proofs::torque_balance(shape, general_formulas().symbol("Fx"), general_formulas().symbol("Fy")).rows();
  const std::size_t equations = balances + deflections(shape).size();
  const std::size_t unknowns = shape.q.size() + 2;
  const std::string found =
      fmt::format("n+{} equations, n+{} unknowns", equations - printed_links, unknowns - printed_links);
  const bool right = printed.at(0) == found;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : found,
          {{EvidenceKind::exact, fmt::format("n = 4: {} torque balances and {} deflections for q, F_x, F_y",
                                             balances, equations - balances)}},
          ""};
}

Judgement linear_word(const Printed& printed, int) {
  const Scaled scaled;
  const std::vector<ex> d = deflections(scaled.shape);
  const int order_x = proofs::leading_order(d[0], scaled.epsilon);
  const int order_y = proofs::leading_order(d[1], scaled.epsilon);
  const bool right = printed.at(0) == std::to_string(order_x) && printed.at(1) == std::to_string(order_y);
  const bool lowest_order = printed.at(0) == "1" && printed.at(1) == std::to_string(order_y);
  return {right          ? Verdict::confirmed
          : lowest_order ? Verdict::convention
                         : Verdict::refuted,
          right
              ? ""
              : fmt::format(
                    "delta_x in (25) is of order {}, not linear; its linear part vanishes, which is why the "
                    "straight chain does not yield before it buckles. delta_y is of order {}",
                    order_x, order_y),
          {{EvidenceKind::symbolic,
            fmt::format("lowest orders of (21) in the joint angles: {} and {}", order_x, order_y)}},
          ""};
}

}  // namespace

Checks claims::linearised_model() {
  return {
      {"linearised", linear_word},
      {"unknowns-nonlinear", nonlinear_counts},
      {"unknowns", counts},
      {"extended-linear", degree},
  };
}

}  // namespace plumbline::verify
