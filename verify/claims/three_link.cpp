/// \file
/// Section 4.1: the straight three-link chain with a passive base joint, equations (13) to (20).

#include <fmt/core.h>

#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/straight/critical_force.hpp>
#include <sstream>

#include "proofs/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/straight_chains.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

const proofs::Formulas& formulas() {
  static const proofs::Formulas instance({"phi", "k", "L", "Fx", "Fy"});
  return instance;
}

ex phi() {
  return formulas().symbol("phi");
}
ex k() {
  return formulas().symbol("k");
}
ex L() {
  return formulas().symbol("L");
}

proofs::SymbolicShape shape(const std::vector<ex>& q) {
  return {{L(), L(), L()}, {0, k(), k()}, q};
}
proofs::SymbolicShape u_shape() {
  return shape({phi(), -phi(), -phi()});
}
proofs::SymbolicShape z_shape() {
  return shape({phi(), -3 * phi(), 3 * phi()});
}

Judgement closes(const Printed& printed, int) {
  std::vector<ex> q;
  for (const std::string& angle : printed) q.push_back(formulas().parse(angle));
  const ex y = end_point(shape(q))(1, 0);
  const std::string how = "end point of the printed angles: y = " + proofs::text(y);
  if (proofs::identical(y, 0)) return {Verdict::confirmed, "", {{EvidenceKind::symbolic, how}}, ""};
  const int order = proofs::leading_order(y, phi());
  const ex leading = proofs::series_coefficient(y, phi(), order);
  return {
      order > 1 ? Verdict::imprecise : Verdict::refuted,
      fmt::format(
          "the constraint y = 0 is violated: y = {} phi^{} + …; the shapes that meet it are (phi, -psi, psi) "
          "with psi = phi + asin(2 sin phi) = 3 phi + phi^3 + …",
          proofs::text(leading), order),
      {{EvidenceKind::symbolic, how}},
      ""};
}

std::vector<ex> entries(const GiNaC::matrix& m) {
  std::vector<ex> result;
  for (std::size_t i = 0; i < m.nops(); ++i) result.push_back(m.op(i));
  return result;
}

Judgement jacobian_of(const proofs::SymbolicShape& s, const Printed& printed) {
  std::vector<std::string> names;
  for (int row = 1; row <= 2; ++row) {
    for (int column = 1; column <= 3; ++column)
      names.push_back(fmt::format("entry ({},{}) / L", row, column));
  }
  std::vector<ex> computed = entries(jacobian(s));
  for (ex& entry : computed) entry = (entry / L()).expand();
  return judge_formulas(formulas(), printed, computed, names, "derivative of the end point, shape inserted");
}

Judgement balance_of(const proofs::SymbolicShape& s, const Printed& printed) {
  std::vector<ex> computed =
      entries(proofs::torque_balance(s, formulas().symbol("Fx"), formulas().symbol("Fy")));
  return judge_formulas(formulas(), printed, computed, {"equation 1", "equation 2", "equation 3"},
                        "J^T F + M with M = (0, k q_1, k q_2), shape inserted");
}

Judgement jacobian_u(const Printed& printed, int) {
  return jacobian_of(u_shape(), printed);
}
Judgement jacobian_z(const Printed& printed, int) {
  return jacobian_of(z_shape(), printed);
}
Judgement balance_u(const Printed& printed, int) {
  return balance_of(u_shape(), printed);
}
Judgement balance_z(const Printed& printed, int) {
  return balance_of(z_shape(), printed);
}

/// The forces that solve a balance, from its second and third equation; they solve the first too where the
/// chain can be in equilibrium.
struct Forces {
  ex Fx, Fy;
};

Forces solve(const proofs::SymbolicShape& s) {
  const GiNaC::matrix J = jacobian(s);
  const ex m2 = s.stiffness[1] * s.q[1];
  const ex m3 = s.stiffness[2] * s.q[2];
  const ex det = J(0, 1) * J(1, 2) - J(0, 2) * J(1, 1);
  return {(-m2 * J(1, 2) + m3 * J(1, 1)) / det, (-m3 * J(0, 1) + m2 * J(0, 2)) / det};
}

bool balanced(const proofs::SymbolicShape& s, const Forces& f) {
  for (const ex& residual : entries(proofs::torque_balance(s, f.Fx, f.Fy))) {
    if (!proofs::identical(residual, 0)) return false;
  }
  return true;
}

Judgement solution_u(const Printed& printed, int) {
  const Forces f = solve(u_shape());
  if (!balanced(u_shape(), f)) throw Error("U-shape", "no equilibrium", "one for every phi");
  return judge_formulas(formulas(), printed, {f.Fx, f.Fy}, {"F_x", "F_y"},
                        "solution of all three equilibrium equations for every phi");
}

/// Printed limits against the critical force of the m-th mode of the chain.
Judgement limit_of(const proofs::SymbolicShape& s, const Printed& printed, std::size_t m) {
  const ex limit = proofs::limit_at_zero(solve(s).Fx, phi());
  Judgement result = judge_formulas(formulas(), printed, {limit}, {"the limit"},
                                    "series of the exact solution: " + proofs::text(limit));
  Rational F;
  std::istringstream(proofs::text((limit * L() / k()).normal())) >> F;
  const Rational nudge(1, 1000000);
  const std::size_t below = count_below(three_link_chain(), Rational(F - nudge));
  const std::size_t above = count_below(three_link_chain(), Rational(F + nudge));
  if (below != m - 1 || above != m)
    throw Error("critical force", "different results of limit and recursion", "agreement");
  result.evidence.push_back(
      {EvidenceKind::exact, fmt::format("recursion on L = (1,1,1), k = (0,1,1): {} critical forces "
                                        "below it less 1e-6, {} below it plus 1e-6",
                                        below, above)});
  result.value = proofs::text(limit);
  return result;
}

Judgement limit_u(const Printed& printed, int) {
  return limit_of(u_shape(), printed, 1);
}
Judgement limit_z(const Printed& printed, int) {
  return limit_of(z_shape(), printed, 2);
}

Judgement no_exact_solution(const Printed& printed, int) {
  const Forces f = solve(z_shape());
  const bool solvable = balanced(z_shape(), f);
  const GiNaC::matrix p = end_point(z_shape());
  const bool along_line = proofs::identical(f.Fx * p(1, 0) - f.Fy * p(0, 0), 0);
  const ex scale = 3 * k() * phi() / (L() * sin(3 * phi()));
  const Forces closed{scale * (cos(2 * phi()) + 2 * cos(phi())), scale * (2 * sin(phi()) - sin(2 * phi()))};
  if (!balanced(z_shape(), closed))
    throw Error("Z-shape", "a closed form that does not solve (18)", "one that does");
  return judge_word(
      printed.at(0), solvable ? "solutions" : "no solutions", {"solutions", "no solutions"},
      "with the right entry (1,1) of (17) the three equations do have an exact solution at (phi, -3 phi, 3 "
      "phi), for "
      "every phi with sin 3 phi != 0: F = 3 k phi / (L sin 3 phi) (cos 2 phi + 2 cos phi, 2 sin phi - sin 2 "
      "phi), along "
      "the line from the base to the end point, which lies off the axis",
      {{EvidenceKind::symbolic, fmt::format("F_x and F_y from equations 2 and 3 put into the corrected "
                                            "equation 1: the residual {} identically; F "
                                            "parallel to the end point: {}",
                                            solvable ? "vanishes" : "does not vanish", along_line)}});
}

Judgement asymptotic_z(const Printed& printed, int) {
  const Forces exact = solve(z_shape());
  const ex printed_Fx = formulas().parse(fraction_reading(printed.at(0)));
  const ex printed_Fy = formulas().parse(printed.at(1));
  const bool same_limit =
      proofs::identical(proofs::limit_at_zero(printed_Fx, phi()), proofs::limit_at_zero(exact.Fx, phi())) &&
      proofs::identical(proofs::limit_at_zero(printed_Fy, phi()), proofs::limit_at_zero(exact.Fy, phi()));
  const bool same = proofs::identical(printed_Fx, exact.Fx) && proofs::identical(printed_Fy, exact.Fy);
  // on the shapes (phi, -psi, psi) that keep y = 0: F_x = k psi / (L sin phi), F_y = 0, psi = phi + asin(2
  // sin phi)
  const ex psi = phi() + GiNaC::asin(2 * sin(phi()));
  const ex on_axis = k() * psi / (L() * sin(phi()));
  const auto second = [](const ex& e) {
    return proofs::text(proofs::series_coefficient(e * L() / k(), phi(), 2));
  };
  return {
      same         ? Verdict::confirmed
      : same_limit ? Verdict::imprecise
                   : Verdict::refuted,
      same
          ? ""
          : fmt::format(
                "only the limit is right: exactly F_x = 3k phi (cos 2phi + 2 cos phi)/(L sin 3phi), F_y = 3k "
                "phi (2 sin phi - sin 2phi)/(L sin 3phi) != 0; and on the shapes (phi, -psi, psi) that keep "
                "y = 0, F_x = k psi/(L sin phi) = (k/L)(3 + {} phi^2 + …), F_y = 0",
                second(on_axis)),
      {{EvidenceKind::symbolic,
        fmt::format("coefficients of phi^2 of F_x L/k: printed {}, exact at (phi, -3phi, 3phi) {}, exact at "
                    "y = 0 {}; "
                    "limit of F_x: {} against {}",
                    second(printed_Fx), second(exact.Fx), second(on_axis),
                    proofs::text(proofs::limit_at_zero(printed_Fx, phi())),
                    proofs::text(proofs::limit_at_zero(exact.Fx, phi())))}},
      ""};
}

Judgement two_shapes(const Printed& printed, int) {
  const Chain<Rational> chain = three_link_chain();
  // beyond the sum of all critical forces none is left; 100 is far beyond k/L + 3k/L
  const std::size_t count = count_below(chain, Rational(100));
  return judge_word(
      printed.at(0), std::to_string(count), {"1", "2", "3", "4"},
      fmt::format("there are {}, up to the sign of phi", count),
      {{EvidenceKind::theorem, "Definiteness: n - 1 critical forces; Simple modes: all distinct"},
       {EvidenceKind::exact,
        fmt::format("recursion on the unit chain: {} critical forces below 100", count)}});
}

Judgement column_shapes(const Printed& printed, int) {
  // a column cut into n links has n - 1 shapes, without bound
  std::string counts;
  std::size_t most = 0;
  for (const std::size_t n : {3U, 6U, 12U, 24U}) {
    const Chain<Rational> column(std::vector<Rational>(n, Rational(1, n)), [&] {
      std::vector<Rational> stiffness(n, Rational(n));
      stiffness[0] = 0;
      return stiffness;
    }());
    most = count_below(column, Rational(1000000));
    counts += fmt::format("{}{} links: {}", counts.empty() ? "" : ", ", n, most);
  }
  const bool right = std::to_string(most) == printed.at(0);
  const bool first_two = printed.at(0) == "2" && most > 2;
  return {right       ? Verdict::confirmed
          : first_two ? Verdict::imprecise
                      : Verdict::refuted,
          right ? ""
                : "the three-link chain has two shapes; Euler's column has infinitely many, of which the "
                  "half and the "
                  "full sine are the first two (its loads are in the ratio 1 : 4, here 1 : 3)",
          {{EvidenceKind::exact, "shapes of a pinned column cut into equal links: " + counts}},
          ""};
}

/// Twice E - F delta_x to second order in small joint angles: its sign on the directions that keep the end
/// point decides the stability of a shape just after buckling.
Rational small_form(const Chain<Rational>& chain, const std::vector<Rational>& q, const Rational& F) {
  return 2 * (strain_energy(chain, q) - F * small_deflection(chain, q).x);
}

Judgement stability(const Printed& printed, int) {
  const Chain<Rational> chain = three_link_chain();
  const std::vector<Rational> u{1, -1, -1};
  const std::vector<Rational> z{1, -3, 3};
  const Rational F_u = energy_factor(chain, u);
  const Rational F_z = energy_factor(chain, z);
  // the direction that keeps the end point of one small shape is the other shape
  const Rational at_u = small_form(chain, z, F_u);
  const Rational at_z = small_form(chain, u, F_z);
  const auto word = [](const Rational& form) { return std::string(form > 0 ? "stable" : "unstable"); };
  const bool right = printed.at(0) == word(at_u) && printed.at(1) == word(at_z);
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : fmt::format("U is {}, Z is {}", word(at_u), word(at_z)),
      {{EvidenceKind::exact,
        fmt::format(
            "L = k = 1, imposed end point: second variation at the small U (F = {}) along Z is {}, at the "
            "small Z (F = {}) along U is {}",
            F_u.str(), at_u.str(), F_z.str(), at_z.str())}},
      ""};
}

Judgement force_order(const Printed& printed, int) {
  const Rational u = energy_factor(three_link_chain(), {1, -1, -1});
  const Rational z = energy_factor(three_link_chain(), {1, -3, 3});
  return judge_word(printed.at(0),
                    u < z   ? "lower"
                    : u > z ? "higher"
                            : "equal",
                    {"lower", "higher", "equal"}, "the critical force of the U-shape is lower",
                    {{EvidenceKind::exact, fmt::format("L = k = 1: {} against {}", u.str(), z.str())}});
}

Judgement stable_curve(const Printed& printed, int) {
  const std::vector<ex> direction{1, -2 * cos(phi()), 1};  // in absolute orientations (phi, 0, -phi)
  const ex end_x = sin(phi()) * direction[0] - sin(phi()) * direction[2];
  const ex end_y = cos(phi()) * direction[0] + direction[1] + cos(phi()) * direction[2];
  if (!proofs::identical(end_x, 0) || !proofs::identical(end_y, 0))
    throw Error("U-shape", "a moving end point", "one that is kept");
  const GiNaC::matrix H = proofs::hessian(u_shape(), k() * phi() / (L() * sin(phi())), 0);
  ex form = 0;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j) form += direction[i] * H(i, j) * direction[j];
  }
  const ex closed = 2 * k() * (1 + 2 * cos(phi())) * (1 + 2 * cos(phi()) - phi() * cos(phi()) / sin(phi()));
  if (!proofs::identical(form, closed)) throw Error("U-shape", proofs::text(form), proofs::text(closed));
  const auto positive = certain_sign(
      [](const Interval& x) {
        const Interval two_cos = Interval(1) + Interval(2) * cos(x);
        return two_cos * (two_cos * sin(x) - x * cos(x));
      },
      Interval(Rational(1, 1000)), Interval(Rational(209, 100)));
  const ex at_zero = proofs::limit_at_zero(closed / k(), phi());
  const bool stable = positive == 1 && at_zero.info(GiNaC::info_flags::positive);
  return judge_word(printed.at(0), stable ? "stable" : "unstable", {"stable", "unstable"},
                    "the U-shape is stable",
                    {{EvidenceKind::interval,
                      "second variation under an imposed end point, 2k (1 + 2c)(1 + 2c - phi c / sin phi) "
                      "with c = cos phi, "
                      "positive on [0.001, 2.09] by subdivision, limit at 0: " +
                          proofs::text(at_zero) + " k; the end point reaches the base at phi = 2 pi / 3"}});
}

}  // namespace

std::vector<Claim> claims::three_link() {
  const std::string no_exact =
      "the equilibrium equations have no exact solution at the angles (phi, -3phi, 3phi)";
  return {
      {"u-shape-closes",
       "4.1, before (13)",
       "the angles (phi, -phi, -phi) keep the end point on the axis",
       {"phi", "-phi", "-phi"},
       closes},
      {"z-shape-closes",
       "4.1, before (13)",
       "the angles (phi, -3phi, 3phi) keep the end point on the axis",
       {"phi", "-3*phi", "3*phi"},
       closes},
      {"eq-13",
       "4.1, (13)",
       "Jacobian of the U-shape",
       {"0", "sin(phi)", "sin(phi)", "1+2*cos(phi)", "1+cos(phi)", "cos(phi)"},
       jacobian_u},
      {"eq-14",
       "4.1, (14)",
       "equilibrium of the U-shape",
       {"L*(1+2*cos(phi))*Fy", "L*sin(phi)*Fx+L*(1+cos(phi))*Fy-k*phi", "L*sin(phi)*Fx+L*cos(phi)*Fy-k*phi"},
       balance_u},
      {"eq-15", "4.1, (15)", "F_x = k phi / L sin phi, F_y = 0", {"k*phi/L*sin(phi)", "0"}, solution_u},
      {"u-curve-stable",
       "4.1, after (15)",
       "the U-shapes form the stable force-deflection curve",
       {"stable"},
       stable_curve},
      {"eq-16", "4.1, (16)", "critical force of the U-shape is k/L", {"k/L"}, limit_u},
      {"eq-17",
       "4.1, (17)",
       "Jacobian of the Z-shape (phi, -3phi, 3phi)",
       {"0", "sin(2*phi)-sin(phi)", "-sin(phi)", "cos(2*phi)+2*cos(phi)", "cos(2*phi)+cos(phi)", "cos(phi)"},
       jacobian_z},
      {"eq-18",
       "4.1, (18)",
       "equilibrium of the Z-shape",
       {"L*(cos(2*phi)+2*cos(phi))*Fy", "L*(sin(2*phi)-sin(phi))*Fx+L*(cos(2*phi)+cos(phi))*Fy-k*3*phi",
        "-L*sin(phi)*Fx+L*cos(phi)*Fy+k*3*phi"},
       balance_z},
      {"z-no-exact-solution", "4.1, after (18)", no_exact, {"no solutions"}, no_exact_solution},
      {"eq-19",
       "4.1, (19)",
       "F_x -> 3k phi / L sin phi, F_y = 0 for small phi",
       {"3*k*phi/L*sin(phi)", "0"},
       asymptotic_z},
      {"eq-20", "4.1, (20)", "critical force of the Z-shape is 3k/L", {"3*k/L"}, limit_z},
      {"three-link-two-shapes",
       "4.1, after (20)",
       "the three-link chain has two post-buckling shapes",
       {"2"},
       two_shapes},
      {"column-two-shapes",
       "4.1, after (20)",
       "so has Euler's column: half sine and full sine",
       {"2"},
       column_shapes},
      {"three-link-order",
       "4.1, after (20)",
       "the critical force of the U-shape is lower than that of the Z-shape",
       {"lower"},
       force_order},
      {"three-link-stability",
       "4.1, after (20)",
       "the U-shape is stable, the Z-shape unstable",
       {"stable", "unstable"},
       stability},
  };
}

}  // namespace plumbline::verify
