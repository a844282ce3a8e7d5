#include "exchange/mjcf.hpp"

#include <doctest/doctest.h>

#include "exchange/read_model.hpp"
#include "exchange/ways.hpp"
#include "tests/exchange/proof.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

/// The text with the first of one replaced by another.
std::string replaced(std::string text, const std::string& one, const std::string& other) {
  const std::size_t at = text.find(one);
  REQUIRE(at != std::string::npos);
  return text.replace(at, one.size(), other);
}

}  // namespace

TEST_CASE("what MJCF carries does in MuJoCo what the diagnosis found") {
  const Study bare(diagnose::test::full_bench());
  for (const EffectAt& at : possible_effects(bare)) {
    if (!way_of(Format::mjcf, at.effect->id).carried || at.joint == 1 || at.joint == 3) continue;
    CAPTURE(at.label());
    const auto [nominal, found, mujoco] = test::residuals(at);
    CAPTURE(nominal);
    // The noise has size one. What joints at rest add to it is to be less than half of it. Damping, which the
    // file has for the dynamics, drags beside dry friction: by a twentieth at the pace of the test.
    const double drag = test::pace_of(at.effect->id) == test::Pace::on_the_way ? 0.06 * nominal : 0;
    CHECK(nominal > 5);
    CHECK(mujoco * mujoco - found * found < std::max(0.25, drag * drag));
  }
}

TEST_CASE("what MJCF cannot carry stands in it as numbers that MuJoCo reads") {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}, {}};
  model.experiment.effects = {{"force_gain", 0, {{"g", 0.25}}}};
  model.laws = {{{2}, {{-0.1, -0.3}, {0, 0}, {0.1, 0.2}}, {{0.01, 0.05, 0}}, {}, "stiffer to one side"}};
  const Written file = to_mjcf(model);
  REQUIRE(file.effects.size() == 2);
  CHECK_FALSE(file.effects[0].carried);
  CHECK_FALSE(file.effects[1].carried);
  CHECK(file.text.find("NOT CARRIED: force_gain: of the load cell") != std::string::npos);
  test::MujocoBench bench(file.text, test::Pace::at_rest);
  CHECK(bench.numbers("force_gain g") == std::vector<double>{0.25});
  CHECK(bench.numbers("torque_law q2") == std::vector<double>{-0.1, -0.3, 0, 0, 0.1, 0.2});
  CHECK(bench.numbers("torque_law q2 sliders") == std::vector<double>{0.01, 0.05, 0});
}

TEST_CASE("an MJCF in, changed in MuJoCo, diagnosed, and the corrected MJCF out: the gap is gone") {
  Experiment bench = diagnose::test::full_bench();
  Model model{"three links", bench, bench.runs.front().rest, {}};
  const std::string before = to_mjcf(model).text;
  const Folder folder;
  folder.write("robot.xml", before);
  static_cast<diagnose::NominalChain&>(bench) = read_model(folder / "robot.xml").chain;
  struct Change {
    std::string one, other, cause;
  };
  for (const Change& change :
       {Change{"stiffness=\"1.5\"", "stiffness=\"1.95\"", "joint_stiffness(2)"},
        Change{"name=\"link3\" pos=\"0.25 ", "name=\"link3\" pos=\"0.26 ", "link_length(2)"}}) {
    CAPTURE(change.cause);
    Prediction changed;
    for (const diagnose::Run& run : bench.runs) {
      model.rest = run.rest;
      const std::string text = replaced(to_mjcf(model).text, change.one, change.other);
      changed.runs.push_back(test::MujocoBench(text, test::Pace::at_rest).run(run));
    }
    const test::RoundTrip trip = test::round_trip(bench, changed, test::Pace::at_rest, 7);
    REQUIRE(trip.diagnosis.cause.verdict == diagnose::CauseVerdict::identified);
    const diagnose::Cause& cause = trip.diagnosis.cause;
    CHECK(cause.ranking[cause.best].hypothesis.fit.candidate.label() == change.cause);
    CHECK(trip.reported < 0.2);
    // On the same readings, with the same noise: what differs is MuJoCo's own error, and the values, which
    // the file has from all readings.
    CHECK(trip.mujoco < 1.1 * trip.reported);
  }
}

}  // namespace plumbline::exchange
