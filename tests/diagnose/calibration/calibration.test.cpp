#include "diagnose/calibration/calibration.hpp"

#include "diagnose/calibration/registration.hpp"
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
  void add(const EffectAt& at, double value) {
    candidate.effects.push_back(at);
    parameters.push_back(value);
  }
};

Experiment given(const Truth& truth, unsigned seed) {
  return as_given(arm_bench(industrial_arm(0), 80), truth.candidate, truth.parameters, seed);
}

Pose<double> somewhere() {
  Pose<double> frame = Pose<double>::Identity();
  frame.linear() = rotation_by(Vector3<double>(0.7, -1.9, 1.1));
  frame.translation() = Vector3<double>(1.4, -3.2, 0.6);
  return frame;
}

}  // namespace

TEST_CASE("an arm in any frame, with its point anywhere, is calibrated to the same") {
  const Experiment here = given(Truth(6, 1), 2);
  Experiment elsewhere = here;
  Pose<double> offset = Pose<double>::Identity();
  offset.translation() = Vector3<double>(0.04, -0.11, 0.06);
  elsewhere.arm_bench.points[0].at.frame = elsewhere.arm_bench.points[0].at.frame * offset;
  move_tracker(elsewhere, somewhere());
  const std::optional<Calibration> one = calibrated(Study(here)), other = calibrated(Study(elsewhere));
  REQUIRE(one);
  REQUIRE(other);
  // Steps of Gauss and Newton's method square their error: of 2 mrad on a metre three leave nothing but the
  // difference quotients' 1e-6 of what the effects do, some hundred sigmas.
  CHECK(std::abs(Study(one->experiment).nominal_residual().norm() -
                 Study(other->experiment).nominal_residual().norm()) < 1e-2);
  CHECK(one->corrected.place == doctest::Approx(other->corrected.place).epsilon(1e-2));
  REQUIRE(one->sizes.size() == other->sizes.size());
  for (std::size_t g = 0; g < one->sizes.size(); ++g)
    CHECK(one->sizes[g].size == doctest::Approx(other->sizes[g].size).epsilon(2e-2));
}

TEST_CASE("of tolerances alone nothing sticks out, and the correction is as good as least squares") {
  for (const unsigned seed : {3U, 4U}) {
    const std::optional<Calibration> found = calibrated(Study(given(Truth(6, seed), seed)));
    REQUIRE(found);
    CHECK(found->beside.empty());
    CHECK(found->corrected.place <= 1.1 * found->least_squares.place);
    CHECK(found->nominal.place > 5 * found->corrected.place);
  }
}

// The yielding is taken up by the tolerances: nothing is named beside them.
TEST_CASE("a joint that yields sticks out of zeros and tilts of all joints" * doctest::should_fail()) {
  Truth truth(6, 5);
  truth.add({"joint_compliance", 2}, 1e-4);
  const std::optional<Calibration> found = calibrated(Study(given(truth, 6)));
  REQUIRE(found);
  REQUIRE(!found->beside.empty());
  CHECK(found->beside.front().label() == "joint_compliance(2)");
  CHECK(found->corrected.place <= 1.1 * found->least_squares.place);
}

TEST_CASE(
    "what a fit has not seen is left as noise alone would leave it, but for what the fit does not know") {
  const std::optional<Calibration> found = calibrated(Study(given(Truth(6, 7), 8)));
  REQUIRE(found);
  // Noise of 3e-5 m an axis; 192 values fit some forty numbers, which adds less than a half to the squares.
  CHECK(found->corrected.place > 0.9 * std::sqrt(3.0) * 3e-5);
  CHECK(found->corrected.place < 1.3 * std::sqrt(3.0) * 3e-5);
}

}  // namespace plumbline::diagnose::test
