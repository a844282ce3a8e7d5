/// \file
/// A check is a function of its premises: claims that a theorem holds stay confirmed for every premise within
/// its hypotheses, claims about one chain change as recomputed.
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <rapidcheck.h>

#include "verify/claims/claims.hpp"
#include "verify/judging/judge.hpp"

using namespace plumbline::verify;

namespace {

/// The verdict on a claim of the paper where one part of one premise is another.
std::string verdict(const std::string& id, const std::string& premise, const std::string& part,
                    const Printed& values) {
  Claim claim = with_id(all_claims(), id).front();
  std::vector<Premise> list = claim.given.list();
  for (Premise& one : list)
    if (one.id == premise) one.parts[part] = values;
  claim.given = Premises(std::move(list));
  const Judged judged = judge({claim}, 10).front();
  return judged.judgement ? std::string(name(judged.judgement->verdict)) : "unjudged: " + judged.problem;
}

Printed in_text(const std::vector<int>& numbers) {
  Printed list;
  for (const int number : numbers) list.push_back(std::to_string(number));
  return list;
}

}  // namespace

TEST_CASE("two links resist monotonically at every angle between 0 and pi") {
  // theorem "Two links": 0 < alpha < pi; a thousandth of pi at either end is left out by the check
  for (const char* const alpha : {"pi/12", "pi/6", "pi/4", "pi/3", "pi/2", "1.234", "2*pi/3", "2.9"}) {
    INFO(alpha);
    CHECK(verdict("curved-monotonic", "fig-3-angle", "value", {alpha}) == "confirmed");
    CHECK(verdict("fig-3a-spring", "fig-3-angle", "value", {alpha}) == "confirmed");
  }
}

TEST_CASE("every straight chain is stable up to its lowest critical force") {
  // theorem "Stable below the lowest force"
  rc::check("of four links of any lengths and stiffnesses", [] {
    const auto numbers = rc::gen::container<std::vector<int>>(4, rc::gen::inRange(1, 12));
    const Printed length = in_text(*numbers), stiffness = in_text(*numbers);
    for (const char* const id : {"straight-until-critical", "buckles-at-lowest"}) {
      RC_ASSERT(verdict(id, "unit-chain", "length", length) == "confirmed");
      RC_ASSERT(verdict(id, "unit-chain", "stiffness", stiffness) == "confirmed");
    }
  });
}

TEST_CASE("the chain of Fig. 8 with other angles, mirrored, in other units") {
  struct Altered {
    const char* id;
    Printed rest;
    const char* verdict;
  };
  // recomputed: a symmetric pair buckles in a pitchfork with equal minima, whichever its angle
  const Printed wide{"0", "pi/9", "-pi/9"}, narrow{"0", "pi/12", "-pi/12"}, mirrored{"0", "-pi/10", "pi/10"},
      asymmetric{"0", "pi/10", "-0.3"};
  for (const Altered& one : std::initializer_list<Altered>{
           {"fig-9-local", wide, "refuted"},
           {"fig-9-keeps", wide, "confirmed"},
           {"fig-8-smooth", wide, "confirmed"},
           {"fig-9-begin", wide, "confirmed"},
           {"fig-9-local", narrow, "refuted"},
           {"fig-9-begin", narrow, "confirmed"},
           {"fig-8-jump", narrow, "refuted"},
           {"fig-9-begin", mirrored, "refuted"},
           {"fig-8-jump", mirrored, "refuted"},
       }) {
    INFO(one.id);
    CHECK(verdict(one.id, "fig-8-chain", "rest", one.rest) == one.verdict);
  }
  // without the symmetry there is no bifurcation to speak of: no verdict, and the reason in one line
  const std::string none = verdict("fig-8-jump", "fig-8-chain", "rest", asymmetric);
  INFO(none);
  CHECK(none.starts_with("unjudged: "));
  CHECK(none.find('\n') == std::string::npos);
  // twice the stiffnesses: other forces, the same shapes
  for (const char* const id : {"fig-8-smooth", "fig-8-stiffness", "fig-9-begin"})
    CHECK(verdict(id, "fig-8-chain", "stiffness", {"0", "2", "2"}) == "confirmed");
}
