/// \file
/// All equilibria under a load, by certified censuses.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verify/generic/quantities.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

/// Where or under which force, in words.
struct Load {
  proofs::Census census;
  std::string said;
};

Load loaded(const Parameters& with, const Premises& given, const HeldChain& chain) {
  if (with.has("deflection")) {
    const std::string at = with.text("deflection");
    return {chain.at(quantity(at, given)), "held at the deflection " + at};
  }
  if (with.has("end")) {
    const Printed end = with.list("end");
    if (end.size() != 2) with.wrong("end", "x and y");
    return {proofs::census_at_end_point(chain.chain, {quantity(end[0], given), quantity(end[1], given)}),
            fmt::format("held at ({}, {})", end[0], end[1])};
  }
  if (!with.has("compression")) with.wrong("no load", "deflection, end or compression");
  const std::string force = with.text("compression");
  return {proofs::census_under_force(chain.chain, {-quantity(force, given), Interval(0)}),
          "under the compression " + force};
}

/// The orientations of the links.
std::vector<Interval> orientations_of(const proofs::CertifiedEquilibrium& one) {
  std::vector<Interval> theta;
  Interval sum(0);
  for (const Interval& q : one.q) theta.push_back(sum += q);
  return theta;
}

/// Whether every equilibrium becomes another, or itself, where its orientations are changed: one of the
/// census may be it, up to full turns of a link, and no other one is.
template <class Change>
bool maps_onto_itself(const proofs::Census& census, const Change& change) {
  return std::all_of(census.equilibria.begin(), census.equilibria.end(), [&](const auto& one) {
    const std::vector<Interval> image = change(orientations_of(one));
    return std::any_of(census.equilibria.begin(), census.equilibria.end(), [&](const auto& other) {
      const std::vector<Interval> theta = orientations_of(other);
      for (std::size_t i = 0; i < theta.size(); ++i)
        if (!sin((theta[i] - image[i]) / Interval(2)).contains_zero()) return false;
      return true;
    });
  });
}

/// What carries the equilibria into each other: "half turn", which reads the links backwards, "mirror".
std::string symmetry(const proofs::Census& census) {
  const bool turned = maps_onto_itself(census, [](std::vector<Interval> theta) {
    std::reverse(theta.begin(), theta.end());
    return theta;
  });
  const bool mirrored = maps_onto_itself(census, [](std::vector<Interval> theta) {
    for (Interval& angle : theta) angle = -angle;
    return theta;
  });
  return turned && mirrored ? "half turn and mirror" : turned ? "half turn" : mirrored ? "mirror" : "neither";
}

/// The signs of the joint angles and the stability of each, such as "+- stable".
Printed shapes(const proofs::Census& census, std::size_t from) {
  Printed list;
  for (const auto& one : census.equilibria)
    list.push_back(signs(one, from) + (one.negative_directions.value() == 0 ? " stable" : " unstable"));
  return list;
}

}  // namespace

Judgement generic::equilibria(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "links", "deflection", "end", "compression", "asks", "from joint", "sign of q4"});
  const Premise premise = chain_with_links(with, given);
  const HeldChain chain = held_chain(premise);
  const auto [census, load] = loaded(with, given, chain);
  if (!census.complete()) with.wrong("undecided boxes", "a regular load");
  const std::string types = verify::types(census), asks = with.text("asks", "types");
  const std::vector<Evidence> evidence{
      {EvidenceKind::interval,
       fmt::format("certified census of the chain {}, {} boxes: {}", load, census.boxes, types)}};
  const auto stated = [&](Judgement judgement, const std::string& has) {
    judgement.statement = fmt::format("{}, {}, has {}", in_words(premise), load, has);
    return judgement;
  };
  const auto there_are = [](const std::string& what) { return "there are " + what; };
  if (asks == "types")
    return stated(judge_counts(printed.at(0), types, there_are(types), evidence), types + " equilibria");
  if (asks == "kinds") {
    const std::string found = extrema(census, std::stoi(with.text("sign of q4", "0")));
    return stated(judge_counts(printed.at(0), found, there_are(found), evidence), found);
  }
  const std::string count = std::to_string(census.equilibria.size());
  if (asks == "count")
    return stated(judge_word(printed.at(0), count, there_are(count), evidence), count + " equilibria");
  if (asks == "more than") {
    const bool more = census.equilibria.size() > std::stoul(printed.at(0));
    return stated({more ? Verdict::confirmed : Verdict::refuted, more ? "" : there_are(count), evidence, ""},
                  count + " equilibria");
  }
  if (asks == "symmetry") {
    const std::string found = symmetry(census);
    return stated(judge_word(printed.at(0), found, "they are carried into each other by: " + found, evidence),
                  fmt::format("{} equilibria, which are carried into each other by: {}", count, found));
  }
  if (asks == "shapes") {
    const Printed found = shapes(census, std::stoul(with.text("from joint", "1")) - 1);
    const std::string list = fmt::format("{}", fmt::join(found, ", "));
    return stated(judge_rows(printed, found, 1, "they are " + list, evidence), "the equilibria " + list);
  }
  with.wrong("asks = '" + asks + "'", "types, kinds, count, more than, symmetry or shapes");
}

}  // namespace plumbline::verify
