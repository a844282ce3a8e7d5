#include "diagnose/motion/diagnosis.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <set>
#include <string>

#include "diagnose/motion/report.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

/// A bench whose model states the drive of the tests, where another one moves.
Study study_of(const Drive<double>& moves) {
  Bench bench;
  bench.name = "planted";
  bench.nominal = planted_drive(Term::command_delay, 0);
  bench.sigma = 5e-4;
  unsigned seed = 1;
  for (const double gain : {4.0, 8.0, 16.0}) bench.logs.push_back(test_log(moves, gain, bench.sigma, seed++));
  bench.held_out.push_back(test_log(moves, 6, bench.sigma, seed));
  return Study(bench);
}

Study study_of(Term term, double value) {
  return study_of(planted_drive(term, value));
}

std::set<std::string> first_named(const Diagnosis& diagnosis) {
  std::set<std::string> effects;
  if (!diagnosis.causes.empty())
    for (const NamedEffect& one : diagnosis.causes.front().effects) effects.insert(one.id);
  return effects;
}

}  // namespace

TEST_SUITE_BEGIN("long");

TEST_CASE("what is planted is named, and its size lies in the interval or within a fiftieth") {
  const struct {
    Term term;
    double value;
    const char* id;
  } planted[] = {{Term::command_delay, 0.03, "command_delay"},
                 {Term::load_mass, 0.2, "load_mass"},
                 {Term::dry, 0.05, "joint_friction"},
                 {Term::armature, 0.004, "armature"},
                 {Term::duty_missing, 0.7, "duty_limit"}};
  for (const auto& [term, value, id] : planted) {
    CAPTURE(id);
    const Diagnosis diagnosis = diagnose_motion(study_of(term, value));
    REQUIRE(!diagnosis.causes.empty());
    const NamedCause& first = diagnosis.causes.front();
    INFO(as_text(diagnosis));
    REQUIRE(first.effects.size() == 1);
    CHECK(first.effects.front().id == id);
    const Estimate& size = first.effects.front().values.front();
    const double slack = value / 50;
    CHECK(size.low <= value + slack);
    CHECK(size.high >= value - slack);
    CHECK(diagnosis.mean(true).after < 2 * 5e-4);  // noise alone
  }
}

/// A bench whose drive has a row that needs a count of periods, a temperature or the motion of its base.
Study study_beside(const std::function<void(Drive<double>&)>& plant) {
  Bench bench;
  bench.name = "planted";
  bench.nominal = planted_drive(Term::command_delay, 0);
  bench.sigma = 5e-4;
  bench.periods = {7, 24};
  Drive<double> moves = bench.nominal;
  plant(moves);
  unsigned seed = 1;
  for (const double gain : {4.0, 8.0, 16.0}) {
    MotionLog log = test_log(bench.nominal, gain, 0);
    for (std::size_t k = 0; k < log.time.size(); ++k) {
      log.warmer.push_back(gain - 8 + log.time[k]);
      log.base_acceleration.push_back(std::sin(9 * log.time[k]));
    }
    log.position = angles_of(moves, log, {0, 0, log.time.size()}, 0.0, 0.0);
    std::mt19937 generator(seed++);
    std::normal_distribution<double> noise(0, bench.sigma);
    for (double& q : log.position) q += noise(generator);
    bench.logs.push_back(std::move(log));
  }
  return Study(bench);
}

TEST_CASE("parts of the servo's law, and what acts by angle, temperature and base, are named") {
  const struct {
    const char* id;
    std::function<void(Drive<double>&)> plant;
  } planted[] = {
      {"integral_gain", [](auto& drive) { drive[Term::integral_gain] = 2; }},
      {"gravity_forward", [](auto& drive) { drive[Term::gravity_forward] = 0.5; }},
      {"contact_above",
       [](auto& drive) { drive[Term::contact_above] = 1.5, drive[Term::above_from] = 0.35; }},
      {"cogging(24)", [](auto& drive) { drive[Term::periods] = 24, drive[Term::cogging_sine] = 0.08; }},
      {"torque_ripple(7)", [](auto& drive) { drive[Term::periods] = 7, drive[Term::ripple_cosine] = 0.3; }},
      {"friction_warming", [](auto& drive) { drive[Term::friction_warming] = 0.08; }},
      {"base_motion", [](auto& drive) { drive[Term::base_motion] = 1; }}};
  for (const auto& [id, plant] : planted) {
    CAPTURE(id);
    const Diagnosis diagnosis = diagnose_motion(study_beside(plant));
    INFO(as_text(diagnosis));
    CHECK(first_named(diagnosis) == std::set<std::string>{id});
  }
}

TEST_CASE(
    "what no log tells apart is one class: back EMF and viscous friction of a drive that is never off") {
  const Diagnosis diagnosis = diagnose_motion(study_of(Term::viscous, 0.08));
  INFO(as_text(diagnosis));
  CHECK(diagnosis.verdict == diagnose::CauseVerdict::ambiguous);
  REQUIRE(diagnosis.causes.size() >= 2);
  std::set<std::string> named;
  for (const NamedCause& one : diagnosis.causes)
    if (one.effects.size() == 1) named.insert(one.effects.front().id);
  CHECK(named == std::set<std::string>{"back_emf", "derivative_gain", "viscous_friction"});
}

TEST_SUITE_END();

TEST_CASE("an effect that changes less than a twentieth of what another does is not named beside it") {
  Drive<double> moves = planted_drive(Term::command_delay, 0.03);
  moves[Term::load_mass] = 0.01;
  const Diagnosis diagnosis = diagnose_motion(study_of(moves));
  INFO(as_text(diagnosis));
  CHECK(diagnosis.verdict == diagnose::CauseVerdict::identified);
  CHECK(first_named(diagnosis) == std::set<std::string>{"command_delay"});
  REQUIRE(diagnosis.beside.size() == 1);
  CHECK(diagnosis.beside.front().id == "load_mass");
  moves[Term::load_mass] = 0.3;
  const Diagnosis both = diagnose_motion(study_of(moves));
  INFO(as_text(both));
  CHECK(first_named(both) == std::set<std::string>{"command_delay", "load_mass"});
}

TEST_CASE("a drive that is as stated has no gap") {
  const Diagnosis diagnosis = diagnose_motion(study_of(Term::command_delay, 0));
  INFO(as_text(diagnosis));
  CHECK(diagnosis.verdict == diagnose::CauseVerdict::none);
  CHECK(diagnosis.causes.empty());
}

/// A pendulum that is let go far from its command, and swings in fast; the log begins after `cut` readings.
Study released(double delay, std::size_t cut) {
  Bench bench;
  bench.name = "released";
  bench.nominal = planted_drive(Term::command_delay, 0);
  bench.sigma = 5e-4;
  unsigned seed = 7;
  for (const double gain : {8.0, 16.0}) {
    MotionLog log = test_log(planted_drive(Term::command_delay, delay), gain, bench.sigma, seed++, 0.4);
    for (std::vector<double>* list : {&log.time, &log.command, &log.position, &log.supply})
      list->erase(list->begin(), list->begin() + static_cast<std::ptrdiff_t>(cut));
    log.powered.erase(log.powered.begin(), log.powered.begin() + static_cast<std::ptrdiff_t>(cut));
    bench.logs.push_back(std::move(log));
  }
  return Study(bench);
}

TEST_CASE("a log that begins amid a transient has the verdict of every other cut of it") {
  for (const std::size_t cut : {0, 3, 40}) {
    CAPTURE(cut);
    const Diagnosis nothing = diagnose_motion(released(0, cut));
    INFO(as_text(nothing));
    CHECK(nothing.verdict == diagnose::CauseVerdict::none);
    const Diagnosis late = diagnose_motion(released(0.03, cut));
    INFO(as_text(late));
    REQUIRE(!late.causes.empty());
    REQUIRE(late.causes.front().effects.size() == 1);
    CHECK(late.causes.front().effects.front().id == "command_delay");
  }
}

}  // namespace plumbline::motion
