#include "diagnose/inference/search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "diagnose/answers/heldout.hpp"
#include "diagnose/bench/condense.hpp"
#include "diagnose/bench/read_experiment.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

bool has(const Candidate& whole, const EffectAt& at) {
  return std::find(whole.effects.begin(), whole.effects.end(), at) != whole.effects.end();
}

bool within(const Candidate& part, const Candidate& whole) {
  return part.effects.size() < whole.effects.size() &&
         std::all_of(part.effects.begin(), part.effects.end(),
                     [&](const EffectAt& at) { return has(whole, at); });
}

/// Whether all that the whole has beside the part is held by tolerances, which can be nothing.
bool tolerated_beside(const Study& study, const Candidate& part, const Candidate& whole) {
  return std::all_of(whole.effects.begin(), whole.effects.end(), [&](const EffectAt& at) {
    return has(part, at) || study.ranges(at).front().tolerance > 0;
  });
}

}  // namespace

TEST_CASE("no explanation costs more than a part of it, where the rest can be nothing" *
          doctest::test_suite("long")) {
  const std::string experiments = PLUMBLINE_SOURCE_DIR "/tests/experiments/";
  for (const char* name : {"machining-base_compliance", "machining", "link_length-tip_stiffness"}) {
    CAPTURE(name);
    const Experiment experiment = condensed(read_experiment(experiments + name));
    const Study study(without(experiment, choose_heldout(experiment)));
    const Findings findings = search(study);
    std::size_t compared = 0;
    for (const Hypothesis& whole : findings.hypotheses)
      for (const Hypothesis& part : findings.hypotheses) {
        const Candidate &larger = whole.fit.candidate, &smaller = part.fit.candidate;
        if (!within(smaller, larger) || !tolerated_beside(study, smaller, larger)) continue;
        ++compared;
        CHECK(whole.fit.cost < part.fit.cost + 1);  // of a cost of some hundred: where iterations end
      }
    CHECK(compared > 3);
  }
}
