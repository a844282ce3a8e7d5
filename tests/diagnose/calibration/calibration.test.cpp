#include "diagnose/calibration/calibration.hpp"

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/assumed_weight.hpp"
#include "diagnose/bench/registration.hpp"
#include "diagnose/inference/calibration.hpp"
#include "tests/diagnose/arms.hpp"

namespace plumbline::diagnose::test {
namespace {

/// What is off at every joint: zeros of 2 mrad and tilts of 1 mrad, as of an ordinary robot.
struct Truth {
  Candidate candidate;
  std::vector<double> parameters;

  explicit Truth(std::size_t joints, unsigned seed) {
    std::mt19937 dice(seed);
    std::normal_distribution<double> normal;
    for (std::size_t j = 1; j <= joints; ++j) {
      candidate.effects.emplace_back("rest_angle", j);
      parameters.push_back(2e-3 * normal(dice));
      candidate.effects.emplace_back("axis_tilt", j);
      for (int axis = 0; axis < 2; ++axis) parameters.push_back(1e-3 * normal(dice));
    }
  }
  void add(const EffectAt& at, const std::vector<double>& values) {
    candidate.effects.push_back(at);
    parameters.insert(parameters.end(), values.begin(), values.end());
  }
};

Experiment given(const Truth& truth, unsigned seed) {
  Experiment experiment = as_given(arm_bench(industrial_arm(0), 80), truth.candidate, truth.parameters, seed);
  experiment.arm_bench.frames = ArmBench::Frames::unknown;
  return experiment;
}

/// The same readings of a tracker that stands elsewhere; the point is said to be where it is not.
Experiment elsewhere(Experiment experiment) {
  Pose<double> offset = Pose<double>::Identity();
  offset.translation() = Vector3<double>(0.04, -0.11, 0.06);
  Pose<double>& point = experiment.arm_bench.points[0].at.frame;
  point = point * offset;
  Pose<double> frame = Pose<double>::Identity();
  frame.linear() = rotation_by(Vector3<double>(0.7, -1.9, 1.1));
  frame.translation() = Vector3<double>(1.4, -3.2, 0.6);
  move_tracker(experiment, frame);
  return experiment;
}

const Calibration& calibration_of(const Study& study) {
  REQUIRE(study.experiment().arm_bench.calibration);
  return *study.experiment().arm_bench.calibration;
}

/// Beside what is off everywhere: an encoder whose disc is off its axis, by as much as zeros are off.
Truth with_ripple(unsigned seed) {
  Truth truth(6, seed);
  truth.add({"encoder_ripple", 2}, {2e-3, -1e-3});
  return truth;
}

}  // namespace

TEST_CASE("an arm in any frame, with its point anywhere, is calibrated to the same") {
  const Experiment here = given(Truth(6, 1), 2);
  const Study one = calibrated(Study(here)), other = calibrated(Study(elsewhere(here)));
  // Steps of Gauss and Newton's method square their error: of 2 mrad on a metre three leave nothing but the
  // difference quotients' 1e-6 of what the effects do, some hundred sigmas.
  CHECK((one.nominal_residual() - other.nominal_residual()).norm() < 1e-2);
  const Calibration &first = calibration_of(one), &second = calibration_of(other);
  CHECK(first.corrected.of(Channel::Name::place) ==
        doctest::Approx(second.corrected.of(Channel::Name::place)).epsilon(1e-2));
  REQUIRE(first.tolerances.size() == second.tolerances.size());
  for (std::size_t t = 0; t < first.tolerances.size(); ++t) {
    CHECK(first.tolerances[t].at == second.tolerances[t].at);
    for (std::size_t p = 0; p < first.tolerances[t].mean.size(); ++p) {
      const double size = first.tolerances[t].deviation[p];
      CHECK(second.tolerances[t].deviation[p] == doctest::Approx(size).epsilon(2e-2));
      CHECK(std::abs(first.tolerances[t].mean[p] - second.tolerances[t].mean[p]) < 2e-2 * size);
    }
  }
}

TEST_CASE("of tolerances alone nothing sticks out, and the correction is as good as least squares") {
  for (const unsigned seed : {3U, 4U}) {
    const Study study = calibrated(Study(given(Truth(6, seed), seed)));
    const Calibration& found = calibration_of(study);
    CHECK(found.beside.empty());
    CHECK(found.corrected.of(Channel::Name::place) <= 1.1 * found.least_squares.of(Channel::Name::place));
    CHECK(found.nominal.of(Channel::Name::place) > 5 * found.corrected.of(Channel::Name::place));
    // What is left has the noise's variance in all directions but those of the frames.
    const VectorXd left = study.nominal_residual();
    const auto values = static_cast<double>(left.size());
    CHECK(std::abs(left.squaredNorm() / values - 1) < 4 * std::sqrt(2 / values));
  }
}

TEST_CASE("an encoder that is off its axis sticks out of zeros and tilts of all joints") {
  const Study study = calibrated(Study(given(with_ripple(5), 6)));
  const Calibration& found = calibration_of(study);
  REQUIRE(!found.beside.empty());
  CHECK(found.beside.front().label() == "encoder_ripple(2)");
  CHECK(found.corrected.of(Channel::Name::place) <= 1.1 * found.least_squares.of(Channel::Name::place));
}

TEST_CASE("a wrist's joint whose gear turns with the one before sticks out of what all joints are off by") {
  Truth truth(6, 702412);
  truth.add({"gear_coupling", 5}, {5e-3});
  const Study study = calibrated(Study(given(truth, 702413)));
  const Calibration& found = calibration_of(study);
  REQUIRE(!found.beside.empty());
  CHECK(found.beside.front().label() == "gear_coupling(5)");
}

TEST_CASE("an arm whose link bends far beyond what is linear is calibrated all the same") {
  Truth truth(7, 21);
  truth.add({"link_bending", 4}, {1 / 220.0});  // 1/(N m^2): some centimetres under the weight at the tip
  Experiment experiment = as_given(arm_bench(collaborative_arm(), 80), truth.candidate, truth.parameters, 22);
  experiment.arm_bench.frames = ArmBench::Frames::unknown;
  const Study study = calibrated(Study(experiment));
  CHECK(study.nominal().reached);
  const Calibration& found = calibration_of(study);
  CHECK(found.corrected.of(Channel::Name::place) < found.nominal.of(Channel::Name::place));
}

TEST_CASE("a joint that yields is seen through a model without masses, by those of links alike in density") {
  Experiment experiment = arm_bench(industrial_arm(0), 80);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.wrench.clear();
  Truth truth(6, 11);
  constexpr double compliance = 2e-4;  // rad/(N m): joint 2 carries up to 15 N m, and sags by 3 mrad
  truth.add({"joint_compliance", 2}, {compliance});
  experiment = as_given(experiment, truth.candidate, truth.parameters, 12);
  experiment.arm_bench.frames = ArmBench::Frames::unknown;
  NominalArm weightless = *experiment.arm;
  for (ArmLink<double>& link : weightless.arm.links) link.mass = 0, link.centre.setZero();
  REQUIRE(is_weightless(weightless.arm));
  const auto left_with = [&](double density) {
    NominalArm model = weightless;
    model.arm = weighed(model.arm, density);
    static_cast<NominalChain&>(experiment) = chain_of(model);
    return calibration_of(calibrated(Study(experiment)));
  };
  const Calibration none = left_with(0), some = left_with(10), other = left_with(20);
  const auto left = [](const Calibration& one) { return one.corrected.of(Channel::Name::place); };
  CHECK(left(some) < left(none));
  // Compliance times weight is all that shows.
  CHECK(left(other) == doctest::Approx(left(some)).epsilon(1e-2));
  const auto yields = [](const Calibration& one) {
    const auto is = [](const EffectAt& at) { return at.effect->id == "joint_compliance"; };
    return std::any_of(one.tolerances.begin(), one.tolerances.end(),
                       [&](const Tolerance& of) { return is(of.at) && std::abs(of.mean.front()) > 0; }) ||
           std::any_of(one.beside.begin(), one.beside.end(),
                       [&](const NominalEffect& of) { return of.label() == "joint_compliance(2)"; });
  };
  CHECK(yields(some));
}

TEST_CASE(
    "what a fit has not seen is left as noise alone would leave it, but for what the fit does not know") {
  const Study study = calibrated(Study(given(Truth(6, 7), 8)));
  const Calibration& found = calibration_of(study);
  // Noise of 3e-5 m an axis; 192 values fit some forty numbers, which adds less than a half to the squares.
  CHECK(found.corrected.of(Channel::Name::place) > 0.9 * std::sqrt(3.0) * 3e-5);
  CHECK(found.corrected.of(Channel::Name::place) < 1.3 * std::sqrt(3.0) * 3e-5);
}

TEST_CASE("a verdict is the same wherever the tracker stands and the point sits" *
          doctest::test_suite("long")) {
  const Experiment here = given(with_ripple(9), 10);
  const Diagnosis one = diagnose(calibrated(Study(here))),
                  other = diagnose(calibrated(Study(elsewhere(here))));
  REQUIRE(one.cause.named > 0);
  CHECK(one.cause.ranking.front().cause.label() == "encoder_ripple(2)");
  CHECK(one.cause.verdict == other.cause.verdict);
  CHECK(one.cause.named == other.cause.named);
  REQUIRE(other.cause.named > 0);
  CHECK(one.cause.ranking.front().cause == other.cause.ranking.front().cause);
  // The calibration's 1e-2 of a sigma in all of the readings moves no log evidence by more.
  CHECK(one.cause.ranking.front().probability ==
        doctest::Approx(other.cause.ranking.front().probability).epsilon(2e-2));
  CHECK(one.estimates.front().front().value ==
        doctest::Approx(other.estimates.front().front().value).epsilon(1e-3));
  // Frames are unknown, and no causes: what they hold all of is not told.
  for (const RankedCause& cause : one.cause.ranking)
    for (const EffectAt& at : cause.cause.effects) {
      CHECK(at.effect->id != "camera_turn");
      CHECK(at.effect->id != "position_offset");
    }
}

TEST_CASE("frames that are known stay as they are") {
  Experiment experiment = given(Truth(6, 1), 2);
  experiment.arm_bench.frames = ArmBench::Frames::known;
  CHECK_FALSE(calibrated(Study(experiment)).experiment().arm_bench.calibration);
}

TEST_CASE("fewer values than unknowns are refused by a line that says how many are wanted") {
  Experiment experiment = given(Truth(6, 1), 2);
  for (Run& run : experiment.runs) run.readings.resize(2);
  CHECK_THROWS_WITH_AS(calibrated(Study(experiment)), doctest::Contains("12 measured values"), Error);
}

}  // namespace plumbline::diagnose::test
