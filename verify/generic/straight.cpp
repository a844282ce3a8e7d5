/// \file
/// Straight chains: critical forces, modes, stability.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <plumbline/base/error.hpp>
#include <plumbline/straight/critical_force.hpp>
#include <sstream>

#include "proofs/exact/enclosure.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/chains/straight_modes.hpp"
#include "verify/generic/structures.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

/// "F 1", "lambda 1", "factor 1", "Fy 1" of a mode from 1 on, "q 1 2" of its second joint; the two
/// eigenvalues behind those of the modes are zero.
Interval of_mode(const Parameters& with, const std::vector<CertifiedMode>& modes, const std::string& name) {
  std::istringstream words(name);
  std::string what;
  std::size_t mode = 0, joint = 1;
  words >> what >> mode;
  if (what == "q") words >> joint;
  if (what == "lambda" && (mode == modes.size() + 1 || mode == modes.size() + 2)) return Interval(0);
  if (!words || mode == 0 || mode > modes.size() || joint == 0 || joint > modes[mode - 1].q.size())
    with.wrong("'" + name + "'", "a number of a mode, such as F 1, lambda 1, factor 1, Fy 1 or q 1 2");
  const CertifiedMode& one = modes[mode - 1];
  if (what == "F") return one.force;
  if (what == "lambda") return one.lambda;
  if (what == "factor") return one.factor;
  if (what == "Fy") return one.fy;
  if (what == "q") return one.q[joint - 1];
  with.wrong("'" + name + "'", "F, lambda, factor, Fy or q");
}

bool of_vector(const std::string& name) {
  return name.starts_with("q ") || name.starts_with("Fy ");
}

}  // namespace

Judgement generic::modes(const Parameters& with, const Printed& printed, const Premises& given, int digits) {
  with.known({"chain", "links", "of", "sign"});
  const Premise chain = chain_with_links(with, given);
  const auto& all = certified_modes(exact_chain(chain));
  const Printed of = with.list("of");
  // an eigenvector has either sign: that of its first component that is printed
  bool turned = false;
  for (std::size_t i = of.size(); i-- > 0;) {
    if (i < printed.size() && of_vector(of[i]) && with.text("sign", "free") == "free")
      turned = printed[i].starts_with('-') == certainly_positive(of_mode(with, all, of[i]));
  }
  std::vector<Interval> computed;
  std::vector<std::string> names, values;
  for (const std::string& name : of) {
    const Interval number = of_mode(with, all, name);
    computed.push_back(turned && of_vector(name) ? -number : number);
    names.push_back(with_index(name));
    values.push_back(certified_decimal(computed.back(), digits));
  }
  Judgement result = judge_decimals(
      printed, computed, names,
      "counts of critical forces by exact recursion bound each F to 60 digits; the rest of the "
      "mode from it in intervals");
  result.value = fmt::format("{}", fmt::join(values, "; "));
  result.subject = in_words(chain);
  for (std::size_t i = 0; i < of.size() && result.verdict == Verdict::confirmed; ++i)
    result.statement += fmt::format("{} {} = {}", i == 0 ? "has" : ",", names[i], printed[i]);
  return result;
}

/// On which side of its critical force the bent shapes of a mode begin.
Judgement generic::post_buckling(const Parameters& with, const Printed& printed, const Premises& given,
                                 int digits) {
  with.known({"chain", "links", "mode"});
  const Premise chain = chain_with_links(with, given);
  const auto& modes = certified_modes(exact_chain(chain));
  const std::size_t number = std::stoul(with.text("mode"));
  if (number == 0 || number > modes.size()) with.wrong("mode " + with.text("mode"), "one of the chain's");
  const CertifiedMode& mode = modes[number - 1];
  const Interval curvature =
      post_buckling_curvature(Premises({chain}).chain(chain.id), Mode<Interval>{mode.force, mode.q, mode.fy});
  if (curvature.contains_zero()) with.wrong("a curvature whose sign is open", "one that is not zero");
  const std::string found = certainly_positive(curvature) ? "supercritical" : "subcritical";
  return judge_word(
      printed.at(0), found, fmt::format("the bent shapes are {}", found),
      {Evidence::by_theorem("Supercritical", "F = F_m + F_2 a^2 + … along the bent shapes of a mode"),
       {EvidenceKind::interval, fmt::format("{}, mode {}, |v| = 1: F_2 = {}", in_words(chain), number,
                                            certified_decimal(curvature, std::min(digits, 10)))}});
}

Judgement generic::closed_form(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "links", "modes"});
  const Printed links = with.list("links");
  if (links.size() != 2) with.wrong("links", "the fewest and the most");
  static const proofs::Formulas names({"n", "m", "L", "l", "k", "pi"});
  const GiNaC::ex formula = names.parse(with_fractions(printed.at(0)));
  const Premise pattern = given.guided(with.text("chain"));
  constexpr int digits = 40;
  std::size_t tried = 0;
  std::string first_wrong;
  for (std::size_t n = std::stoul(links[0]); n <= std::stoul(links[1]); ++n) {
    const Chain<Rational> chain = exact_chain(with_links(pattern, n));
    const std::size_t modes = with.text("modes", "all") == "all" ? n - 1 : std::stoul(with.text("modes"));
    const auto forces = proofs::enclose_critical_forces(chain, std::min(modes, n - 1), digits);
    Rational whole = 0;
    for (const Rational& length : chain.length()) whole += length;
    for (const proofs::ForceEnclosure& force : forces) {
      const Interval stated = value_of(formula, {{"n", Interval(Rational(static_cast<int>(n)))},
                                                 {"m", Interval(Rational(static_cast<int>(force.index)))},
                                                 {"l", Interval(chain.length().back())},
                                                 {"L", Interval(whole)},
                                                 {"k", Interval(chain.stiffness().back())},
                                                 {"pi", Interval::pi()}});
      const Interval found = hull(Interval(force.low), Interval(force.high));
      ++tried;
      if (first_wrong.empty() && !intersection(stated, found))
        first_wrong = fmt::format("F_{} of {} links is {}, not {}", force.index, n,
                                  certified_decimal(found, 10), certified_decimal(stated, 10));
    }
  }
  return {
      first_wrong.empty() ? Verdict::confirmed : Verdict::refuted,
      first_wrong,
      {{EvidenceKind::interval,
        fmt::format("{} to {} links, {} critical forces, each enclosed to {} digits by exact counts: the "
                    "formula lies in {}",
                    links[0], links[1], tried, digits, first_wrong.empty() ? "every one" : "not every one")}},
      ""};
}

Judgement generic::stability(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "links", "force"});
  if (given.has_structure(with.text("chain"))) return stability_of_structure(with, printed, given);
  const Chain<Rational> chain = exact_chain(chain_with_links(with, given));
  const Rational force = exact_quantity(with.text("force"), given);
  const std::size_t below = count_below(chain, force);
  const std::string found = below == 0 ? "stable" : "unstable";
  return judge_word(
      printed.at(0), found, fmt::format("the straight chain is {} under {}", found, with.text("force")),
      {Evidence::by_checked_theorem("Stable below the lowest force",
                                    {"stability.stable_exactly_below", "stability.unstable_above"},
                                    "stable exactly below the lowest critical force"),
       {EvidenceKind::exact, fmt::format("critical forces below {}, by the recursion in fractions: {}",
                                         with.text("force"), below)}});
}

}  // namespace plumbline::verify
