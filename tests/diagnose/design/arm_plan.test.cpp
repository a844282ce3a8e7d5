/// Planning poses of an arm in space, before any data.
#include <algorithm>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/design/plan.hpp"
#include "tests/diagnose/arms.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::string planned_arm = R"(format = "chain-experiment/1"
name = "two axes"
[arm]
tip_xyz = [0.3, 0.02, 0]
[[arm.joint]]
name = "shoulder"
xyz = [0, 0, 0.4]
mass = 2
centre = [0.1, 0, 0]
limits = [-1.5, 1.5]
[[arm.joint]]
name = "elbow"
xyz = [0.25, 0, 0]
axis = [0, 1, 0]
stiffness = 2000
limits = [-1.5, 1.5]
[noise]
place = 3e-5
[[run]]
id = "poses"
samples = "poses.csv"
)";
/// Commands and weights alone.
const std::string planned_poses =
    "q_command1,q_command2,weight\n0,0.2,0\n0.5,0.4,0\n-0.4,-0.3,0\n0.9,0.1,3\n-0.8,0.7,3\n0.2,-0.6,3\n";

Experiment planned(const std::string& settings = planned_arm) {
  return read_plan("arm", [&](const std::string& name, const std::string&) {
    return name == "experiment.toml" ? settings : planned_poses;
  });
}

bool are_alike(const Plan& plan, const EffectAt& a, const EffectAt& b) {
  const auto& classes = plan.unidentifiable.indistinguishable;
  return std::any_of(classes.begin(), classes.end(), [&](const Indistinguishable& one) {
    const auto has = [&](const EffectAt& at) {
      return std::find(one.effects.begin(), one.effects.end(), at) != one.effects.end();
    };
    return one.exactly && has(a) && has(b);
  });
}

}  // namespace

TEST_CASE("commands and loads are a plan of an arm; what has a noise is measured") {
  const Experiment bench = planned();
  const Reading& first = bench.runs.at(0).readings.at(0);
  for (const Channel& one : bench.runs.front().measurable()) CHECK(std::isnan(one.of(first)));
}

TEST_CASE(
    "a plan of an arm names the errors of geometry that no pose tells apart, and poses that tell the rest") {
  const Plan found = plan(planned());
  // The first axis is upright: to shift it, or to turn about it, is to move the frame of the tracker.
  CHECK(are_alike(found, {"axis_shift", 1}, {"position_offset"}));
  CHECK(std::find(found.impossible.begin(), found.impossible.end(), EffectAt("angle_bias", 1)) !=
        found.impossible.end());
  CHECK(found.separated > 0);
  REQUIRE_FALSE(found.fewest.empty());
  CHECK(found.fewest.size() < found.candidates);
  REQUIRE(found.planned);
}

TEST_CASE("a plan of an arm that measures nothing is refused") {
  std::string settings = planned_arm;
  settings.replace(settings.find("place = 3e-5"), 12, "");
  CHECK_THROWS_WITH_AS(
      planned(settings),
      "noise: found no figure for anything that run \"poses\" measures, expected a positive one for "
      "q, place, turn or torque",
      Error);
}
