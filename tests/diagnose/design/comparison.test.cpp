#include "diagnose/design/comparison.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "diagnose/bench/unmeasured.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A press there and back of three links, with effects of these sizes.
DesignSpace rehearsed(std::vector<Instance> effects) {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.06, 0}, 10, true);
  const Experiment empty = unmeasured(bench);
  const Study study(empty);
  DesignSpace all;
  all.bench = measured_as(empty, simulate(empty, study.nominal_rig(), {}));
  all.descriptions = {"press"};
  all.effects = std::move(effects);
  return all;
}

}  // namespace

TEST_CASE("an effect competes with effects of at most one more parameter; the smaller distance counts") {
  // of one value, of two, and of six
  const DesignSpace all = rehearsed({{only("force_gain"), {0.2}},
                                     {only("force_bias"), {1, -0.8}},
                                     {only("hysteresis"), {0.5, 0.02, 0.3, 0.05, 0.2, 0.1}}});
  const Comparison effects(all, {});
  const std::vector<Contrast> both = effects.between(0, 1);
  REQUIRE(both.size() == 2);
  CHECK(effects.distinguishability(0, 1, {0}) ==
        std::min(expected_log_likelihood_ratio(both[0], {0}), expected_log_likelihood_ratio(both[1], {0})));
  CHECK(effects.distinguishability(1, 0, {0}) == effects.distinguishability(0, 1, {0}));
  CHECK(effects.distinguishability(0, 1, {0}) > 1);
  CHECK(effects.distinguishability(0, 1, {}) == 0);
  // Six values imitate neither one nor two; one or two may yet imitate six.
  CHECK(effects.between(0, 2).size() == 1);
  CHECK(effects.between(1, 2).size() == 1);
}

TEST_CASE("an effect does not compete with its nested case, but the nested case with it") {
  const DesignSpace all = rehearsed({{only("joint_friction"), {0.05}}, {only("load_friction"), {0.02, 10}}});
  const Comparison effects(all, {});
  CHECK(effects.between(0, 1).size() == 1);
  // Friction that does not grow is one that grows by nothing: imitated by it there would be no lead.
  CHECK(effects.distinguishability(0, 1, {0}) > 1);
}
