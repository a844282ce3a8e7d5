#include "diagnose/bench/registration.hpp"

#include "tests/close_to.hpp"
#include "tests/diagnose/arms.hpp"

namespace plumbline::diagnose::test {
namespace {

/// Any frame: turned by up to half a turn about any axis, a few metres away.
Pose<double> any_frame(std::mt19937& dice) {
  std::normal_distribution<double> normal;
  Pose<double> frame = Pose<double>::Identity();
  frame.linear() = Eigen::Quaterniond(normal(dice), normal(dice), normal(dice), normal(dice))
                       .normalized()
                       .toRotationMatrix();
  frame.translation() = 2 * Vector3<double>(normal(dice), normal(dice), normal(dice));
  return frame;
}

/// Readings without noise of what the nominal arm does.
Experiment exact_bench(bool turns) {
  Experiment experiment = arm_bench(industrial_arm(0), 25, {turns});
  const std::size_t joints = experiment.arm->arm.size();
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) {
      const Vector3<double> place =
          nominal_pose(experiment.arm->arm, experiment.arm_bench.points[0].at, run.rest_at(reading))
              .translation();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Channel(Channel::Name::place, axis, joints).in(reading) = place(static_cast<Eigen::Index>(axis));
        if (turns) Channel(Channel::Name::turn, axis, joints).in(reading) = 0;
      }
    }
  return experiment;
}

double largest_residual(const Experiment& experiment) {
  return Study(experiment).nominal_residual().cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("a tracker anywhere and a point anywhere on its link are found, with and without orientations") {
  std::mt19937 dice(3);
  for (const bool turns : {false, true})
    for (int repeat = 0; repeat < 5; ++repeat) {
      CAPTURE(turns);
      Experiment experiment = exact_bench(turns);
      Pose<double> offset = any_frame(dice);
      offset.translation() *= 0.05;
      const Pose<double> tracker = any_frame(dice);
      move_point(experiment, 0, offset);
      // Readings stay those of the point where it was, told in a frame of the tracker's own.
      move_tracker(experiment, tracker.inverse());
      const Pose<double> found = register_frames(experiment);
      // The descent ends where an iteration gains 1e-12 of the squares: residuals of 1e-6 of metres, at most.
      CHECK((found.matrix() - tracker.matrix()).cwiseAbs().maxCoeff() < 1e-5);
      CHECK(largest_residual(experiment) * 3e-5 < 1e-5);
    }
}

TEST_CASE("moving a tracker and moving it back changes nothing but rounding") {
  std::mt19937 dice(4);
  const Experiment before = exact_bench(true);
  Experiment after = before;
  const Pose<double> frame = any_frame(dice);
  move_tracker(after, frame);
  move_tracker(after, frame.inverse());
  // Places of metres in doubles, over sigmas of 3e-5 m: 1e-15 / 3e-5, with room for a dozen roundings.
  CHECK(std::abs(largest_residual(after) - largest_residual(before)) < 1e-8);
}

}  // namespace plumbline::diagnose::test
