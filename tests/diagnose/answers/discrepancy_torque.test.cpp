#include "diagnose/answers/discrepancy_torque.hpp"

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("the torque of a discrepancy is that which gives it, where joint angles and force are measured") {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.02, 0}, 6, true);
  const Study study(measured(bench, {}, {}, 1));
  Hypothesis nominal;
  // A small constant torque at joint 2 is a rest angle that is wrong by torque over stiffness; k = 1.5 N
  // m/rad.
  constexpr double torque = 1e-5;
  const Prediction shifted = predict(study, only("rest_angle", 2), {torque / 1.5});
  REQUIRE(shifted.reached);
  const VectorXd delta = study.nominal_residual() - study.residual(shifted);
  // The least torque is no larger than the true one; with three angles and a force it is unique. The answers
  // are linear but for the square of the angle, 1e-5 rad.
  CHECK(discrepancy_torque(study, nominal, delta) == close_to(torque).epsilon(1e-3));
  CHECK(discrepancy_torque(study, nominal, 2 * delta) ==
        close_to(2 * discrepancy_torque(study, nominal, delta)).epsilon(1e-12));
  CHECK(discrepancy_torque(study, nominal, 0 * delta) == 0);
}
