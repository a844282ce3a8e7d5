#include "diagnose/design/commanded_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/rig/nominal.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Two servo joints, commanded to four poses; joint 1 from -0.5 to 1, joint 2 from 0 to 0.6 rad.
Experiment two_servos() {
  Experiment experiment;
  experiment.name = "two servos";
  experiment.link_length = {0.3, 0.25};
  experiment.joint_stiffness = {60, 25};
  experiment.link_mass = {0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::vertical, {0, -1}, true};
  experiment.noise[Channel::Name::q] = 1e-3;
  Run run{"poses", Control::force, {-0.5, 0}, {}};
  run.by_weights = true;
  for (const std::vector<double>& command : std::vector<std::vector<double>>{{-0.5, 0}, {1, 0.6}, {0, 0.3}}) {
    run.readings.push_back(
        {static_cast<double>(run.readings.size()),
         chain_values(nan_value(), nan_value(), 0, 0, {command[0] - 0.1, command[1] - 0.05}), command});
  }
  experiment.runs = {run};
  return experiment;
}

}  // namespace

TEST_CASE("poses and sweeps stay between the commands so far, and every two joints meet at all levels") {
  const Experiment experiment = two_servos();
  const OperatingEnvelope so_far = operating_envelope(Study(experiment));
  CHECK(so_far.deflection == doctest::Approx(0.1));  // as it was read: the nominal model has no weight
  std::set<std::vector<double>> poses;
  std::size_t sweeps = 0, loaded = 0;
  for (const CandidateRun& one : commanded_runs(experiment, so_far)) {
    CAPTURE(one.description);
    REQUIRE(one.run.commands_joints());
    for (const Reading& reading : one.run.readings) {
      CHECK(reading.rest[0] >= -0.5);
      CHECK(reading.rest[0] <= 1 + 1e-12);
      CHECK(reading.rest[1] >= 0);
      CHECK(reading.rest[1] <= 0.6 + 1e-12);
    }
    sweeps += one.run.turns_back();
    if (one.run.readings.size() == 1) poses.insert(one.run.rest);
    const double force = one.run.imposed_at(one.run.readings.front()).norm();
    loaded += force > 0;
    CHECK((force == 0 || force > 0.1));  // one that can be hung
    Experiment bench = experiment;
    bench.runs = {one.run};
    const Prediction nominal = simulate(bench, nominal_rig(bench), {});
    CHECK(nominal.reached);
  }
  CHECK(poses.size() == 9);
  CHECK(sweeps == 4);
  CHECK(loaded == 11);
}

TEST_CASE("nothing is hung in a horizontal plane, and nothing commanded where nothing was") {
  Experiment flat = two_servos();
  flat.bench = {Bench::Plane::horizontal, {0, 0}, false};
  for (const CandidateRun& one : commanded_runs(flat, operating_envelope(Study(flat))))
    CHECK(one.run.imposed_at(one.run.readings.front()).norm() == 0);
  Experiment pressed = three_links();
  press(pressed, {0.3, -0.5, 0.4}, {-0.006, 0.008}, 5, true);
  CHECK(commanded_runs(pressed, operating_envelope(Study(pressed))).empty());
}
