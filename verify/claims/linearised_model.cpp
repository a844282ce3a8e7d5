/// \file
/// Section 4.2, the linearised model: equations (21) to (33) and the sentences around them.

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "proofs/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/sign_of_force.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/matrix_formula.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

constexpr unsigned n = 4;  // printed general formulas are read for four links

/// Symbols L1…L4, k1…k4, q1…q4, Fx, Fy, lambda.
const proofs::Formulas& formulas() {
  static const proofs::Formulas instance([] {
    std::vector<std::string> names{"Fx", "Fy", "lambda"};
    for (unsigned i = 1; i <= n; ++i) {
      for (const char* name : {"L", "k", "q"}) names.push_back(fmt::format("{}{}", name, i));
    }
    return names;
  }());
  return instance;
}

std::vector<ex> symbols(const std::string& name) {
  std::vector<ex> result;
  for (unsigned i = 1; i <= n; ++i) result.push_back(formulas().symbol(fmt::format("{}{}", name, i)));
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
  [[nodiscard]] ex leading(const ex& e) const {
    return proofs::series_coefficient(e, epsilon, proofs::leading_order(e, epsilon));
  }
};

ex derivative(const ex& e, const ex& symbol) {
  return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
}

std::vector<std::string> grid_names(const std::string& matrix, unsigned rows, unsigned columns) {
  std::vector<std::string> names;
  for (unsigned i = 1; i <= rows; ++i) {
    for (unsigned j = 1; j <= columns; ++j) names.push_back(fmt::format("{}({},{})", matrix, i, j));
  }
  return names;
}

/// Shortening and lateral deflection of the straight chain's end point.
std::vector<ex> deflections(const proofs::SymbolicShape& shape) {
  proofs::SymbolicShape straight = shape;
  straight.q.assign(n, 0);
  const GiNaC::matrix from = end_point(straight);
  const GiNaC::matrix to = end_point(shape);
  return {from(0, 0) - to(0, 0), to(1, 0) - from(1, 0)};
}

Judgement geometry(const Printed& printed, int) {
  return judge_formulas(formulas(), printed, deflections(general_shape()), {"delta_x", "delta_y"},
                        "end point of the straight chain against that of the bent one, n = 4");
}

Judgement full_jacobian(const Printed& printed, int) {
  const proofs::SymbolicShape shape = general_shape();
  std::vector<ex> computed;
  for (unsigned row = 0; row < 2; ++row) {
    for (const ex& q : shape.q) computed.push_back(derivative(end_point(shape)(row, 0), q));
  }
  return judge_formulas(formulas(), printed, computed, grid_names("J", 2, n),
                        "derivatives of the end point by the joint angles, n = 4");
}

Rational number(const ex& e) {
  Rational value;
  std::istringstream(proofs::text(e.normal())) >> value;
  return value;
}

Matrix<Rational> column(const std::vector<Rational>& entries) {
  Matrix<Rational> result(static_cast<Eigen::Index>(entries.size()), 1);
  for (std::size_t i = 0; i < entries.size(); ++i) result(static_cast<Eigen::Index>(i), 0) = entries[i];
  return result;
}

Matrix<Rational> scalar(const Rational& x) {
  return Matrix<Rational>::Constant(1, 1, x);
}

/// One chain, shape and force in numbers: L = (2, 3, 5, 7), k = (1, 4, 6, 9), q = (3, -1, 4, 1), F = (7/2,
/// -5).
struct Example {
  std::vector<Rational> length{2, 3, 5, 7}, stiffness{1, 4, 6, 9}, q{3, -1, 4, 1};
  Rational Fx{7, 2}, Fy{-5};
};

/// (22) at links of the directions (c, s) = (3/5, 4/5) and so on: the gradient of E + F_x x + F_y y by the
/// joint angles, F positive in compression as in (6).
Judgement equilibrium(const Printed& printed, int) {
  const Example example;
  const std::vector<Rational> c{Rational(3, 5), Rational(12, 13), Rational(-8, 17), Rational(4, 5)},
      s{Rational(4, 5), Rational(-5, 13), Rational(15, 17), Rational(3, 5)};
  const proofs::Formulas turns({"t1", "t2", "t3", "t4"});
  ex x = 0, y = 0;
  GiNaC::lst directions;
  for (unsigned j = 0; j < n; ++j) {
    const ex t = turns.symbol(fmt::format("t{}", j + 1)), L = turns.parse(example.length[j].str());
    x += L * cos(t);
    y += L * sin(t);
    directions.append(cos(t) == turns.parse(c[j].str()));
    directions.append(sin(t) == turns.parse(s[j].str()));
  }
  Matrix<Rational> J(2, n), K = Matrix<Rational>::Zero(n, n);
  std::vector<Rational> torque, gradient;
  for (unsigned i = 0; i < n; ++i) {
    J(0, i) = J(1, i) = 0;
    ex dx = 0, dy = 0;  // joint i + 1 turns all links from there on
    for (unsigned j = i; j < n; ++j) {
      J(0, i) -= example.length[j] * s[j];
      J(1, i) += example.length[j] * c[j];
      dx += derivative(x, turns.symbol(fmt::format("t{}", j + 1)));
      dy += derivative(y, turns.symbol(fmt::format("t{}", j + 1)));
    }
    torque.push_back(example.stiffness[i] * example.q[i]);
    gradient.push_back(torque.back() + example.Fx * number(dx.subs(directions)) +
                       example.Fy * number(dy.subs(directions)));
  }
  const auto residual =
      evaluated(printed.at(0), {{"J", J}, {"M", column(torque)}, {"F", column({example.Fx, example.Fy})}});
  const bool right = residual && *residual == column(gradient);
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "M + J^T F = 0",
          {{EvidenceKind::exact,
            "four links in rationals: the printed left side equals the gradient of E + F_x x + F_y y by the "
            "joint "
            "angles, with M = K q and F positive in compression as in (6)"}},
          ""};
}

/// K, S1, S0, q, F_x, F_y of the example, S1 and S0 as the first-order parts of its kinematics.
NamedMatrices linear_model() {
  const Example example;
  proofs::SymbolicShape shape;
  const ex epsilon = GiNaC::realsymbol("epsilon");
  for (const Rational& L : example.length) shape.length.push_back(formulas().parse(L.str()));
  for (const Rational& k : example.stiffness) shape.stiffness.push_back(formulas().parse(k.str()));
  Matrix<Rational> S1(n, n), K = Matrix<Rational>::Zero(n, n);
  std::vector<Rational> S0;
  for (unsigned j = 0; j < n; ++j) {
    shape.q.assign(n, 0);
    shape.q[j] = epsilon;  // joint j alone turns
    const GiNaC::matrix J = jacobian(shape);
    for (unsigned i = 0; i < n; ++i) S1(i, j) = number(proofs::series_coefficient(J(0, i), epsilon, 1));
    S0.push_back(number(proofs::series_coefficient(J(1, j), epsilon, 0)));
    K(j, j) = example.stiffness[j];
  }
  return {{"K", K},
          {"S1", S1},
          {"S0", column(S0)},
          {"q", column(example.q)},
          {"Fx", scalar(example.Fx)},
          {"Fy", scalar(example.Fy)}};
}

/// First-order parts of the balance (22) and of delta_y, with q and F_y of first order, from the kinematics.
Matrix<Rational> linear_sides() {
  const Example example;
  proofs::SymbolicShape shape;
  const ex epsilon = GiNaC::realsymbol("epsilon");
  for (unsigned i = 0; i < n; ++i) {
    shape.length.push_back(formulas().parse(example.length[i].str()));
    shape.stiffness.push_back(formulas().parse(example.stiffness[i].str()));
    shape.q.push_back(epsilon * formulas().parse(example.q[i].str()));
  }
  const GiNaC::matrix balance = proofs::torque_balance(shape, formulas().parse(example.Fx.str()),
                                                       epsilon * formulas().parse(example.Fy.str()));
  std::vector<Rational> sides;
  for (unsigned i = 0; i < n; ++i)
    sides.push_back(number(proofs::series_coefficient(balance(i, 0), epsilon, 1)));
  sides.push_back(number(proofs::series_coefficient(deflections(shape)[1], epsilon, 1)));
  return column(sides);
}

const std::string how_linear =
    "L = (2, 3, 5, 7), k = (1, 4, 6, 9), q = (3, -1, 4, 1), F = (7/2, -5) in rationals, against the "
    "first-order part "
    "of ";

/// (29), term by term; its sign of K as the smallest set of corrections leaves it.
Judgement linear_equilibrium(const Printed& printed, int) {
  if (printed.size() != 3) throw Error("claim", fmt::format("{} terms", printed.size()), "3");
  const NamedMatrices model = linear_model();
  const int sign = printed[0].starts_with('-') ? -1 : 1;
  Matrix<Rational> expected = linear_sides().topRows(n);
  if (sign < 0) expected -= Rational(2) * model.at("K") * model.at("q");
  Matrix<Rational> total = Matrix<Rational>::Zero(n, 1);
  bool right = true;
  for (const std::string& term : printed) {
    const auto value = evaluated(term, model);
    right = right && value && value->rows() == n && value->cols() == 1;
    if (right) total += *value;
  }
  right = right && total == expected;
  Signs signs = printed_signs();
  signs["(29)"] = sign;
  Judgement result = judge_place("(29)", signs);
  if (!right) result.verdict = Verdict::refuted;
  result.truth = result.verdict == Verdict::confirmed ? "" : "K q + S1 q F_x + S0 F_y = 0";
  return with_evidence(result, {EvidenceKind::exact, how_linear + "(22)"});
}

/// (30): the first-order part of delta_y.
Judgement constraint(const Printed& printed, int) {
  const auto value = evaluated(printed.at(0), linear_model());
  const bool right = value && *value == scalar(linear_sides()(n, 0));
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "S0^T q = 0",
          {{EvidenceKind::exact, how_linear + "delta_y in (21)"}},
          ""};
}

/// A block of the size that its place demands; "0" fits everywhere.
std::optional<Matrix<Rational>> block(const std::string& text, Eigen::Index rows, Eigen::Index columns,
                                      const NamedMatrices& model) {
  if (text == "0") return Matrix<Rational>(Matrix<Rational>::Zero(rows, columns));
  const auto value = evaluated(text, model);
  return value && value->rows() == rows && value->cols() == columns ? value : std::nullopt;
}

/// printed: (32), the blocks of A, of B and of v in (33), by rows
Judgement blocks(const Printed& printed, int) {
  if (printed.size() != 11) throw Error("claim", fmt::format("{} blocks", printed.size()), "11");
  NamedMatrices model = linear_model();
  const Judgement wrong{Verdict::refuted,
                        "(A F_x + B) v with A = [S1 0; 0 0], B = [K S0; S0^T 0], v = [q; F_y]",
                        {{EvidenceKind::exact, how_linear + "(22) and delta_y in (21)"}},
                        ""};
  const auto square = [&](std::size_t first) -> std::optional<Matrix<Rational>> {
    Matrix<Rational> whole(n + 1, n + 1);
    for (std::size_t b = 0; b < 4; ++b) {
      const Eigen::Index row = b < 2 ? 0 : n, col = b % 2 == 0 ? 0 : n;
      const auto part = block(printed[first + b], row == 0 ? n : 1, col == 0 ? n : 1, model);
      if (!part) return std::nullopt;
      whole.block(row, col, part->rows(), part->cols()) = *part;
    }
    return whole;
  };
  const auto A = square(1), B = square(5);
  const auto q = block(printed[9], n, 1, model), Fy = block(printed[10], 1, 1, model);
  if (!A || !B || !q || !Fy) return wrong;
  Matrix<Rational> v(n + 1, 1);
  v << *q, *Fy;
  const auto pencil = evaluated(printed[0], {{"A", *A}, {"B", *B}, {"Fx", model.at("Fx")}});
  if (!pencil || pencil->cols() != v.rows() || Matrix<Rational>(*pencil * v) != linear_sides()) return wrong;
  Judgement right = wrong;
  right.verdict = Verdict::confirmed;
  right.truth = "";
  return right;
}

/// (29) and (30) in symbols, row by row, from the kinematics.
std::vector<ex> linear_rows() {
  const Scaled scaled;
  const GiNaC::matrix balance =
      proofs::torque_balance(scaled.shape, formulas().symbol("Fx"), scaled.epsilon * formulas().symbol("Fy"));
  std::vector<ex> rows;
  for (unsigned i = 0; i < n; ++i)
    rows.push_back(proofs::series_coefficient(balance(i, 0), scaled.epsilon, 1));
  rows.push_back(proofs::series_coefficient(deflections(scaled.shape)[1], scaled.epsilon, 1));
  return rows;
}

std::vector<ex> linear_unknowns() {
  std::vector<ex> unknowns = symbols("q");
  unknowns.push_back(formulas().symbol("Fx"));
  unknowns.push_back(formulas().symbol("Fy"));
  return unknowns;
}

Judgement counts(const Printed& printed, int) {
  const std::vector<ex> rows = linear_rows(), candidates = linear_unknowns();
  const auto occurs = [&](const ex& unknown) {
    return std::any_of(rows.begin(), rows.end(), [&](const ex& row) { return row.has(unknown); });
  };
  const auto unknowns = static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(), occurs));
  const std::string found = fmt::format("n+{} equations, n+{} unknowns", rows.size() - n, unknowns - n);
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
  at_force.push_back(formulas().symbol("Fy"));
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
      proofs::torque_balance(shape, formulas().symbol("Fx"), formulas().symbol("Fy")).rows();
  const std::size_t equations = balances + deflections(shape).size();
  const std::size_t unknowns = shape.q.size() + 2;
  const std::string found = fmt::format("n+{} equations, n+{} unknowns", equations - n, unknowns - n);
  const bool right = printed.at(0) == found;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : found,
          {{EvidenceKind::exact, fmt::format("n = 4: {} torque balances and {} deflections for q, F_x, F_y",
                                             balances, equations - balances)}},
          ""};
}

Judgement small_geometry(const Printed& printed, int) {
  const Scaled scaled;
  std::vector<ex> computed;
  for (const ex& deflection : deflections(scaled.shape)) computed.push_back(scaled.leading(deflection));
  return judge_formulas(
      formulas(), printed, computed, {"delta_x", "delta_y"},
      "lowest-order terms of (21) in the joint angles, n = 4; 0 <= delta_x(25) - delta_x(21) <= sum L "
      "theta^4/24 since 1 - cos x lies between x^2/2 - x^4/24 and x^2/2");
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

Judgement small_jacobian_entries(const Printed& printed, int) {
  const Scaled scaled;
  std::vector<ex> computed;
  const GiNaC::matrix J = jacobian(scaled.shape);
  for (std::size_t i = 0; i < J.nops(); ++i) computed.push_back(scaled.leading(J.op(i)));
  return judge_formulas(formulas(), printed, computed, grid_names("J", 2, n),
                        "lowest-order terms of (23), n = 4");
}

/// S1 from the kinematics, not from (28): the first row of J^T is S1 q to first order.
ex s1_entry(unsigned i, unsigned j) {
  const Scaled scaled;
  const ex first = proofs::series_coefficient(jacobian(scaled.shape)(0, i), scaled.epsilon, 1);
  return derivative(first, symbols("q")[j]);
}

Judgement s1_matrix(const Printed& printed, int) {
  std::vector<ex> computed;
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) computed.push_back(s1_entry(i, j));
  }
  return judge_formulas(formulas(), printed, computed, grid_names("S1", n, n),
                        "first-order part of the first row of (23), n = 4");
}

Judgement s0_vector(const Printed& printed, int) {
  const GiNaC::matrix at_zero = [] {
    proofs::SymbolicShape straight = general_shape();
    straight.q.assign(n, 0);
    return jacobian(straight);
  }();
  std::vector<ex> computed;
  for (unsigned i = 0; i < n; ++i) computed.push_back(at_zero(1, i));
  return judge_formulas(formulas(), printed, computed, grid_names("S0", n, 1),
                        "second row of (23) at q = 0, n = 4");
}

}  // namespace

Checks claims::linearised_model() {
  return {
      {"eq-21", geometry},
      {"eq-22", equilibrium},
      {"eq-23", full_jacobian},
      {"linearised", linear_word},
      {"eq-25", small_geometry},
      {"eq-26", small_jacobian_entries},
      {"eq-28-S1", s1_matrix},
      {"eq-28-S0", s0_vector},
      {"eq-29", linear_equilibrium},
      {"eq-30", constraint},
      {"unknowns-nonlinear", nonlinear_counts},
      {"unknowns", counts},
      {"extended-linear", degree},
      {"eq-31-33", blocks},
  };
}

}  // namespace plumbline::verify
