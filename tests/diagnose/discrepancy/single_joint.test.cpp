#include "diagnose/discrepancy/single_joint.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/decision/verdict.hpp"
#include "diagnose/noise/gap.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A sprung link that another one, on a pin, pushes to either side and lets come back.
Experiment strut() {
  Experiment experiment;
  experiment.name = "strut";
  experiment.link_length = {0.2, 0.25};
  experiment.joint_stiffness = {3.0, 0};
  experiment.link_mass = {0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, true};
  experiment.noise = {1e-4, 1e-4, 0.01, 0.01, 0};
  press(experiment, {1.2, -1.5}, {-0.08, 0}, 40, true);
  press(experiment, {1.2, -1.5}, {0.07, 0}, 40, true);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  return experiment;
}

/// Readings with a ripple of this size, N, over the way: something of its own that every device has.
void ripple(Experiment& experiment, double size) {
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.Fx += size * std::sin(300 * reading.x);
}

const Candidate law_of_joint{
    {"nonlinear_spring", {"hysteresis", 1}, {"joint_stiffness", 1}, {"rest_angle", 1}}};
const std::vector<double> of_law{3, 0.25, 0.03, 0.2, 0.1, 0, 0.2, 0.35, 0.04};

/// The verdict of a search that found nothing.
Cause nothing_found() {
  Cause cause;
  cause.verdict = CauseVerdict::unknown;
  cause.unknown = 1;
  return cause;
}

NoiseModel noise_of(const Study& study) {
  return test_gap(study.measurements(), study.nominal_residual()).noise;
}

bool has(const Candidate& candidate, const char* id) {
  return std::any_of(candidate.effects.begin(), candidate.effects.end(),
                     [&](const EffectAt& at) { return at.effect->id == id; });
}

/// What a class lists, its best first.
std::vector<Candidate> listed(const Cause& cause) {
  std::vector<Candidate> all{cause.ranking[cause.best].hypothesis.fit.candidate};
  for (const std::size_t place : cause.equivalent)
    all.push_back(cause.ranking[place].hypothesis.fit.candidate);
  return all;
}

}  // namespace

TEST_CASE("shape and memory of a single joint are named though its spring was a guess and it has a ripple") {
  Experiment experiment = measured(strut(), law_of_joint, of_law, 5);
  ripple(experiment, 0.15);
  const Study study(experiment);
  Cause cause = nothing_found();
  const std::optional<NamedLaw> named = name_single_joint(study, noise_of(study), cause);
  REQUIRE(named);
  CHECK(cause.verdict == CauseVerdict::ambiguous);
  CHECK(cause.reservation == Reservation::single_joint);
  CHECK(named->shrink.ratio < beliefs::closed);
  const double gap = rms_by_name(study.measurements(), study.nominal_residual())[2];
  CHECK(named->allowed.of({Channel::Name::Fx}) ==
        doctest::Approx(beliefs::tolerated_share * gap).epsilon(0.01));
  CHECK(named->shrink.ratio > named->shrink.noise_floor_ratio);
  const std::vector<Candidate> all = listed(cause);
  CHECK(std::any_of(all.begin(), all.end(), [](const Candidate& one) {
    return has(one, "nonlinear_spring") && has(one, "hysteresis") && has(one, "joint_stiffness");
  }));
  CHECK(std::none_of(all.begin(), all.end(), [](const Candidate& one) { return has(one, "backlash"); }));
  double sum = cause.unknown;
  for (const Ranked& one : cause.ranking) sum += one.probability;
  CHECK(sum == doctest::Approx(1));
}

TEST_CASE("a spring that gives way is named as one, and not as one that softens little by little") {
  const Candidate gives{{{"piecewise_spring", 1}, {"joint_stiffness", 1}}};
  Experiment experiment = measured(strut(), gives, {0.15, 0.6, 0.3}, 12);
  ripple(experiment, 0.1);
  const Study study(experiment);
  Cause cause = nothing_found();
  REQUIRE(name_single_joint(study, noise_of(study), cause));
  for (const Candidate& one : listed(cause)) CHECK(has(one, "piecewise_spring"));
}

TEST_CASE("a value of the nominal spring that is right is not named beside the law") {
  std::vector<double> right_spring = of_law;
  right_spring[7] = right_spring[8] = 0;
  Experiment experiment = measured(strut(), law_of_joint, right_spring, 6);
  ripple(experiment, 0.15);
  const Study study(experiment);
  Cause cause = nothing_found();
  REQUIRE(name_single_joint(study, noise_of(study), cause));
  CHECK_FALSE(has(listed(cause).front(), "rest_angle"));
}

TEST_CASE("what no shape of a spring draws stays unknown") {
  Experiment experiment = measured(strut(), {}, {}, 7);
  ripple(experiment, 1);
  const Study study(experiment);
  Cause cause = nothing_found();
  CHECK_FALSE(name_single_joint(study, noise_of(study), cause));
  CHECK(cause.verdict == CauseVerdict::unknown);
}

TEST_CASE("nothing is named of several sprung joints, nor where a cause is") {
  Experiment two = strut();
  two.joint_stiffness[1] = 2;
  const Study several(measured(two, {{"nonlinear_spring"}}, {3}, 8));
  Cause cause = nothing_found();
  CHECK_FALSE(name_single_joint(several, noise_of(several), cause));
  const Study one(measured(strut(), law_of_joint, of_law, 9));
  Cause known = nothing_found();
  known.verdict = CauseVerdict::identified;
  CHECK_FALSE(name_single_joint(one, noise_of(one), known));
}

TEST_CASE("what machining leaves of a single joint stands beside its cause") {
  const Candidate truth{
      {"joint_friction", {"joint_stiffness", 1}, {"rest_angle", 1}, {"link_length", 1}, {"link_length", 2}}};
  const Study study(measured(strut(), truth, {0.04, 0.04, -0.008, 0.004, -0.004}, 10));
  const Cause cause = judge(study, search(study));
  REQUIRE(cause.verdict != CauseVerdict::unknown);
  const Candidate& best = cause.ranking[cause.best].hypothesis.fit.candidate;
  CHECK(best.has_all_tolerances());
  CHECK(has(best, "joint_friction"));
  CHECK(best.count() == 2);
}
