/// \file
/// Section 4.2, the equations in matrices: (22), (29) to (33), on one chain in rationals.

#include <fmt/core.h>

#include <sstream>

#include "proofs/exact/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/sign_of_force.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/matrix_formula.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

constexpr unsigned printed_n = 4;  // printed general formulas are read for four links

/// To read numbers.
const proofs::Formulas& numbers() {
  static const proofs::Formulas instance({});
  return instance;
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

/// Whether a = c b for a number c other than zero: both are sides of one equation.
bool multiple(const Matrix<Rational>& a, const Matrix<Rational>& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    if (b(i) == 0 || a(i) == 0) continue;
    return a * b(i) == b * a(i);
  }
  return false;
}

/// One chain, shape and force in numbers: L = (2, 3, 5, 7), k = (1, 4, 6, 9), q = (3, -1, 4, 1), F = (7/2,
/// -5).
struct Example {
  std::vector<Rational> length{2, 3, 5, 7}, stiffness{1, 4, 6, 9}, q{3, -1, 4, 1};
  Rational Fx{7, 2}, Fy{-5};
};

/// (22) at links of the directions (c, s) = (3/5, 4/5) and so on: the gradient of E + F_x x + F_y y by
/// the joint angles, F positive in compression as in (6).
Judgement equilibrium_at_links(const Printed& printed, int) {
  const Example example;
  const std::vector<Rational> c{Rational(3, 5), Rational(12, 13), Rational(-8, 17), Rational(4, 5)},
      s{Rational(4, 5), Rational(-5, 13), Rational(15, 17), Rational(3, 5)};
  const proofs::Formulas turns({"t1", "t2", "t3", "t4"});
  ex x = 0, y = 0;
  GiNaC::lst directions;
  for (unsigned j = 0; j < printed_n; ++j) {
    const ex t = turns.symbol(fmt::format("t{}", j + 1)), L = turns.parse(example.length[j].str());
    x += L * cos(t);
    y += L * sin(t);
    directions.append(cos(t) == turns.parse(c[j].str()));
    directions.append(sin(t) == turns.parse(s[j].str()));
  }
  Matrix<Rational> J(2, printed_n), K = Matrix<Rational>::Zero(printed_n, printed_n);
  std::vector<Rational> torque, gradient;
  for (unsigned i = 0; i < printed_n; ++i) {
    J(0, i) = J(1, i) = 0;
    ex dx = 0, dy = 0;  // joint i + 1 turns all links from there on
    for (unsigned j = i; j < printed_n; ++j) {
      J(0, i) -= example.length[j] * s[j];
      J(1, i) += example.length[j] * c[j];
      const auto turn = GiNaC::ex_to<GiNaC::symbol>(turns.symbol(fmt::format("t{}", j + 1)));
      dx += x.diff(turn);
      dy += y.diff(turn);
    }
    torque.push_back(example.stiffness[i] * example.q[i]);
    gradient.push_back(torque.back() + example.Fx * number(dx.subs(directions)) +
                       example.Fy * number(dy.subs(directions)));
  }
  const auto residual =
      evaluated(printed.at(0), {{"J", J}, {"M", column(torque)}, {"F", column({example.Fx, example.Fy})}});
  const bool right = residual && multiple(*residual, column(gradient));
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
  for (const Rational& L : example.length) shape.length.push_back(numbers().parse(L.str()));
  for (const Rational& k : example.stiffness) shape.stiffness.push_back(numbers().parse(k.str()));
  Matrix<Rational> S1(printed_n, printed_n), K = Matrix<Rational>::Zero(printed_n, printed_n);
  std::vector<Rational> S0;
  for (unsigned j = 0; j < printed_n; ++j) {
    shape.q.assign(printed_n, 0);
    shape.q[j] = epsilon;  // joint j alone turns
    const GiNaC::matrix J = jacobian(shape);
    for (unsigned i = 0; i < printed_n; ++i)
      S1(i, j) = number(proofs::series_coefficient(J(0, i), epsilon, 1));
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
  for (unsigned i = 0; i < printed_n; ++i) {
    shape.length.push_back(numbers().parse(example.length[i].str()));
    shape.stiffness.push_back(numbers().parse(example.stiffness[i].str()));
    shape.q.push_back(epsilon * numbers().parse(example.q[i].str()));
  }
  const GiNaC::matrix balance = proofs::torque_balance(shape, numbers().parse(example.Fx.str()),
                                                       epsilon * numbers().parse(example.Fy.str()));
  std::vector<Rational> sides;
  for (unsigned i = 0; i < printed_n; ++i)
    sides.push_back(number(proofs::series_coefficient(balance(i, 0), epsilon, 1)));
  sides.push_back(number(proofs::series_coefficient(end_point(shape)(1, 0), epsilon, 1)));
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
  const Matrix<Rational> expected = linear_sides().topRows(printed_n),
                         turned = expected - Rational(2) * model.at("K") * model.at("q");
  Matrix<Rational> total = Matrix<Rational>::Zero(printed_n, 1);
  bool right = true;
  for (const std::string& term : printed) {
    const auto value = evaluated(term, model);
    right = right && value && value->rows() == printed_n && value->cols() == 1;
    if (right) total += *value;
  }
  const int sign = multiple(total, turned) ? -1 : 1;  // of K where S1 F_x stands with +
  right = right && multiple(total, sign < 0 ? turned : expected);
  Signs signs = printed_signs();
  signs["(29)"] = sign;
  Judgement result = judge_place("(29)", signs);
  if (!right) result.verdict = Verdict::refuted;
  result.truth = result.verdict == Verdict::confirmed ? "" : "K q + S1 q F_x + S0 F_y = 0";
  return with_evidence(result, {EvidenceKind::exact, how_linear + "(22)"});
}

/// (30): the first-order part of delta_y.
Judgement constraint(const Printed& printed, int) {
  NamedMatrices model = linear_model();
  const Matrix<Rational> S0 = model.at("S0");
  Matrix<Rational> found(printed_n, 1);  // what the printed side makes of each joint alone
  bool one = true;
  for (Eigen::Index joint = 0; joint < printed_n; ++joint) {
    model["q"] = Matrix<Rational>::Zero(printed_n, 1);
    model["q"](joint, 0) = 1;
    const auto value = evaluated(printed.at(0), model);
    one = one && value && value->size() == 1;
    found(joint, 0) = one ? (*value)(0, 0) : Rational(0);
  }
  const bool right = one && multiple(found, S0);
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
    Matrix<Rational> whole(printed_n + 1, printed_n + 1);
    for (std::size_t b = 0; b < 4; ++b) {
      const Eigen::Index row = b < 2 ? 0 : printed_n, col = b % 2 == 0 ? 0 : printed_n;
      const auto part = block(printed[first + b], row == 0 ? printed_n : 1, col == 0 ? printed_n : 1, model);
      if (!part) return std::nullopt;
      whole.block(row, col, part->rows(), part->cols()) = *part;
    }
    return whole;
  };
  const auto A = square(1), B = square(5);
  const auto q = block(printed[9], printed_n, 1, model), Fy = block(printed[10], 1, 1, model);
  if (!A || !B || !q || !Fy) return wrong;
  Matrix<Rational> v(printed_n + 1, 1);
  v << *q, *Fy;
  const auto pencil = evaluated(printed[0], {{"A", *A}, {"B", *B}, {"Fx", model.at("Fx")}});
  if (!pencil || pencil->cols() != v.rows() || !multiple(*pencil * v, linear_sides())) return wrong;
  Judgement right = wrong;
  right.verdict = Verdict::confirmed;
  right.truth = "";
  return right;
}

}  // namespace

Checks claims::linear_equations() {
  return {
      {"eq-22", equilibrium_at_links},
      {"eq-29", linear_equilibrium},
      {"eq-30", constraint},
      {"eq-31-33", blocks},
  };
}

}  // namespace plumbline::verify
