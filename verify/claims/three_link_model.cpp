/// \file
/// Section 2, the mechanics of the three-link mechanism: equations (4) to (10).

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <iterator>
#include <set>

#include "proofs/census/census.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/matrix_formula.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// The angles of Fig. 4 and the symbols of (4) to (10).
const proofs::Formulas& model_formulas() {
  static const proofs::Formulas instance(
      {"L", "k", "phi", "alpha1", "alpha2", "q1", "q2", "x0", "y0", "Delta", "S2", "C2", "Fx", "E"});
  return instance;
}
ex symbol(const char* name) {
  return model_formulas().symbol(name);
}

std::vector<ex> place(const ex& second, const ex& third) {
  const ex L = symbol("L");
  const GiNaC::matrix p = proofs::end_point({{L, L, L}, {0, 1, 1}, {symbol("phi"), second, third}});
  return {p(0, 0), p(1, 0)};
}

/// "S02" can stand for "S012": the same letter, first and last link.
bool abbreviates(const std::string& shorter, const std::string& longer) {
  return shorter.substr(0, 2) == longer.substr(0, 2) && shorter.back() == longer.back();
}

/// "S012" as "S_012".
std::vector<std::string> indexed(std::vector<std::string> names) {
  for (std::string& name : names) name.insert(1, "_");
  return names;
}

Judgement abbreviations(const Printed& printed, int) {
  const std::set<std::string> defined(printed.begin(), printed.end());
  std::set<std::string> used;
  for (const std::string& entry : printed_in_paper("eq-7")) {
    for (std::size_t at = 0, end; (at = entry.find_first_of("SC", at)) != std::string::npos; at = end) {
      end = std::min(entry.find_first_of("+-", at), entry.size());
      used.insert(entry.substr(at, end - at));
    }
  }
  std::vector<std::string> missing, idle;
  std::set_difference(used.begin(), used.end(), defined.begin(), defined.end(), std::back_inserter(missing));
  std::set_difference(defined.begin(), defined.end(), used.begin(), used.end(), std::back_inserter(idle));
  const bool right = missing.empty() && idle.empty() && printed.size() == used.size();
  const bool meant =
      printed.size() == used.size() && !missing.empty() &&
      std::equal(missing.begin(), missing.end(), idle.begin(), idle.end(),
                 [](const auto& longer, const auto& shorter) { return abbreviates(shorter, longer); });
  return {right   ? Verdict::confirmed
          : meant ? Verdict::convention
                  : Verdict::refuted,
          right ? ""
                : fmt::format("(7) uses {}, which the text does not define; it defines {} in their place",
                              fmt::join(indexed(missing), " and "), fmt::join(indexed(idle), " and ")),
          {{EvidenceKind::exact,
            fmt::format("names in (7), {}, against names that are defined after it", fmt::join(used, ", "))}},
          ""};
}

/// The least favourable kind of equilibrium that a census of the U-chain holds.
Judgement kind_of_point(const Printed& printed, const Premises& given, int) {
  const Rational d(1, 10);
  const proofs::Census& census = held(given, "fig-7-chain").at(d);
  bool all_minima = true;
  for (const auto& one : census.equilibria) all_minima = all_minima && one.negative_directions == 0;
  const std::string found = all_minima ? "minimum" : "stationary point";
  return {printed.at(0) == found ? Verdict::confirmed : Verdict::imprecise,
          printed.at(0) == found
              ? ""
              : "so for a stable one; every equilibrium is a stationary point of the energy",
          {Evidence::by_theorem("Stability", "minima are stable, what has a negative direction is not"),
           {EvidenceKind::interval, "certified census of the chain of Fig. 7 at " + in_lengths(d) + ": " +
                                        types(census) + ", and (8) gives the force of each"}},
          ""};
}

/// (8), a formula in J and M, with torques that (6) makes for a known force.
Judgement force_of_torques(const Printed& printed, int) {
  Matrix<Rational> J(2, 3), F(2, 1);
  J << 1, 2, 3, -1, 4, 2;
  F << 5, -7;
  const Matrix<Rational> M = -(J.transpose() * F);
  const auto found = evaluated(printed.at(0), {{"J", J}, {"M", M}});
  const bool right = found && *found == F;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "F = -(J^T)^+ M",
          {{EvidenceKind::exact,
            "J = (1 2 3; -1 4 2), M = -J^T F of (6) with F = (5, -7): the formula gives F back. It is "
            "an equilibrium only where M lies in the range of J^T"}},
          ""};
}

Judgement reduced_space(const Printed& printed, int) {
  Matrix<Rational> row(1, 3);  // dy: the x components of the links after each joint, cos = 3/5, 5/13, 1
  row << Rational(3, 5) + Rational(5, 13) + 1, Rational(5, 13) + 1, Rational(1);
  const auto freedom = 3 - Eigen::FullPivLU<Matrix<Rational>>(row).rank();
  return judge_word(
      printed.at(0), std::to_string(freedom), fmt::format("{} variables", freedom),
      {{EvidenceKind::exact,
        "three angles, one condition y = 0 of rank 1. (Delta, phi) leave the sign of S_2 open: every "
        "pair belongs to two shapes"}});
}

/// A number for a symbol of a formula.
GiNaC::relational value(const char* name, const proofs::Located& number) {
  return GiNaC::ex_to<GiNaC::relational>(symbol(name) == GiNaC::numeric(number.str(60).c_str()));
}

/// (9) by trial: shapes are chosen, the formulas have to give them back, up to full turns.
Judgement inverse_kinematics(const Printed& printed, int) {
  const long digits = GiNaC::Digits;
  GiNaC::Digits = 60;
  const proofs::Located alpha1("0.3"), alpha2("-0.2");
  proofs::Located worst(0);
  int shapes = 0;
  for (const int bend : {-7, -2, 3, 9}) {
    for (const int turn : {-5, 1, 6}) {
      const proofs::Located phi = proofs::Located(turn) / 10, second = proofs::Located(bend - turn) / 8,
                            third = proofs::Located(bend) / 4;
      const proofs::Located a = phi + second, b = a + third;
      const proofs::Located x = cos(phi) + cos(a) + cos(b), y = sin(phi) + sin(a) + sin(b);
      const GiNaC::lst values{value("L", 1),
                              value("phi", phi),
                              value("alpha1", alpha1),
                              value("alpha2", alpha2),
                              value("x0", proofs::Located(x + 2)),
                              value("Delta", 2),
                              value("y0", y),
                              value("S2", sin(third)),
                              value("C2", cos(third))};
      const proofs::Located meant[] = {second - alpha1, third - alpha2};
      for (std::size_t i = 0; i < 2; ++i) {
        const ex number = model_formulas().parse(printed.at(i)).subs(values).evalf();
        if (!GiNaC::is_a<GiNaC::numeric>(number)) throw Error("claim", printed[i], "a formula for an angle");
        const proofs::Located off = proofs::Located(proofs::text(number)) - meant[i];
        worst = std::max(worst, proofs::Located(abs(sin(off / 2))));  // full turns do not count
      }
      ++shapes;
    }
  }
  GiNaC::Digits = digits;
  const bool right = worst < proofs::Located("1e-45");
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : "the printed angles do not bring the end point to its place",
      {{EvidenceKind::mp50,
        fmt::format("the direction to the end point less the angle at the base of the triangle of two links, "
                    "up to full turns, which (10) has to remove: {} shapes with both signs of S_2: largest "
                    "|sin(error / 2)| {}",
                    shapes, worst.str(2))}},
      ""};
}

/// Whether stable (or unstable) equilibria are just the absolute extremum of E over phi.
Judgement extremum(const Printed& printed, const Premises& given, bool stable) {
  const Rational d(1, 10);
  const proofs::Census& census = held(given, "fig-7-chain").at(d);
  std::vector<const proofs::CertifiedEquilibrium*> some;
  for (const auto& one : census.equilibria) {
    if ((one.negative_directions == 0) == stable) some.push_back(&one);
  }
  bool alike = true;
  for (const auto* one : some)
    alike = alike && !certainly_less(one->energy, some[0]->energy) &&
            !certainly_less(some[0]->energy, one->energy);
  const std::string absolute = stable ? "arg min" : "arg max",
                    local = stable ? "local minimum" : "local maximum";
  std::vector<std::string> energies;
  for (const auto* one : some) energies.push_back(certified_decimal(one->energy, 5));
  const std::string found = alike ? absolute : local;
  return {
      printed.at(0) == found      ? Verdict::confirmed
      : printed.at(0) == absolute ? Verdict::convention
                                  : Verdict::refuted,
      printed.at(0) == found
          ? ""
          : fmt::format("every {} of E over phi is meant; the absolute one alone would be one "
                        "of {}",
                        local, some.size()),
      {{EvidenceKind::interval,
        fmt::format("chain of Fig. 7 at {}, certified census: {} {} equilibria with E = {} k", in_lengths(d),
                    some.size(), stable ? "stable" : "unstable", fmt::join(energies, " and "))}},
      ""};
}

Judgement arg_min(const Printed& printed, const Premises& given, int) {
  return extremum(printed, given, true);
}
Judgement arg_max(const Printed& printed, const Premises& given, int) {
  return extremum(printed, given, false);
}

/// The gradient by (phi, q1, q2) of a potential of E, Fx and Delta, Delta as a function of the shape, less
/// J^T F + M of (6) with F = (Fx, 0).
bool belongs_to_6(const ex& potential, const ex& deflection) {
  const ex L = symbol("L"), k = symbol("k"), q1 = symbol("q1"), q2 = symbol("q2");
  const proofs::SymbolicShape shape{
      {L, L, L}, {0, k, k}, {symbol("phi"), symbol("alpha1") + q1, symbol("alpha2") + q2}};
  const GiNaC::matrix J = proofs::jacobian(shape);
  const ex of_shape = potential.subs(
      GiNaC::lst{symbol("E") == k * q1 * q1 / 2 + k * q2 * q2 / 2, symbol("Delta") == deflection});
  const ex torque[] = {0, k * q1, k * q2};
  const char* const names[] = {"phi", "q1", "q2"};
  for (unsigned i = 0; i < 3; ++i) {
    const ex slope = of_shape.diff(GiNaC::ex_to<GiNaC::symbol>(symbol(names[i])));
    if (!proofs::identical(slope, J(0, i) * symbol("Fx") + torque[i])) return false;
  }
  return true;
}

ex loaded_x() {
  return place(symbol("alpha1") + symbol("q1"), symbol("alpha2") + symbol("q2"))[0];
}

Judgement load_term(const Printed& printed, int) {
  const ex potential = model_formulas().parse(printed.at(0));
  const bool free = potential.diff(GiNaC::ex_to<GiNaC::symbol>(symbol("phi"))).is_zero();
  const bool right = free && belongs_to_6(potential, symbol("x0") - loaded_x());
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "V = E - F_x Delta",
          {{EvidenceKind::symbolic,
            "the gradient of the printed V by (phi, q1, q2), Delta = x_0 - x of (5), is J^T F + M of (6) "
            "with F = "
            "(F_x, 0); at a given Delta its load term does not depend on phi"}},
          ""};
}

/// printed: x and y by Delta
Judgement deflection_sign(const Printed& printed, int) {
  const ex x = model_formulas().parse(printed.at(0)), y = model_formulas().parse(printed.at(1));
  const ex deflection = symbol("Delta");
  // solved for Delta: x is linear in it
  const ex slope = x.diff(GiNaC::ex_to<GiNaC::symbol>(deflection));
  const bool linear = !slope.is_zero() && slope.info(GiNaC::info_flags::numeric);
  const bool right = linear && y.is_zero() &&
                     belongs_to_6(symbol("E") - symbol("Fx") * deflection,
                                  ((loaded_x() - x.subs(deflection == 0)) / slope).expand()) &&
                     proofs::identical(x.subs(deflection == 0), symbol("x0"));
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "x = x_0 - Delta, y = 0",
          {{EvidenceKind::symbolic,
            "with Delta from the printed x, V = E - F_x Delta has the gradient J^T F + M of (6), in which "
            "F_x is positive "
            "in compression; without deflection x = x_0; y_0 = y = 0 by the constraint"}},
          ""};
}

/// What (10) is to the potential energy E - F_x Delta.
Judgement potential_or_strain(const Printed& printed, int) {
  const ex energy = model_formulas().parse(printed.at(0)),
           full = symbol("E") - symbol("Fx") * symbol("Delta");
  const bool same = proofs::identical(energy, full);
  const bool apart_from_load =
      proofs::identical(energy, symbol("E"));  // at a given Delta the two differ by a constant
  return {
      same              ? Verdict::confirmed
      : apart_from_load ? Verdict::convention
                        : Verdict::refuted,
      same ? ""
           : "(10) is the strain energy; at a given Delta it differs from the potential energy by a constant",
      {{EvidenceKind::symbolic,
        "E - F_x Delta less (10) is -F_x Delta, the same for all shapes with that Delta"}},
      ""};
}

}  // namespace

Checks claims::three_link_model() {
  return {
      {"eq-7-names", abbreviations},
      {"equilibrium-is-minimum", kind_of_point},
      {"eq-8", force_of_torques},
      {"reduced-space", reduced_space},
      {"eq-9-angles", inverse_kinematics},
      {"arg-min", arg_min},
      {"arg-max", arg_max},
      {"strain-energy-suffices", load_term},
      {"end-point-deflection", deflection_sign},
      {"energy-10", potential_or_strain},
  };
}

}  // namespace plumbline::verify
