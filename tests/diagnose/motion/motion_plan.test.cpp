#include "diagnose/motion/motion_plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "diagnose/motion/course.hpp"
#include "diagnose/motion/motion_plan_report.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

Bench bench_of(const std::vector<Course>& courses, double gravity = 0.59) {
  Bench bench;
  bench.name = "planned";
  bench.nominal = planted_drive(Term::command_delay, 0);
  bench.sigma = 5e-4;
  for (const Course& course : courses) {
    MotionLog log = commanded(course, 6, 100, 12);
    log.gain = 1.28, log.inertia = 0.0072, log.gravity = gravity;
    log.position = log.command;
    bench.logs.push_back(std::move(log));
  }
  return bench;
}

bool has(const std::vector<std::string>& list, const std::string& id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

/// Whether two effects are in one class of a plan.
bool are_alike(const MotionPlan& plan, const std::string& a, const std::string& b) {
  return std::any_of(plan.indistinguishable.begin(), plan.indistinguishable.end(),
                     [&](const AlikeEffects& one) {
                       const bool in_a = has(one.effects, a), in_b = has(one.effects, b);
                       return (in_a && in_b) || (in_a && has(one.others, b)) || (in_b && has(one.others, a));
                     });
}

}  // namespace

TEST_CASE("without a weight no motion shows the encoder's zero, and beside one a ramp does") {
  CHECK(has(plan_of(bench_of({ramp(0.7, 6)}, 0)).undetectable, "encoder_zero"));
  CHECK(!has(plan_of(bench_of({ramp(0.7, 6)})).undetectable, "encoder_zero"));
}

TEST_CASE("a joint that is moved slowly shows no inertia, and a fast one does") {
  CHECK(has(plan_of(bench_of({ramp(0.2, 6)})).undetectable, "armature"));
  CHECK(!has(plan_of(bench_of({sine(0.5, 2)})).undetectable, "armature"));
}

TEST_CASE("back EMF and viscous friction are one class of any motions, exactly, while the drive is on") {
  const MotionPlan plan = plan_of(bench_of({sine(0.5, 1), sweep(0.4, 4, 6), ramp(0.7, 6)}));
  INFO(as_text(plan));
  CHECK(are_alike(plan, "back_emf", "viscous_friction"));
  CHECK(as_json(plan)["indistinguishable"].size() == plan.indistinguishable.size());
}

TEST_CASE("at one speed a delay is viscous friction, and a second motion tells them apart") {
  const MotionPlan slow = plan_of(bench_of({ramp(0.7, 6)})),
                   both = plan_of(bench_of({ramp(0.7, 6), sweep(0.5, 4, 6)}));
  INFO(as_text(slow));
  INFO(as_text(both));
  CHECK(slow.separated < both.separated);
  CHECK(!are_alike(both, "command_delay", "viscous_friction"));
  CHECK(both.fewest.size() <= 2);
}

}  // namespace plumbline::motion
