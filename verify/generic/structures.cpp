/// \file
/// Chains as chain files state them, with ends, loads and masses: where the straight line loses its
/// stability.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/census/structure_census.hpp"
#include "proofs/exact/decimal.hpp"
#include "verify/chains/loss_of_stability.hpp"
#include "verify/generic/structures.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

constexpr int digits_of_a_factor = 10;

/// The load factor of a check, which grows from 0. \throws Error for a negative one
Rational factor_of(const Parameters& with, const Premises& given, const char* name) {
  Rational factor = exact_quantity(with.text(name), given);
  if (factor < 0) with.wrong("the load factor " + with.text(name), "one that is not negative");
  return factor;
}

/// Of each chain, or of the rods that they stand for.
std::vector<LossOfStability> losses(const Parameters& with, const Premises& given) {
  const std::string of = with.text("of", "chain");
  if (of != "chain" && of != "rod") with.wrong("of = '" + of + "'", "chain or rod");
  std::vector<LossOfStability> list;
  for (const std::string& id : with.list("chain")) {
    const statement::PlaneChain chain = given.stated(id);
    list.push_back(of == "rod" ? loss_of_rod(chain) : loss_of_stability(chain.structure));
  }
  if (list.empty()) with.wrong("no chain", "one premise or more");
  return list;
}

/// Whether the factors grow along the list, and whether their steps shrink by a fifth or more, as those
/// towards a limit do, or grow.
std::vector<std::string> growth(const Parameters& with, const std::vector<LossOfStability>& list) {
  if (list.size() < 4) with.wrong(fmt::format("{} chains", list.size()), "four or more");
  bool grows = true, shrink = true, swell = true;
  for (std::size_t i = 1; i < list.size(); ++i) {
    grows = grows && list[i - 1].high < list[i].low;
    if (i < 2) continue;
    const Rational step = list[i].high - list[i - 1].low, before = list[i - 1].low - list[i - 2].high;
    shrink = shrink && 5 * step < 4 * before;
    swell = swell && list[i].low - list[i - 1].high > list[i - 1].high - list[i - 2].low;
  }
  if (!shrink && !swell) with.wrong("factors that neither settle nor swell", "chains that show which");
  return {grows ? "increasing" : "not increasing", shrink ? "bounded" : "unbounded"};
}

}  // namespace

Judgement generic::critical(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "of", "asks"});
  const auto list = losses(with, given);
  std::vector<std::string> factors;
  for (const LossOfStability& one : list)
    factors.push_back(proofs::to_decimal(Rational((one.low + one.high) / 2), digits_of_a_factor - 1));
  const std::string of_all =
      fmt::format("load factors of {}: {}", fmt::join(with.list("chain"), ", "), fmt::join(factors, ", "));
  const std::vector<Evidence> exact{{EvidenceKind::exact, of_all + ", by exact counts"}};
  const std::string asks = with.text("asks", "factor");
  if (asks == "factor") {
    std::vector<Interval> enclosed;
    for (const LossOfStability& one : list) enclosed.push_back(hull(Interval(one.low), Interval(one.high)));
    return judge_decimals(printed, enclosed, with.list("chain"), of_all);
  }
  if (asks == "kind") {
    std::string found = list.front().kind;
    for (const LossOfStability& one : list) found = one.kind == found ? found : "one or another";
    return judge_word(printed.at(0), found, "what sets in is " + found, exact);
  }
  if (asks == "least") {
    const bool least = std::all_of(list.begin() + 1, list.end(),
                                   [&](const auto& one) { return list.front().high < one.low; });
    return judge_word(printed.at(0), least ? "least" : "not least", of_all, {Evidence::at_points(of_all)});
  }
  if (asks == "growth") {
    const std::vector<std::string> found = growth(with, list);
    Judgement result =
        judge_list(printed, found, fmt::format("the load is {} and {}: {}", found[0], found[1], of_all),
                   {Evidence::at_points(of_all)});
    if (result.verdict == Verdict::refuted && printed.at(0) == found[0]) result.verdict = Verdict::imprecise;
    return result;
  }
  with.wrong("asks = '" + asks + "'", "factor, kind, least or growth");
}

Judgement generic::stability_of_structure(const Parameters& with, const Printed& printed,
                                          const Premises& given) {
  const Rational factor = factor_of(with, given, "force");
  const LossOfStability loss = loss_of_stability(given.stated(with.text("chain")).structure);
  if (factor >= loss.low && factor <= loss.high)
    with.wrong("the load factor at which the stability is lost", "one below or above");
  const std::string found = factor < loss.low ? "stable" : "unstable";
  if (factor > loss.high && loss.kind != "buckling")
    with.wrong("a load factor above that of " + loss.kind,
               "one below: stability can come back under a follower");
  return judge_word(
      printed.at(0), found, fmt::format("the straight chain is {} under {}", found, with.text("force")),
      {{EvidenceKind::exact,
        fmt::format("by exact counts it is stable up to the load factor {}, where it is lost by {}",
                    proofs::to_decimal(loss.low, digits_of_a_factor - 1), loss.kind)}});
}

Judgement generic::equilibria_of_structure(const Parameters& with, const Printed& printed,
                                           const Premises& given) {
  const Rational factor = exact_quantity(with.text("factor"), given);
  const auto census = proofs::take_census(given.stated(with.text("chain")).structure, factor, 0);
  if (!census.complete()) with.wrong("undecided boxes", "a regular load");
  Counts counts;
  for (const auto& one : census.equilibria) {
    if (!one.negative_directions) with.wrong("an equilibrium whose stability is open", "a regular load");
    counts.add(*one.negative_directions == 0 ? "stable" : "unstable");
  }
  const std::string types = counts.text(), asks = with.text("asks", "types");
  const std::vector<Evidence> evidence{
      {EvidenceKind::interval,
       fmt::format("certified census under the load factor {}, each joint within half a turn of its rest, {} "
                   "boxes: {}",
                   with.text("factor"), census.boxes, types)}};
  if (asks == "types") return judge_counts(printed.at(0), types, "there are " + types, evidence);
  const std::string count = std::to_string(census.equilibria.size());
  if (asks == "count") return judge_word(printed.at(0), count, "there are " + count, evidence);
  with.wrong("asks = '" + asks + "'", "types or count, of a chain file with ends or loads of its own");
}

}  // namespace plumbline::verify
