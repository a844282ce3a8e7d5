#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/motion/diagnosis.hpp"
#include "diagnose/motion/report.hpp"
#include "support/files/output_file.hpp"
#include "support/files/temporary_folder.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

constexpr double stiffness = 12, sigma = 4e-4;  // N m/rad of the servo; rad

/// A wheel on a servo, without weight.
Drive<double> wheel(double friction) {
  Drive<double> drive;
  drive[Term::stall_torque] = 1, drive[Term::viscous] = 0.05, drive[Term::dry] = friction;
  return drive;
}

/// A slow sweep there and back, and once more sixteen times as fast: at one speed a delay is friction. In the
/// slow one viscous friction moves the joint by 0.05 N m s/rad x 0.0125 rad/s / 12 N m/rad, an eighth of the
/// noise.
MotionLog sweep(const Drive<double>& drive, unsigned seed) {
  MotionLog log;
  log.name = "sweep", log.gain = stiffness, log.inertia = 0.01;
  for (int k = 0; k < 3400; ++k) {
    const double t = 0.02 * k, turn = t < 64 ? t / 32 : (t - 64) / 2;
    log.time.push_back(t);
    log.command.push_back(0.4 * (turn < 1 ? turn : 2 - turn));
  }
  log.supply.assign(log.time.size(), 1);
  log.powered.assign(log.time.size(), true);
  log.position.assign(log.time.size(), 0);
  log.position = angles_of(drive, log, {0, 0, log.time.size()}, 0.0, 0.0);
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, sigma);
  for (double& q : log.position) q += noise(generator);
  return log;
}

/// The same log as a bench at rest: a reading every 1.6 s of the slow sweep. A held command
/// is half a step old.
diagnose::Diagnosis at_rest(const MotionLog& log) {
  const files::TemporaryFolder folder;
  std::string rows = "q_command1,q1\n";
  for (std::size_t k = 80; k < 3200; k += 80)
    rows += fmt::format("{:.9g},{:.9g}\n", (log.command[k - 1] + log.command[k]) / 2, log.position[k]);
  files::write_text(folder.path() / "sweep.csv", rows);
  files::write_text(
      folder.path() / "experiment.toml",
      fmt::format("format = \"chain-experiment/1\"\nname = \"wheel\"\n[nominal]\nlink_length = "
                  "[0.1]\njoint_stiffness = [{}]\n[noise]\nq = {}\n[[run]]\nid = \"sweep\"\ncontrol "
                  "= \"command\"\nbegins = \"moving\"\nsamples = \"sweep.csv\"\n",
                  stiffness, sigma));
  return diagnose::diagnose(diagnose::Study(diagnose::read_experiment(folder.path())));
}

Diagnosis in_motion(const MotionLog& log) {
  Bench bench;
  bench.name = "wheel", bench.nominal = wheel(0), bench.sigma = sigma, bench.logs = {log};
  return diagnose_motion(Study(bench));
}

}  // namespace

TEST_SUITE_BEGIN("long");

TEST_CASE("a slow log has the verdict of the bench at rest: none, or dry friction") {
  const MotionLog free = sweep(wheel(0), 1);
  CHECK(in_motion(free).verdict == diagnose::CauseVerdict::none);
  CHECK(at_rest(free).cause.verdict == diagnose::CauseVerdict::none);

  const MotionLog rubbing = sweep(wheel(0.15), 2);
  const Diagnosis moving = in_motion(rubbing);
  INFO(as_text(moving));
  // In slow motion a dead band of the servo is dry friction, and at rest play is: both name it in a class.
  const auto friction = std::find_if(moving.causes.begin(), moving.causes.end(), [](const NamedCause& one) {
    return one.effects.size() == 1 && one.effects.front().id == "joint_friction";
  });
  REQUIRE(friction != moving.causes.end());
  CHECK(friction->effects.front().values.front().value == close_to(0.15).epsilon(0.03));
  const diagnose::Cause resting = at_rest(rubbing).cause;
  REQUIRE(resting.is_explained());
  CHECK(std::any_of(resting.ranking.begin(),
                    resting.ranking.begin() + static_cast<std::ptrdiff_t>(resting.named),
                    [](const diagnose::RankedCause& one) {
                      return one.cause.effects.size() == 1 && one.cause.label().starts_with("joint_friction");
                    }));
}

TEST_SUITE_END();

}  // namespace plumbline::motion
