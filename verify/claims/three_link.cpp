/// \file
/// Section 4.1: the straight three-link chain with a passive base joint, equations (13) to (20).

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/straight/critical_force.hpp>
#include <sstream>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/straight_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/notation.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

const proofs::Formulas& stretched_formulas() {
  static const proofs::Formulas instance({"phi", "k", "L", "Fx", "Fy"});
  return instance;
}

ex phi() {
  return stretched_formulas().symbol("phi");
}
ex k() {
  return stretched_formulas().symbol("k");
}
ex L() {
  return stretched_formulas().symbol("L");
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
  for (const std::string& angle : printed) q.push_back(stretched_formulas().parse(angle));
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
      printed.at(0), solvable ? "have exact solutions" : "do not have exact solutions",
      fmt::format(
          "with the right entry (1,1) of (17) the three equations have an exact solution at (phi, -3 phi, "
          "3 phi) where sin 3 phi != 0: F_x = {}, F_y = {}, along the line from the base to the end point, "
          "which lies off the axis",
          formula_in_print(proofs::text(closed.Fx)), formula_in_print(proofs::text(closed.Fy))),
      {{EvidenceKind::symbolic, fmt::format("F_x and F_y from equations 2 and 3 put into the corrected "
                                            "equation 1: the residual {} identically; F "
                                            "parallel to the end point: {}",
                                            solvable ? "vanishes" : "does not vanish", along_line)}});
}

Judgement two_shapes(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> chain = given.exact_chain("three-links");
  // beyond the sum of all critical forces none is left; 100 is far beyond k/L + 3k/L
  const std::size_t count = count_below(chain, Rational(100));
  return judge_word(
      printed.at(0), std::to_string(count), fmt::format("there are {}, up to the sign of phi", count),
      {Evidence::by_checked_theorem("Definiteness", {"forces.critical_forces", "forces.simple_forces"},
                                    "n - 1 critical forces; Simple modes: all distinct"),
       {EvidenceKind::exact,
        fmt::format("recursion on the unit chain: {} critical forces below 100", count)}});
}

/// The first two shapes of a column between pins, cut into equal links.
Judgement column_shapes(const Printed& printed, int) {
  // mode m has link orientations cos((j - 1/2) a), a = m pi / n; their sums are the heights of the joints
  const proofs::Formulas half({"b"});  // a = 2b
  bool heights = true;
  for (int j = 1; j <= 6; ++j) {
    const ex link = half.parse(fmt::format("2*sin(b)*cos({}*b)", 2 * j - 1)),
             rise = half.parse(fmt::format("sin({}*b)-sin({}*b)", 2 * j, 2 * j - 2));
    heights = heights && proofs::identical(link, rise);
  }
  return judge_list(
      printed, heights ? Printed{"half sine", "full sine"} : Printed{},
      "the joints of mode m lie on sin(m pi j/n)",
      {Evidence::by_theorem(
           "Equal links",
           "mode m of n equal links between pins has the orientations cos((j - 1/2) m pi/n); "
           "the column is the limit, with infinitely many shapes, in the ratio of "
           "forces 1 : 4 : 9 (here 1 : 3)"),
       {EvidenceKind::symbolic,
        "2 sin(a/2) cos((j - 1/2) a) = sin(j a) - sin((j - 1) a): the heights are sin(m pi j/n), a half sine "
        "for m = 1, a full one for m = 2"}});
}

/// Where the curves of Fig. 5 begin.
Judgement curves_begin(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> limits;
  for (const proofs::SymbolicShape& s : {u_shape(), z_shape()})
    limits.push_back(proofs::text((proofs::limit_at_zero(solve(s).Fx, phi()) * L() / k()).normal()));
  const Rational d(1, 1000);
  const proofs::Census census = held(given, "three-links").at(d);
  bool near = census.equilibria.size() == 4;
  std::vector<std::string> found;
  for (const auto& one : census.equilibria) {
    const Rational limit = proofs::parse_decimal(letter(one).front() == 'U' ? limits[0] : limits[1]).value();
    const Interval off = -one.fx - Interval(limit);
    near = near && certainly_less(off, Interval(Rational(1, 100))) &&
           certainly_less(-off, Interval(Rational(1, 100)));
    found.push_back(fmt::format("{} {}", letter(one), certified_decimal(-one.fx, 6)));
  }
  return judge_list(
      printed, near ? limits : std::vector<std::string>{}, fmt::format("{} k/L", fmt::join(limits, " and ")),
      {{EvidenceKind::symbolic, "limits (16) and (20) from the solutions of (14) and (18)"},
       {EvidenceKind::interval, fmt::format("certified census of the straight chain at {}: {} k/L",
                                            in_lengths(d), fmt::join(found, ", "))}});
}

/// Twice E - F delta_x to second order in small joint angles: its sign on the directions that keep the end
/// point decides the stability of a shape just after buckling.
Rational small_form(const Chain<Rational>& chain, const std::vector<Rational>& q, const Rational& F) {
  return 2 * (strain_energy(chain, q) - F * small_deflection(chain, q).x);
}

Judgement stability(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> chain = given.exact_chain("three-links");
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

Judgement force_order(const Printed& printed, const Premises& given, int) {
  const Rational u = energy_factor(given.exact_chain("three-links"), {1, -1, -1});
  const Rational z = energy_factor(given.exact_chain("three-links"), {1, -3, 3});
  return judge_word(printed.at(0),
                    u < z   ? "lower"
                    : u > z ? "higher"
                            : "equal",
                    "the critical force of the U-shape is lower",
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
  const Rational from(1, 1000), to(209, 100);
  const auto positive = certain_sign(
      [](const Interval& x) {
        const Interval two_cos = Interval(1) + Interval(2) * cos(x);
        return two_cos * (two_cos * sin(x) - x * cos(x));
      },
      Interval(from), Interval(to));
  const ex at_zero = proofs::limit_at_zero(closed / k(), phi());
  const bool stable = positive == 1 && at_zero.info(GiNaC::info_flags::positive);
  return judge_word(
      printed.at(0), stable ? "stable" : "unstable", "the U-shape is stable",
      {{EvidenceKind::interval,
        fmt::format("second variation under an imposed end point, 2k (1 + 2c)(1 + 2c - phi c / sin phi) "
                    "with c = cos phi, positive on [{}, {}] by subdivision, limit at 0: {} k; the end "
                    "point reaches the base at phi = 2 pi / 3",
                    proofs::to_exact(from), proofs::to_exact(to), proofs::text(at_zero))}});
}

}  // namespace

Checks claims::three_link() {
  return {
      {"u-shape-closes", closes},
      {"z-shape-closes", closes},
      {"u-curve-stable", stable_curve},
      {"z-no-exact-solution", no_exact_solution},
      {"three-link-two-shapes", two_shapes},
      {"column-two-shapes", column_shapes},
      {"agrees-with-fig-5", curves_begin},
      {"three-link-order", force_order},
      {"three-link-stability", stability},
  };
}

}  // namespace plumbline::verify
