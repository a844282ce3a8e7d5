#include "diagnose/exchange/mjcf.hpp"

#include <doctest/doctest.h>

#include "diagnose/exchange/ways.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/proof.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

}  // namespace

TEST_CASE("what MJCF carries does in MuJoCo what the diagnosis found" * doctest::test_suite("long")) {
  const Study bare(diagnose::test::full_bench());
  for (const EffectAt& at : test::carried(bare, Format::mjcf, 0)) {
    CAPTURE(at.label());
    const auto [nominal, found, mujoco] = test::residuals(at);
    CAPTURE(nominal);
    CAPTURE(found);
    CAPTURE(mujoco);
    // The noise has size one. What joints at rest add to it is to be less than half of it. Damping, which the
    // file has for the dynamics, drags beside dry friction: by a twentieth at the pace of the test.
    const double drag = test::pace_of(at.effect->id) == test::Pace::interpolated ? 0.06 * nominal : 0;
    CHECK(nominal > 5);
    CHECK(mujoco * mujoco - found * found < std::max(0.25, drag * drag));
  }
}

TEST_CASE("a load cell at the end of its range is one in MuJoCo") {
  // The catalogue seeks it where more than three readings are the largest: none is before it is planted.
  const EffectAt at("saturation");
  Experiment experiment = diagnose::test::full_bench();
  experiment.runs.pop_back();
  const Study bare(experiment);
  const std::vector<double> limit{1 / 3.0};
  const Study study(diagnose::test::measured(experiment, {{at}}, limit, 1));
  const Model model = corrected_models(study, test::found(study, at, limit)).front().model;
  CHECK(model.experiment.effects.front().parameters.at("limit") == close_to(3));
  CHECK(test::rms(study.nominal_residual()) > 5);
  CHECK(test::rms(study.residual(test::in_mujoco(model, test::Pace::at_rest))) < 1.1);
}

TEST_CASE("several effects of the bench at once, and of the chain, in one file") {
  Experiment experiment = diagnose::test::full_bench();
  experiment.effects = {{"force_gain", 0, {{"g", 0.3}}},
                        {"cross_talk", 0, {{"c_xy", 0.1}, {"c_yx", -0.05}}},
                        {"force_bias", 0, {{"b_x", 0.4}, {"b_y", -0.2}}},
                        {"rail_misalignment", 0, {{"eps", 0.1}}},
                        {"position_offset", 0, {{"d_x", 0.004}, {"d_y", -0.002}}},
                        {"nonlinear_spring", 0, {{"c", 2}}},
                        {"piecewise_spring", 0, {{"s", 0.03}, {"a", 0.4}}},
                        {"backlash", 2, {{"b", 0.05}}}};
  experiment.link_mass = {0.2, 0.1, 0.3};  // which hang from the links, not from what stands beside them
  experiment.gravity = {0.6, -9.7};
  const Study study(experiment);
  Model model{"all at once", experiment, {}};
  const Prediction in_file = test::in_mujoco(model, test::Pace::at_rest);
  CHECK(test::apart(study, in_file, study.nominal()) < 0.5);
}

TEST_CASE("what MJCF cannot carry stands in it as numbers that MuJoCo reads") {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}};
  model.experiment.effects = {{"load_friction", 0, {{"tau_c", 0.25}, {"growth", 0.1}}}};
  model.experiment.effects.push_back({"backlash", 2, {{"b", 0.01}}});
  diagnose::FreeLaw& law = model.experiment.laws.emplace_back(diagnose::FreeLaw{2, {}});
  law.knots = {{-0.1, -0.3}, {0, 0}, {0.1, 0.2}};
  law.sliders = {{0.01, 0, 0.1}};
  const Written file = to_mjcf(model);
  REQUIRE(file.effects.size() == 3);
  CHECK_FALSE(file.effects[0].carried);
  CHECK(file.effects[1].carried);
  CHECK_FALSE(file.effects[2].carried);
  CHECK(file.text.find("NOT CARRIED: load_friction: dry friction of this format is a constant") !=
        std::string::npos);
  test::MujocoBench bench(file.text, test::Pace::at_rest);
  CHECK(bench.numbers("load_friction tau_c") == std::vector<double>{0.25});
  CHECK(file.text.find("NOT CARRIED: torque_law(2): friction that grows") != std::string::npos);
  CHECK(file.text.find(" 0.1 0.2\n") != std::string::npos);
  CHECK(file.text.find("a slider along d^2/2 that slips from 0.01 rad on at 0.1 N m/rad") !=
        std::string::npos);
}

TEST_CASE("a spring that hardens is not carried beside one that is stiffer to one side, of the same joint") {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}};
  model.experiment.effects = {{"asymmetric_spring", 0, {{"e", 0.1}}}, {"nonlinear_spring", 0, {{"c", 2}}}};
  const Written file = to_mjcf(model);
  REQUIRE(file.effects.size() == 2);
  CHECK(file.effects[0].carried);
  CHECK_FALSE(file.effects[1].carried);
  CHECK(file.text.find("NOT CARRIED: nonlinear_spring: a spring that hardens is as stiff to both sides") !=
        std::string::npos);
}

TEST_CASE("friction that changes with the deflection stands in MJCF as numbers") {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}};
  model.experiment.laws = {{2, {{0, 0}}, {{0.02, 0, 0, {{-0.1, 0.05}, {0.2, 0.3}}}}, {}}};
  const Written file = to_mjcf(model);
  REQUIRE(file.effects.size() == 1);
  CHECK_FALSE(file.effects.front().carried);
  CHECK(file.text.find("slips after 0.02 rad, at a torque that goes with the deflection") !=
        std::string::npos);
  CHECK(file.text.find("    0.2 0.3\n") != std::string::npos);
}

TEST_CASE("a free torque law goes into MJCF, whatever its shape, and on beyond its knots" *
          doctest::test_suite("long")) {
  // Stiffer, softer and falling again, off centre; what slips, at a constant torque and at one that grows.
  diagnose::Experiment experiment = diagnose::test::full_bench();
  experiment.runs.pop_back();
  diagnose::FreeLaw law{2, {}, {}, {}};
  for (int i = -10; i <= 10; ++i) law.knots.push_back({0.01 * i, 0.05 * std::sin(0.2 * i)});
  const diagnose::FreeLaw::Slider steady{0.02, 0.03, 0}, widening{0.05, 0, 0.2};
  for (const auto& sliders : {std::vector<diagnose::FreeLaw::Slider>{}, {steady}, {widening}}) {
    law.sliders = sliders;
    // What slips starts at ease.
    experiment.laws = {law, {3, {{0, sliders.empty() ? 0.01 : 0.0}}}};
    const Model model{"three links", experiment, {0.3, -0.5, 0.4}};
    const Study study(experiment);
    const Prediction in_file =
        test::in_mujoco(model, sliders.empty() ? test::Pace::at_rest : test::Pace::interpolated);
    CHECK(test::apart(study, in_file, study.nominal()) < 0.5);
    CHECK((study.nominal().runs.front().col(diagnose::column_q + 1) + 0.5).abs().maxCoeff() > 0.15);
  }
}

}  // namespace plumbline::exchange
