/// \file
/// The loop closed where no cause is known: a robot whose joints do in MuJoCo what no effect of the catalogue
/// does, the law that the diagnosis offers, and the corrected files.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <map>

#include "diagnose/bench/read_nominal.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/lab.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::CauseVerdict, diagnose::FreeLaw, diagnose::Prediction, diagnose::Study, test::in_mujoco,
    test::Lab, test::Pace, test::rms, test::RoundTrip;

/// Torques beside those of the springs, by the joint's number and its deflection: positive resists.
using Torques = std::map<std::size_t, std::function<double(double)>>;

/// MuJoCo has them while this lives, whatever the file says.
class Acting {
 public:
  explicit Acting(Torques torques) {
    all = std::move(torques);
    mjcb_passive = [](const mjModel* model, mjData* data) {
      for (const auto& [number, torque] : all) {
        const auto [name, sense] = test::names().joints[number - 1];
        const int joint = mj_name2id(model, mjOBJ_JOINT, name.c_str());
        const double bent =
            sense * (data->qpos[model->jnt_qposadr[joint]] - model->qpos_spring[model->jnt_qposadr[joint]]);
        data->qfrc_passive[model->jnt_dofadr[joint]] -= sense * torque(bent);
      }
    };
  }
  ~Acting() { mjcb_passive = nullptr; }
  Acting(const Acting&) = delete;
  Acting& operator=(const Acting&) = delete;

 private:
  static inline Torques all;
};

Prediction robot_with(const Lab& lab, Torques torques) {
  const Acting acting(std::move(torques));
  return in_mujoco(test::robot_alone(), lab.experiment, Pace::at_rest);
}

/// What MuJoCo makes of the corrected file is what the report says of the law.
void check_agrees(const RoundTrip& trip) {
  CAPTURE(trip.before);
  CAPTURE(trip.after);
  REQUIRE(trip.diagnosis.law);
  CAPTURE(trip.diagnosis.law->pictures.front().words);
  CHECK(trip.diagnosis.cause.verdict != CauseVerdict::identified);
  CHECK(trip.before > 5);
  CHECK(trip.reported < 0.3);
  // What joints at rest, and what slips on its way, add to the noise is less than half of it.
  // Beside what slips, damping drags, as it does in round trips of dry friction: 0.06
  // of the gap.
  const auto& pictures = trip.diagnosis.law->pictures;
  const bool slips =
      std::any_of(pictures.begin(), pictures.end(), [](const auto& one) { return !one.sliders.empty(); });
  const double added = 0.5 / trip.before, drag = slips ? 0.06 : 0;
  CHECK(std::abs(trip.mujoco - trip.reported) < 0.1 * trip.reported + added + drag);
}

/// The lab without its run under weights: what slips or relaxes is read on its way, and the less drags in
/// MuJoCo the less the end point is left to itself.
struct LedLab : Lab {
  LedLab() { experiment.runs.pop_back(); }
};

}  // namespace

TEST_CASE("what no cause explains comes back as a law that MuJoCo has, and leaves what the report says" *
          doctest::test_suite("long")) {
  const auto cogs = [](double d) { return 0.05 * std::sin(15 * d); };
  // More waves than a spring of two slopes and a stop can draw in one joint.
  const auto finely = [](double d) { return 0.03 * std::sin(35 * d); };
  const auto detent = [](double d) { return 1.5 * d * std::exp(-std::pow(d / 0.06, 2)); };
  const auto step = [](double d) { return 0.1 * (std::tanh(25 * (d - 0.08)) + std::tanh(2)); };
  const Lab lab;
  SUBCASE("a knee that cogs") {
    check_agrees(round_trip(lab, lab.experiment, robot_with(lab, {{2, finely}}), Pace::at_rest, 5));
  }
  SUBCASE("each joint something else") {
    const Prediction truth = robot_with(lab, {{1, cogs}, {2, detent}, {3, step}});
    check_agrees(round_trip(lab, lab.experiment, truth, Pace::at_rest, 5));
  }
  const LedLab led;
  SUBCASE("all joints cog") {
    const Prediction truth = robot_with(led, {{1, cogs}, {2, cogs}, {3, cogs}});
    check_agrees(round_trip(led, led.experiment, truth, Pace::at_rest, 5));
  }
}

TEST_CASE("a law that slips, at a constant torque or at one that grows, is in MuJoCo what the report says" *
          doctest::test_suite("long")) {
  const LedLab lab;
  Model truth{"robot", lab.experiment, lab.experiment.rest, lab.folder / "robot.xml"};
  int carried = 0;
  for (const FreeLaw::Slider& widest : {FreeLaw::Slider{0.09, 0.08, 0}, FreeLaw::Slider{0.05, 0, 0.5}}) {
    CAPTURE(widest.growth);
    truth.experiment.laws = {
        {2, {{-0.3, -0.05}, {0, 0}, {0.1, 0.1}, {0.4, 0}}, {{0.013, 0.02, 0}, widest}, {}}};
    const Prediction done = in_mujoco(written(truth, Format::mjcf).text, lab.experiment, Pace::interpolated);
    const Study study(test::read_with_noise(lab.experiment, done, 6));
    const diagnose::NoiseEstimate noise = diagnose::test::declared_noise(study);
    const std::optional<diagnose::OfferedLaw> offered = diagnose::offer_law(study, noise);
    REQUIRE(offered);
    REQUIRE(offered->shrink);
    CHECK_FALSE(offered->pictures.front().sliders.empty());
    Model corrected = truth;
    corrected.experiment.laws = free_laws(study, offered->law);
    const Written file = written(corrected, Format::mjcf);
    if (!file.effects.front().carried) {  // a loop whose width goes with the place: MuJoCo has no such joint
      CHECK_FALSE(file.effects.front().how.empty());
      continue;
    }
    ++carried;
    const diagnose::HeldOut heldout = diagnose::named(study.experiment(), offered->shrink->heldout);
    const auto left = [&](const Prediction& prediction) {
      return measure_shrink(study.measurements(), heldout, study.nominal_residual(),
                            study.residual(prediction), noise)
          .ratio;
    };
    const double said = left(predict_with_law(study, offered->law));
    CHECK(offered->shrink->ratio < 0.2);
    CHECK(said < offered->shrink->ratio);
    CHECK(std::abs(left(in_mujoco(file.text, lab.experiment, pace_of(corrected, Pace::at_rest))) - said) <
          0.1 * said + 0.5 / rms(study.nominal_residual()));
  }
  CHECK(carried > 0);
}

TEST_CASE("our own file has the law, and leaves what the law leaves; URDF and SDF say that they have it not" *
          doctest::test_suite("long")) {
  const Lab lab;
  const std::filesystem::path model = lab.folder / "robot.xml";
  round_trip(lab, lab.experiment, robot_with(lab, {{2, [](double d) { return 0.03 * std::sin(35 * d); }}}),
             Pace::at_rest, 5);
  const diagnose::NominalChain nominal = read_model(model).chain;
  const Study study(diagnose::read_experiment(lab.folder.path(), &nominal));
  const diagnose::Diagnosis diagnosis = diagnose::diagnose(study);
  REQUIRE(diagnosis.law);
  const Model corrected = corrected_models(study, diagnosis, model).front().model;
  const diagnose::NominalChain again =
      diagnose::parse_nominal(written(corrected, Format::toml).text, "corrected.toml");
  CHECK(again.laws == corrected.experiment.laws);
  const Study with_it(diagnose::read_experiment(lab.folder.path(), &again));
  CHECK(rms(with_it.nominal_residual()) ==
        close_to(rms(study.residual(predict_with_law(study, diagnosis.law->law)))).epsilon(1e-6));
  for (const Format format : {Format::urdf, Format::sdf}) {
    const Written file = written(corrected, format);
    const auto law = std::find_if(file.effects.begin(), file.effects.end(),
                                  [](const auto& one) { return one.effect == "torque_law(2)"; });
    REQUIRE(law != file.effects.end());
    CHECK_FALSE(law->carried);
    CHECK(file.text.find("NOT CARRIED: torque_law(2): joints of this format know no free torque law") !=
          std::string::npos);
    const FreeLaw::Knot& knot = corrected.experiment.laws.front().knots.front();
    CHECK(file.text.find(fmt::format("{:.6g} {:.6g}", knot.deflection, knot.torque)) != std::string::npos);
  }
}

}  // namespace plumbline::exchange
