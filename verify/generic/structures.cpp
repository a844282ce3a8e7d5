/// \file
/// Chains as chain files state them, with ends, loads and masses: where the straight line loses its
/// stability.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/straight/motion.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "statement/chain_file.hpp"
#include "verify/generic/generic.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

constexpr int digits_of_a_factor = 10;

/// The chain that a premise states as a chain file does.
Structure<Rational> stated_structure(const Parameters& with, const Premise& premise) {
  const auto text = premise.parts.find("chain");
  if (text == premise.parts.end())
    with.wrong("premise " + premise.id + " without a chain file", "its text as `chain`");
  return statement::parse_plane_chain(text->second.front(), "premise " + premise.id).structure;
}

/// Where the straight line loses its stability, as the loads grow.
struct Loss {
  std::string kind;  ///< "buckling", and of a load that follows the chain "flutter" or "divergence"
  Rational low, high;
};

Loss first_loss(const Structure<Rational>& structure) {
  if (!structure.follower()) {
    const auto found = proofs::StraightStructure(structure).enclose(1, digits_of_a_factor).front();
    return {"buckling", found.low, found.high};
  }
  const auto found = proofs::stability_loss(straight_motion(structure), digits_of_a_factor);
  if (!found.first)
    throw Error("chain", "an earlier loss of stability that is not excluded", "a proved first one");
  return {found.kind == proofs::Motion::flutter ? "flutter" : "divergence", found.low, found.high};
}

/// Of each chain.
std::vector<Loss> losses(const Parameters& with, const Premises& given) {
  std::vector<Loss> list;
  for (const std::string& id : with.list("chain"))
    list.push_back(first_loss(stated_structure(with, given.at(id))));
  if (list.empty()) with.wrong("no chain", "one premise or more");
  return list;
}

/// Whether the factors grow along the list, and whether their steps shrink by a fifth or more, as those
/// towards a limit do, or grow.
std::vector<std::string> growth(const Parameters& with, const std::vector<Loss>& list) {
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
  with.known({"chain", "asks"});
  const auto list = losses(with, given);
  std::vector<std::string> factors;
  for (const Loss& one : list)
    factors.push_back(proofs::to_decimal(Rational((one.low + one.high) / 2), digits_of_a_factor - 1));
  const std::string of_all =
      fmt::format("load factors of {}: {}", fmt::join(with.list("chain"), ", "), fmt::join(factors, ", "));
  const std::vector<Evidence> exact{{EvidenceKind::exact, of_all + ", by exact counts"}};
  const std::string asks = with.text("asks", "factor");
  if (asks == "factor") {
    std::vector<Interval> enclosed;
    for (const Loss& one : list) enclosed.push_back(hull(Interval(one.low), Interval(one.high)));
    return judge_decimals(printed, enclosed, with.list("chain"), of_all);
  }
  if (asks == "kind") {
    std::string found = list.front().kind;
    for (const Loss& one : list) found = one.kind == found ? found : "one or another";
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

}  // namespace plumbline::verify
