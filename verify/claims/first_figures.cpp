/// \file
/// Section 2, Figures 2, 3, 5 and 6: what the curves of two and of three links are said to show.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <map>
#include <plumbline/chain/linearised.hpp>
#include <set>

#include "proofs/census/census.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/chains/three_link_plane.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

// --- two links, k = L = 1: V(q) = 2 q^2 - 2 F (cos alpha - cos(alpha + q))

Interval deflection(const Interval& alpha, const Interval& q) {
  return Interval(2) * (cos(alpha) - cos(alpha + q));
}

/// The minima of V for -pi < alpha + q < pi, ascending, each enclosed tightly.
std::vector<Interval> minima(const Interval& alpha, const Interval& F) {
  const auto slope = [&](const Interval& q) { return Interval(2) * q - F * sin(alpha + q); };
  const auto curvature = [&](const Interval& q) { return Interval(2) - F * cos(alpha + q); };
  std::vector<Interval> found;
  for (Interval q : isolate_zeros(slope, curvature, -Interval::pi() - alpha, Interval::pi() - alpha)) {
    if (!certainly_positive(curvature(q))) continue;
    for (int i = 0; i < 8; ++i) {  // interval Newton
      const Interval m(q.middle(), q.middle());
      q = intersection(q, m - slope(m) / curvature(q)).value();
    }
    found.push_back(q);
  }
  return found;
}

Judgement straight_in_figure(const Printed& printed, int) {
  const Rational F(199, 100);
  const std::vector<Interval> at = minima(Interval(0), Interval(F));
  const bool straight = at.size() == 1 && at[0].contains_zero();
  return judge_word(
      printed.at(0), straight ? "none" : "some", "below F_c the only stable shape is the straight one",
      {Evidence::by_theorem(
           "Two links",
           "for F <= 2k/L V >= (2k - FL) q^2, with equality at q = 0 only (V as in (3), alpha = 0)"),
       {EvidenceKind::interval,
        fmt::format("F = {} k/L: minima of V for -pi < q < pi isolated: {}, {}", proofs::to_exact(F),
                    at.size(), straight ? "q = 0" : "not at q = 0")}});
}

/// Forces on the straight chain of two links above its critical 2 k/L.
std::vector<Rational> above_critical() {
  return {Rational(201, 100), Rational(5, 2), Rational(4)};
}

std::string list_of(const std::vector<Rational>& numbers) {
  std::vector<std::string> texts;
  for (const Rational& one : numbers) texts.push_back(proofs::to_exact(one));
  return fmt::format("{}", fmt::join(texts, ", "));
}

Judgement bent_above(const Printed& printed, int) {
  bool bent = true;
  std::size_t count = 0;
  for (const Rational& F : above_critical()) {
    const std::vector<Interval> at = minima(Interval(0), Interval(F));
    count = at.size();
    bent = bent && count == 2 && certainly_negative(at[0]) && certainly_positive(at[1]);
  }
  return judge_word(
      printed.at(0), bent ? "bent" : "straight", "above F_c the straight shape is a maximum of V",
      {Evidence::at_points(fmt::format("minima of V at F = {} k/L: {} each, mirror images with q != 0",
                                       list_of(above_critical()), count)),
       Evidence::by_theorem("Two links", "for F > 2k/L the straight shape is no minimum")});
}

/// Whether the deflection of the stable shape grows with the force: "depends", else "fixed".
std::string dependence(const Interval& alpha, const std::vector<Rational>& forces, std::string& note) {
  Interval before(0);
  bool grows = true;
  for (const Rational& F : forces) {
    const Interval now = deflection(alpha, minima(alpha, Interval(F)).back());
    grows = grows && certainly_less(before, now);
    note += fmt::format("{}{}", note.empty() ? "" : ", ", certified_decimal(now, 6));
    before = now;
  }
  return grows ? "depends" : "fixed";
}

Judgement shape_depends(const Printed& printed, int) {
  std::string note;
  const std::string word = dependence(Interval(0), above_critical(), note);
  return judge_word(printed.at(0), word, "the deflection at the minimum grows with F",
                    {Evidence::at_points(fmt::format("deflections / L at the minima for F = {} k/L: {}",
                                                     list_of(above_critical()), note)),
                     Evidence::by_theorem("Two links", "force and deflection grow strictly with q")});
}

std::string alpha_of(const Premises& given) {
  return given.at("fig-3-angle").parts.at("value").front();
}

Judgement bent_minimum(const Printed& printed, const Premises& given, int) {
  std::string note;
  const Interval alpha = given.value("fig-3-angle");
  const std::vector<Rational> forces{Rational(1, 2), Rational(1), Rational(2), Rational(3)};
  const std::string word = dependence(alpha, forces, note) == "depends" ? "nonzero" : "zero";
  return judge_word(printed.at(0), word, "the minimum moves away from 0 as the force grows",
                    {Evidence::at_points(fmt::format(
                         "alpha = {}, F = {} k/L: deflections / L at the minimum with alpha + q > 0: {}",
                         alpha_of(given), list_of(forces), note)),
                     Evidence::by_theorem("Two links", "force and deflection grow strictly with q")});
}

Judgement through_zero(const Printed& printed, const Premises& given, int) {
  const proofs::Formulas formulas({"F", "Delta"});
  const Interval alpha = given.value("fig-3-angle");
  const Interval force = Interval(0) / sin(alpha);  // F(0) = 2 k 0 / (L sin alpha)
  const bool zero = force.contains_zero() && deflection(alpha, Interval(0)).contains_zero();
  const bool right =
      zero && formulas.parse(printed.at(0)).is_zero() && formulas.parse(printed.at(1)).is_zero();
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : "F(0) = 0 and Delta(0) = 0: without force the chain has its own shape",
      {{EvidenceKind::symbolic, "(1) at q = 0: F = 2k 0/(L sin alpha) = 0, Delta = 0, as sin alpha != 0"}},
      ""};
}

Judgement resists(const Printed& printed, const Premises& given, int) {
  const Interval alpha = given.value("fig-3-angle");
  // F Delta over k: q (cos alpha - cos(alpha + q)) / sin(alpha + q), up to a positive factor
  const auto work = [&](const Interval& q) { return q * deflection(alpha, q) / sin(alpha + q); };
  const Interval small(Rational(1, 100)), end = Interval::pi() * Interval(Rational(1, 1000)),
                                          least = end - alpha, most = Interval::pi() - end - alpha;
  const auto pushed = certain_sign(work, small, most), pulled = certain_sign(work, least, -small);
  return judge_word(
      printed.at(0), pushed == 1 && pulled == 1 ? "resists" : "does not",
      "the force has the sign of the deflection",
      {Evidence::by_theorem(
           "Two links",
           "for 0 < alpha + q < pi F = 2kq/(L sin(alpha+q)) and Delta = 2L(cos alpha - cos(alpha+q)) "
           "both have the "
           "sign of q"),
       {EvidenceKind::interval,
        fmt::format("alpha = {}: sign of F Delta for q in [{}, {}] and [{}, {}]: {}, {}", alpha_of(given),
                    least.text(4), (-small).text(4), small.text(4), most.text(4), pulled.value_or(0),
                    pushed.value_or(0))}});
}

// --- three links with a passive base

HeldChain straight_chain(const Premises& given) {
  return held(given, "three-links");
}
const PlaneProof& straight_plane(const Premises& given) {
  return prove_in_plane(straight_chain(given), Rational(1, 10000), Rational(19, 10));
}

Rational looked_at_straight() {
  return {3, 10};
}

/// Those of one deflection, which stand for all where the proof in the plane is whole.
const std::vector<proofs::CertifiedEquilibrium>& bent_equilibria(const Premises& given) {
  if (!straight_plane(given).whole) throw Error("straight chain", "an open range of deflections", "a proof");
  return straight_chain(given).at(looked_at_straight()).equilibria;
}

Evidence of_straight_chain(const Premises& given, const std::string& census) {
  return {EvidenceKind::interval,
          fmt::format("straight chain, {}; certified census at {}: {}", straight_plane(given).text(),
                      in_lengths(looked_at_straight()), census)};
}

Judgement equilibria(const Printed& printed, const Premises& given, int) {
  const std::string found = std::to_string(bent_equilibria(given).size());
  return judge_word(printed.at(0), found, found + " equilibria at a deflection",
                    {of_straight_chain(given, found)});
}

Judgement stable_letters(const Printed& printed, const Premises& given, int) {
  std::map<char, std::string> found;
  for (const auto& one : bent_equilibria(given)) {
    std::string& word = found[letter(one).front()];
    const std::string here = one.negative_directions.value() == 0 ? "stable" : "unstable";
    word = word.empty() || word == here ? here : "both";
  }
  return judge_rows(printed, {"U", found['U'], "Z", found['Z']}, 2,
                    fmt::format("U is {}, Z is {}", found['U'], found['Z']),
                    {of_straight_chain(given, fmt::format("U is {}, Z is {}", found['U'], found['Z']))});
}

/// The nearly straight chain, or its mirror image.
HeldChain quasi_straight(const Premises& given, int sign) {
  const Chain<Interval> chain = given.chain("quasi-straight");
  std::vector<Interval> rest = chain.rest();
  for (Interval& angle : rest) angle *= Interval(sign);
  return held(Chain<Interval>(chain.length(), chain.stiffness(), rest));
}

/// The U-shape that it takes.
std::string side(const Premises& given, int sign) {
  const HeldChain chain = quasi_straight(given, sign);
  const Rational at = looked_at_straight();
  return letter(reached(chain.at(at), chain.compressed(0.5), at));
}

std::string rest_angle(const Premises& given) {
  return given.at("quasi-straight").parts.at("rest").back();
}

Judgement which_side(const Printed& printed, const Premises& given, int) {
  const std::string left = side(given, 1), right = side(given, -1);
  const bool chosen = left == "U⁺" && right == "U⁻";
  return judge_word(
      printed.at(0), chosen ? "the perturbation" : "nothing",
      "the observed shape does not depend on the rest angles",
      {{EvidenceKind::interval,
        fmt::format("slowly compressed to {} the chain with alpha_1 = alpha_2 = {} is {}, its mirror image "
                    "{}; each is in the certified census there",
                    in_lengths(looked_at_straight()), rest_angle(given), left, right)}});
}

Judgement only_stable(const Printed& printed, const Premises& given, int) {
  const HeldChain chain = quasi_straight(given, 1);
  const PlaneProof& plane = prove_in_plane(chain, 0, Rational(1, 20));
  const Counts large(types(chain.at(looked_at_straight())));
  const std::string found = large.of("stable") == 1 ? "the only stable one" : "one of two stable ones";
  const std::string observed = side(given, 1);
  Judgement result{
      Verdict::confirmed,
      "",
      {{EvidenceKind::interval,
        fmt::format("alpha_1 = alpha_2 = {}: {}{}; certified census at {}: {}; the slowly compressed chain "
                    "is {}",
                    rest_angle(given), plane.whole ? "" : "open, ", plane.text(),
                    in_lengths(looked_at_straight()), large.text(), observed)}},
      ""};
  if (printed.at(0) == observed && printed.at(1) == found) return result;
  // of the stable ones the only one that is observed: the sentences before say that there are two
  result.verdict = printed.at(0) == observed && printed.at(1) == "the only stable one" ? Verdict::convention
                                                                                       : Verdict::refuted;
  result.truth = fmt::format(
      "slow compression leads to {} alone; it is {}, and the other is reached by a push", observed, found);
  return result;
}

/// The name of the chain with the rest angles (epsilon, epsilon): the paper gives it to the signs of both.
Judgement quasi_straight_name(const Printed& printed, const Premises& given, int) {
  const auto name = [&](int sign) {
    proofs::CertifiedEquilibrium rest;
    rest.q = quasi_straight(given, sign).chain.rest();
    return letter(rest);
  };
  const std::string negative = name(1), positive = name(-1),
                    found = fmt::format("{} for epsilon < 0, {} for epsilon > 0", negative, positive);
  const Verdict verdict = printed.at(0) == found                                   ? Verdict::confirmed
                          : printed.at(0) == negative || printed.at(0) == positive ? Verdict::convention
                                                                                   : Verdict::refuted;
  return {
      verdict,
      verdict == Verdict::confirmed ? "" : "by the definition in 3.1 (U⁺ has negative angles) it is " + found,
      {{EvidenceKind::interval,
        "signs of the rest angles (epsilon, epsilon), epsilon = " + rest_angle(given) + ", and turned"}},
      ""};
}

/// Which sine the joints of a buckled shape lie on, of those that vanish at both ends.
std::string sine(const Rational& force, const std::vector<Rational>& q) {
  const Chain<Rational> chain({1, 1, 1}, {0, 1, 1});
  Vector<Rational> v(4);
  v << q[0], q[1], q[2], Rational(0);
  const Matrix<Rational> pencil = matrix_A(chain) * force + matrix_B(chain);
  if (Vector<Rational>(pencil * v) != Vector<Rational>(Vector<Rational>::Zero(4)))
    throw Error("three links", "no mode", "a solution of (32)");
  const Rational first = q[0], second = first + q[0] + q[1];  // heights of joints 2 and 3
  for (const int halves : {1, 2}) {
    // sin(2 a) / sin a = 2 cos a
    const GiNaC::ex ratio = 2 * cos(GiNaC::Pi * halves / 3);
    if (second * static_cast<int>(GiNaC::ex_to<GiNaC::numeric>(ratio.denom()).to_int()) ==
        first * GiNaC::ex_to<GiNaC::numeric>(ratio.numer()).to_int())
      return halves == 1 ? "half sine" : "full sine";
  }
  return "no sine";
}

Judgement sines(const Printed& printed, int) {
  const std::string u = sine(1, {1, -1, -1}), z = sine(3, {1, -3, 3});
  const bool right = printed.at(0) == u && printed.at(1) == z;
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : fmt::format("U is a {}, Z a {}", u, z),
      {{EvidenceKind::exact,
        fmt::format("the modes (1, -1, -1) at k/L and (1, -3, 3) at 3k/L solve (32) in rationals; heights of "
                    "joints 2 and 3 as sin(m pi/3), sin(2 m pi/3): U a {} (m = 1), Z a {} (m = 2)",
                    u, z)}},
      ""};
}

/// The straight chain beyond its critical force: force and deflection of the U-shape (phi, -phi, -phi).
Judgement beyond(const Printed& printed, int) {
  const proofs::Formulas formulas({"L", "k", "phi"});
  const GiNaC::ex L = formulas.symbol("L"), k = formulas.symbol("k"), phi = formulas.symbol("phi");
  const proofs::SymbolicShape shape{{L, L, L}, {0, k, k}, {phi, -phi, -phi}};
  const GiNaC::ex force = k * phi / (L * sin(phi)), deflection = 3 * L - end_point(shape)(0, 0);
  const GiNaC::matrix torques = proofs::torque_balance(shape, force, 0);
  bool balanced = proofs::identical(deflection, 2 * L * (1 - cos(phi)));
  for (unsigned i = 0; i < 3; ++i) balanced = balanced && proofs::identical(torques(i, 0), 0);
  if (!balanced) throw Error("U-shape", "no equilibrium", "(15)");
  const Interval from(Rational(1, 8)), to(Rational(209, 100));
  const auto grows = certain_sign([](const Interval&x) { return sin(x) - x * cos(x); }, from, to),
             deflects = certain_sign([](const Interval&x) { return sin(x); }, from, to);
  const GiNaC::ex slope = sin(phi) - phi * cos(phi), start = proofs::limit_at_zero(deflection / L, phi),
                  leading = proofs::series_coefficient(slope, phi, proofs::leading_order(slope, phi, 8));
  const bool continuous =
      grows == 1 && deflects == 1 && start.is_zero() && leading.info(GiNaC::info_flags::positive);
  return judge_word(
      printed.at(0), continuous ? "continuously" : "with a jump", "the shape jumps again",
      {Evidence::by_theorem("U of three links",
                            "F = k phi/(L sin phi) and Delta = 2L(1 - cos phi) are analytic and strictly "
                            "increasing for 0 < phi "
                            "< "
                            "2 pi/3: N = sin phi - phi cos phi has N(0) = 0, N' = phi sin phi > 0"),
       {EvidenceKind::symbolic, "(phi, -phi, -phi) satisfies (6) with that force; Delta/L -> " +
                                    proofs::text(start) +
                                    " for phi -> 0, so that the shape does not jump at F_c either"},
       {EvidenceKind::interval, fmt::format("N > 0 on [{}, {}] by subdivision; stable there: u-curve-stable",
                                            from.text(4), to.text(4))}});
}

/// Letters without their side, sorted: the shapes of the equilibria.
Judgement equilibrium_shapes(const Printed& printed, const Premises& given, int) {
  std::set<char> letters;
  for (const auto& one : bent_equilibria(given)) letters.insert(letter(one).front());
  const std::string found(letters.begin(), letters.end());
  return judge_word(printed.at(0), found, "the equilibria have the shapes " + found,
                    {of_straight_chain(given, "signs of both bends: " + found)});
}

}  // namespace

Checks claims::first_figures() {
  return {
      {"fig-2a", straight_in_figure}, {"fig-2b-shape", bent_above},         {"fig-2b-force", shape_depends},
      {"fig-3a-zero", through_zero},  {"fig-3a-spring", resists},           {"fig-3b-minimum", bent_minimum},
      {"fig-5-count", equilibria},    {"fig-5-stable", stable_letters},     {"fig-5-side", which_side},
      {"fig-5b-only", only_stable},   {"fig-5b-name", quasi_straight_name}, {"fig-5-sines", sines},
      {"three-link-beyond", beyond},  {"fig-6-shapes", equilibrium_shapes},
  };
}

}  // namespace plumbline::verify
