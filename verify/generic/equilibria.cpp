/// \file
/// All equilibria under a load, by certified censuses.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "verify/generic/structures.hpp"
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

std::string stability(const proofs::CertifiedEquilibrium& one) {
  return one.negative_directions.value() == 0 ? "stable" : "unstable";
}

/// The signs of the joint angles and the stability of each, such as "+- stable".
Printed shapes(const proofs::Census& census, std::size_t from) {
  Printed list;
  for (const auto& one : census.equilibria) list.push_back(signs(one, from) + " " + stability(one));
  return list;
}

/// The signs alone, of all or of those of least energy.
Printed patterns(const proofs::Census& census, std::size_t from, bool least) {
  Printed list;
  for (const auto& one : census.equilibria)
    if (!least || !certainly_less(census.equilibria.front().energy, one.energy))
      list.push_back(signs(one, from));
  return list;
}

/// Of the minima, saddles or maxima of the energy with the end point held.
std::string stability_of(const Parameters& with, const proofs::Census& census, std::size_t directions) {
  const std::string kind = with.text("of");
  std::set<std::string> found;
  for (const auto& one : census.equilibria) {
    const std::size_t negative = one.negative_directions.value();
    const std::string here = negative == 0 ? "minimum" : negative == directions ? "maximum" : "saddle";
    if (here == kind) found.insert(stability(one));
  }
  if (found.empty()) with.wrong("no " + kind, "minimum, saddle or maximum, one that there is");
  return *found.begin();
}

}  // namespace

Judgement generic::equilibria(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "links", "deflection", "end", "compression", "factor", "asks", "of", "from joint",
              "sign of q4"});
  if (given.has_structure(with.text("chain"))) return equilibria_of_structure(with, printed, given);
  const Premise premise = chain_with_links(with, given);
  const HeldChain chain = held_chain(premise);
  const auto [census, load] = loaded(with, given, chain);
  if (!census.complete()) with.wrong("undecided boxes", "a regular load");
  const std::string types = verify::types(census), asks = with.text("asks", "types");
  const std::vector<Evidence> evidence{
      {EvidenceKind::interval,
       fmt::format("certified census of the chain {}, {} boxes: {}", load, census.boxes, types)}};
  const auto stated = [&](Judgement judgement, const std::string& has) {
    judgement.subject = in_words(premise);
    judgement.statement = fmt::format("has, {}, {}", load, has);
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
                  fmt::format("{} equilibria with the symmetry: {}", count, found));
  }
  if (asks == "stability") {
    const std::string kind = with.text("of"), found = stability_of(with, census, chain.chain.size() - 2);
    return judge_word(printed.at(0), found, fmt::format("a {} is {}", kind, found), evidence);
  }
  const std::size_t from = std::stoul(with.text("from joint", "1")) - 1;
  if (asks == "shapes" || asks == "signs" || asks == "least energy") {
    const Printed found = asks == "shapes" ? shapes(census, from) : patterns(census, from, asks != "signs");
    const std::string list = fmt::format("{}", fmt::join(found, ", "));
    return stated(judge_rows(printed, found, 1, "they are " + list, evidence), "the equilibria " + list);
  }
  with.wrong("asks = '" + asks + "'",
             "types, kinds, count, more than, symmetry, stability, shapes, signs or least energy");
}

}  // namespace plumbline::verify
