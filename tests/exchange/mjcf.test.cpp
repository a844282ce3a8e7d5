#include "exchange/mjcf.hpp"

#include <doctest/doctest.h>

#include "exchange/ways.hpp"
#include "tests/exchange/proof.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

}  // namespace

TEST_CASE("what MJCF carries does in MuJoCo what the diagnosis found") {
  const Study bare(diagnose::test::full_bench());
  for (const EffectAt& at : possible_effects(bare)) {
    if (!way_of(Format::mjcf, at.effect->id).carried || at.joint == 1 || at.joint == 3) continue;
    CAPTURE(at.label());
    const auto [nominal, found, mujoco] = test::residuals(at);
    CAPTURE(nominal);
    CAPTURE(found);
    CAPTURE(mujoco);
    // The noise has size one. What joints at rest add to it is to be less than half of it. Damping, which the
    // file has for the dynamics, drags beside dry friction: by a twentieth at the pace of the test.
    const double drag = test::pace_of(at.effect->id) == test::Pace::on_the_way ? 0.06 * nominal : 0;
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
  CHECK(model.experiment.effects.front().parameters.at("limit") == doctest::Approx(3));
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
                        {"backlash", 2, {{"b", 0.05}}}};
  experiment.link_mass = {0.2, 0.1, 0.3};  // which hang from the links, not from what stands beside them
  experiment.gravity = {0.6, -9.7};
  const Study study(experiment);
  Model model{"all at once", experiment, {}, {}};
  const Prediction in_file = test::in_mujoco(model, test::Pace::at_rest);
  std::vector<double> difference = study.residual(in_file);
  const std::vector<double> nominal = study.nominal_residual();
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= nominal[i];
  CHECK(test::rms(difference) < 0.5);
}

TEST_CASE("what MJCF cannot carry stands in it as numbers that MuJoCo reads") {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}, {}};
  model.experiment.effects = {{"load_friction", 0, {{"tau_c", 0.25}, {"growth", 0.1}}}};
  model.laws = {{{2}, {{-0.1, -0.3}, {0, 0}, {0.1, 0.2}}, {{0.01, 0.05, 0.1}}, {}, "stiffer to one side"}};
  const Written file = to_mjcf(model);
  REQUIRE(file.effects.size() == 2);
  CHECK_FALSE(file.effects[0].carried);
  CHECK_FALSE(file.effects[1].carried);
  CHECK(file.text.find("NOT CARRIED: load_friction: dry friction of this format is a constant") !=
        std::string::npos);
  test::MujocoBench bench(file.text, test::Pace::at_rest);
  CHECK(bench.numbers("load_friction tau_c") == std::vector<double>{0.25});
  CHECK(bench.numbers("torque_law q2") == std::vector<double>{-0.1, -0.3, 0, 0, 0.1, 0.2});
  CHECK(bench.numbers("torque_law q2 sliders") == std::vector<double>{0.01, 0.05, 0.1});
}

TEST_CASE("a free torque law goes into MJCF from knot to knot, whatever its shape") {
  // Stiffer, softer and falling again, off centre, with the spring of the joint beside it.
  const auto law = [](double d) { return 0.05 * std::sin(40 * d) + 0.02; };
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}, {}};
  const double k = model.experiment.joint_stiffness[1], first = -0.4, last = 0.4;
  diagnose::LawPicture picture{{2}, {}, {}, {}, ""};
  constexpr int knots = 41;
  for (int i = 0; i < knots; ++i) {
    const double d = first + (last - first) * i / (knots - 1);
    picture.knots.push_back({d, k * d + law(d)});
  }
  const auto torque = [&](double d) {
    const double place = (std::clamp(d, first, last) - first) / (last - first) * (knots - 1);
    const auto i = std::min(static_cast<std::size_t>(place), picture.knots.size() - 2);
    const double share = place - static_cast<double>(i);
    const auto added = [&](std::size_t at) {
      return picture.knots[at].torque - k * picture.knots[at].deflection;
    };
    return k * d + (1 - share) * added(i) + share * added(i + 1);
  };
  model.laws = {picture};
  const Written file = to_mjcf(model);
  CHECK(file.effects.back().carried);
  test::MujocoBench bench(file.text, test::Pace::at_rest);
  const diagnose::Trace trace = bench.run(model.experiment.runs[0]);
  // What the springs and the law hold is what the end point's force asks of the joint.
  const std::vector<double>& length = model.experiment.link_length;
  double turned = 0;
  for (Eigen::Index r = 0; r < trace.rows(); ++r) {
    const double q1 = trace(r, diagnose::column_q), q2 = trace(r, diagnose::column_q + 1),
                 q3 = trace(r, diagnose::column_q + 2);
    const double x = length[1] * std::cos(q1 + q2) + length[2] * std::cos(q1 + q2 + q3),
                 y = length[1] * std::sin(q1 + q2) + length[2] * std::sin(q1 + q2 + q3);
    const double asked = x * trace(r, diagnose::column_Fy) - y * trace(r, diagnose::column_Fx);
    CHECK(std::abs(torque(q2 + 0.5) - asked) < 2e-3);
    turned = std::max(turned, std::abs(q2 + 0.5));
  }
  CHECK(turned > 0.15);
}

}  // namespace plumbline::exchange
