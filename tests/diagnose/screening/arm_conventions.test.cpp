#include "diagnose/screening/arm_conventions.hpp"

#include <numbers>

#include "diagnose/bench/registration.hpp"
#include "tests/diagnose/arms.hpp"

namespace plumbline::diagnose::test {
namespace {

/// An arm whose joints are all off by 2 mrad, as robots are before they are calibrated.
Experiment ordinary_arm() {
  const NominalArm arm = industrial_arm();
  Candidate truth;
  std::vector<double> off;
  std::mt19937 dice(7);
  std::normal_distribution<double> normal;
  for (std::size_t j = 1; j <= arm.arm.size(); ++j)
    truth.effects.emplace_back("rest_angle", j), off.push_back(2e-3 * normal(dice));
  return as_given(arm_bench(arm, 80), truth, off, 8);
}

/// The readings of a tracker that stands elsewhere, of a point that sits elsewhere, and nobody says where.
Experiment in_any_frame(Experiment experiment) {
  Pose<double> offset = Pose<double>::Identity(), frame = offset;
  offset.translation() = Vector3<double>(0.04, -0.11, 0.06);
  experiment.arm_bench.points[0].at.frame = experiment.arm_bench.points[0].at.frame * offset;
  frame.linear() = rotation_by(Vector3<double>(0.7, -1.9, 1.1));
  frame.translation() = Vector3<double>(1.4, -3.2, 0.6);
  move_tracker(experiment, frame);
  experiment.arm_bench.frames = ArmBench::Frames::unknown;
  return experiment;
}

struct Planted {
  const char* said;
  std::function<void(Experiment&)> spoil;
};

void spoil_places(Experiment& experiment, const std::function<void(double*)>& change) {
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings)
      change(&Channel(Channel::Name::place, 0, experiment.arm->arm.size()).in(reading));
}

void spoil_commands(Experiment& experiment, const std::function<void(std::vector<double>&)>& change) {
  for (Run& run : experiment.runs) run.each_rest(change);
}

const std::vector<Planted>& planted() {
  static const std::vector<Planted> all{
      {"places look like mm",
       [](Experiment& e) {
         spoil_places(e, [](double* at) {
           for (int i = 0; i < 3; ++i) at[i] *= 1000;
         });
       }},
      {"places look like m that were taken for mm",
       [](Experiment& e) {
         spoil_places(e, [](double* at) {
           for (int i = 0; i < 3; ++i) at[i] /= 1000;
         });
       }},
      {"commands look like degrees",
       [](Experiment& e) {
         spoil_commands(e, [](auto& q) {
           for (double& one : q) one *= 180 / std::numbers::pi;
         });
       }},
      {"left-handed", [](Experiment& e) { spoil_places(e, [](double* at) { at[1] = -at[1]; }); }},
      {"joint_3 looks as if it turned the other way",
       [](Experiment& e) { spoil_commands(e, [](auto& q) { q[2] = -q[2]; }); }},
      {"joint_2 and joint_4 look exchanged",
       [](Experiment& e) { spoil_commands(e, [](auto& q) { std::swap(q[1], q[3]); }); }},
      {"the zero of joint_3 looks off by 90 degrees",
       [](Experiment& e) { spoil_commands(e, [](auto& q) { q[2] += std::numbers::pi / 2; }); }},
      {"places look one row before their commands", [](Experiment& e) {
         for (Run& run : e.runs) {
           for (std::size_t i = 0; i + 1 < run.readings.size(); ++i)
             run.readings[i].value = run.readings[i + 1].value;
           run.readings.pop_back();
         }
       }}};
  return all;
}

std::string said_of(const Experiment& experiment) {
  const std::optional<SuspectedSlip> found = suspected_slip(Study(experiment));
  return found ? found->looks_like : "";
}

}  // namespace

TEST_CASE("a slip on an ordinary arm is asked about, wherever tracker and point are") {
  for (const bool known : {true, false}) {
    const Experiment right = known ? ordinary_arm() : in_any_frame(ordinary_arm());
    CHECK(said_of(right) == "");
    for (const Planted& slip : planted()) {
      CAPTURE(std::string(slip.said));
      Experiment spoiled = right;
      slip.spoil(spoiled);
      CHECK_MESSAGE(said_of(spoiled).find(slip.said) != std::string::npos, said_of(spoiled), known);
    }
  }
}

// Weights move the places of a stiff arm by a millimetre: less than zeros of 2 mrad do, so that nothing mends
// nine tenths; beside no such zeros all is mended but the noise.
TEST_CASE("weights and gravity the wrong way are asked about where they are most of what is off") {
  const Experiment exact = as_given(arm_bench(industrial_arm(1e3), 80), {}, {}, 9);
  for (const Experiment& right : {exact, in_any_frame(exact)}) {
    CHECK(said_of(right) == "");
    Experiment in_newtons = right;
    for (Run& run : in_newtons.runs)
      for (Reading& reading : run.readings)
        for (double& load : reading.wrench) load *= 9.80665;
    CHECK(said_of(in_newtons) == "weights look like N that were taken for kg");
    Experiment reversed = right;
    NominalArm arm = *reversed.arm;
    arm.arm.gravity *= -1;
    reversed.arm = std::make_shared<const NominalArm>(arm);
    CHECK(said_of(reversed) == "gravity looks as if it pulled the other way");
  }
}

// Every effect at its typical size, and at five times that. (Ten times a compensation of gravity is its
// reversal.)
TEST_CASE("no gap is taken for a slip" * doctest::test_suite("long")) {
  const Experiment bench = arm_bench(industrial_arm(), 60);
  const Study nominal(bench);
  for (const EffectAt& at : possible_effects(nominal))
    for (const double times : {1.0, 5.0}) {
      std::vector<double> amount;
      for (const ParameterRange& range : nominal.ranges(at))
        amount.push_back(std::clamp(times * range.scale, range.low, range.high));
      if (!predict(nominal, {{at}}, amount).reached) continue;
      CAPTURE(at.label());
      const Experiment gap = as_given(bench, {{at}}, amount, 10);
      CHECK(said_of(gap) == "");
      CHECK(said_of(in_any_frame(gap)) == "");
    }
}

}  // namespace plumbline::diagnose::test
