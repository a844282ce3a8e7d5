/// \file
/// Section 2: what the symbols of (4) to (9) stand for, and whether they fit each other.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "proofs/census/census.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// The three-link mechanism of Fig. 4 in its symbols.
struct ThreeLinks {
  proofs::Formulas formulas{{"L", "k", "phi", "alpha1", "alpha2", "q1", "q2", "Fx", "Fy"}};
  [[nodiscard]] ex operator()(const char* name) const { return formulas.symbol(name); }
  [[nodiscard]] proofs::SymbolicShape shape() const {
    const ThreeLinks& s = *this;
    return {{s("L"), s("L"), s("L")},
            {0, s("k"), s("k")},
            {s("phi"), s("alpha1") + s("q1"), s("alpha2") + s("q2")}};
  }
};

/// The deflection at which the chain of Fig. 7 is looked at.
Rational looked_at() {
  return {1, 10};
}

/// All of its equilibria there.
const proofs::Census& census(const Premises& given) {
  return held(given, "fig-7-chain").at(looked_at());
}

/// The size of a printed vector such as "[Fx Fy]^T", which has to have these entries.
std::pair<std::size_t, std::size_t> size_of(const std::string& vector, const std::string& entries) {
  const std::size_t count = 1 + static_cast<std::size_t>(std::count(entries.begin(), entries.end(), ' '));
  if (vector == "[" + entries + "]") return {1, count};
  if (vector == "[" + entries + "]^T") return {count, 1};
  throw Error("claim", "'" + vector + "'", "[" + entries + "] or its transpose");
}

/// Whether J^T F + M has a meaning for F and M as printed.
Judgement sizes(const Printed& printed, int) {
  const GiNaC::matrix J = jacobian(ThreeLinks().shape());
  const auto force = size_of(printed.at(0), "Fx Fy"), torque = size_of(printed.at(1), "0 k*q1 k*q2");
  const std::pair<std::size_t, std::size_t> right_force{J.rows(), 1}, right_torque{J.cols(), 1};
  const auto transposed = [](const auto& size) { return std::pair{size.second, size.first}; };
  const auto fits = [&](const auto& size, const auto& right) {
    return size == right               ? Verdict::confirmed
           : transposed(size) == right ? Verdict::convention
                                       : Verdict::refuted;
  };
  const Verdict verdict = worst(fits(force, right_force), fits(torque, right_torque));
  return {
      verdict,
      verdict == Verdict::confirmed
          ? ""
          : fmt::format(
                "J^T is {} x {}: F has to be a column [Fx Fy]^T, M a column of {}; F is printed as a row "
                "in (6) and among the symbols, as a column in section 4",
                J.cols(), J.rows(), J.cols()),
      {{EvidenceKind::exact, fmt::format("J is {} x {}, F as printed {} x {}, M {} x {}", J.rows(), J.cols(),
                                         force.first, force.second, torque.first, torque.second)}},
      ""};
}

/// (6) as the condition that V = E - F_x Delta - F_y (y_0 - y) of (10) is stationary.
Judgement balance(const Printed& printed, int) {
  const ThreeLinks s;
  const GiNaC::matrix J = jacobian(s.shape()), p = end_point(s.shape());
  const ex energy = s("k") * s("q1") * s("q1") / 2 + s("k") * s("q2") * s("q2") / 2;
  const ex potential = energy + s("Fx") * p(0, 0) + s("Fy") * p(1, 0);  // Delta = x_0 - x
  bool right = printed.size() == 3;
  const char* const names[] = {"phi", "q1", "q2"};
  std::vector<std::string> torques;
  for (unsigned i = 0; i < 3; ++i) {
    const auto variable = GiNaC::ex_to<GiNaC::symbol>(s(names[i]));
    const ex rest = potential.diff(variable) - J(0, i) * s("Fx") - J(1, i) * s("Fy");
    right = right && proofs::identical(rest, s.formulas.parse(printed.at(i)));
    torques.push_back(proofs::text(energy.diff(variable)));
  }
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : fmt::format("M = ({})", fmt::join(torques, ", ")),
          {{EvidenceKind::symbolic,
            "gradient of E - F_x Delta + F_y y by (phi, q_1, q_2), less J^T F; F positive in compression"}},
          ""};
}

/// Whether the orientation phi of (5) also satisfies (4) with y_0 = 0.
Judgement one_phi(const Printed& printed, const Premises& given, int) {
  const Chain<Interval> chain = given.chain("fig-7-chain");
  bool another = true;
  for (const auto& one : census(given).equilibria) {
    const Interval y0 = end_point(chain, {one.q[0], chain.rest()[1], chain.rest()[2]}).y;
    another = another && !y0.contains_zero();
  }
  const std::string found = another ? "2" : "1";
  return {
      printed.at(0) == found ? Verdict::confirmed
      : printed.at(0) == "1" ? Verdict::convention
                             : Verdict::refuted,
      printed.at(0) == found
          ? ""
          : "phi of (4) is the first link's orientation without load, with y_0 = 0, and phi of "
            "(5) that under it: the base joint turns",
      {{EvidenceKind::interval,
        fmt::format(
            "chain of Fig. 7 at {}, certified census: phi of each equilibrium put into (4) gives y_0 != 0",
            in_lengths(looked_at()))}},
      ""};
}

/// What Delta depends on, and what these angles are.
Judgement deflection_angles(const Printed& printed, int) {
  const proofs::Formulas angles({"L", "phi", "second", "third"});
  const ex L = angles.symbol("L"), phi = angles.symbol("phi"), b = angles.symbol("second"),
           c = angles.symbol("third");
  const GiNaC::matrix p = proofs::end_point({{L, L, L}, {0, 1, 1}, {phi, b, c}});
  const ex reach = p(0, 0) * p(0, 0) + p(1, 0) * p(1, 0);
  const auto depends = [&](const ex& angle) {
    return !proofs::identical(reach.diff(GiNaC::ex_to<GiNaC::symbol>(angle)), 0);
  };
  if (depends(phi) || !depends(b) || !depends(c))
    throw Error("three links", "another dependence", "one on both joints alone");
  const ThreeLinks s;
  const proofs::SymbolicShape shape = s.shape();
  const ex second = s.formulas.parse(printed.at(0)), third = s.formulas.parse(printed.at(1));
  const bool joints = proofs::identical(second, shape.q[1]) && proofs::identical(third, shape.q[2]);
  const std::string kind = proofs::identical(second, shape.q[0] + shape.q[1]) ? "orientation" : "joint";
  const bool right = joints && printed.at(2) == kind;
  return {!joints                          ? Verdict::refuted
          : right                          ? Verdict::confirmed
          : printed.at(2) == "orientation" ? Verdict::convention
                                           : Verdict::refuted,
          right ? ""
                : "Delta depends on the joint angles alpha_1 + q_1 and alpha_2 + q_2; the orientations of "
                  "the links are phi, phi + alpha_1 + q_1 and so on",
          {{EvidenceKind::symbolic,
            "x^2 + y^2 of (5) does not depend on phi, but on both joints; the orientation of link 2 is phi + "
            "alpha_1 + q_1"}},
          ""};
}

/// printed: S_2^2 as a function of C2, and how many signs of S_2 occur
Judgement elbow_sine(const Printed& printed, const Premises& given, int) {
  const proofs::Formulas formulas({"C2", "a"});
  const ex a = formulas.symbol("a");
  const ex square = formulas.parse(printed.at(0)).subs(formulas.symbol("C2") == cos(a));
  std::set<char> found;
  for (const auto& one : census(given).equilibria) found.insert(sign_character(sin(one.q[2])));
  const bool right =
      proofs::identical(square, sin(a) * sin(a)) && printed.at(1) == std::to_string(found.size());
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : fmt::format("S_2^2 = 1 - C2^2, and {} signs of S_2 occur", found.size()),
      {{EvidenceKind::symbolic, "C2 and S_2 are cosine and sine of the third joint's angle"},
       {EvidenceKind::interval, fmt::format("chain of Fig. 7 at {}, certified census: {} signs of the third "
                                            "joint's sine among the equilibria",
                                            in_lengths(looked_at()), found.size())}},
      ""};
}

/// What tells the equilibria apart.
Judgement not_unique(const Printed& printed, const Premises& given, int) {
  std::map<char, std::size_t> count;
  for (const auto& one : census(given).equilibria) ++count[sign_character(sin(one.q[2]))];
  return judge_word(
      printed.at(0), count['+'] > 0 && count['-'] > 0 ? "the sign" : "phi",
      "all of them have one sign of S_2",
      {{EvidenceKind::interval,
        fmt::format("chain of Fig. 7 at {}, certified census: {} equilibria with S_2 > 0, {} with "
                    "S_2 < 0; so either sign has several, which phi tells apart",
                    in_lengths(looked_at()), count['+'], count['-'])}});
}

}  // namespace

Checks claims::symbols() {
  return {
      {"eq-6-sizes", sizes},      {"eq-6", balance},
      {"phi-one-angle", one_phi}, {"deflection-angles", deflection_angles},
      {"eq-9-S2", elbow_sine},    {"not-unique", not_unique},
  };
}

}  // namespace plumbline::verify
