#include <doctest/doctest.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <memory>

#include "diagnose/motion/roll_out.hpp"
#include "tests/diagnose/motion/logs.hpp"
#include "tests/folder.hpp"
#include "tests/property.hpp"

// A driven pendulum without friction and without a limit that it meets, in the mechanics of another program.
namespace plumbline::motion {
namespace {

struct Pendulum {
  double mass, length, stall_torque, gain, armature, damping, spring;
};

struct InMujoco {
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, mj_deleteData};
};

constexpr double own_inertia = 1e-3;  // of the load about its centre, kg m^2

InMujoco in_mujoco(const Pendulum& p, double step) {
  const Folder folder;
  folder.write(
      "pendulum.xml",
      fmt::format("<mujoco><option timestep=\"{}\" integrator=\"RK4\"/><worldbody><body>"
                  "<joint name=\"j\" axis=\"0 1 0\" armature=\"{}\" damping=\"{}\" stiffness=\"{}\"/>"
                  "<inertial pos=\"0 0 {}\" mass=\"{}\" diaginertia=\"{} {} {}\"/></body></worldbody>"
                  "<actuator><position joint=\"j\" kp=\"{}\"/></actuator></mujoco>",
                  step, p.armature, p.damping, p.spring, -p.length, p.mass, own_inertia, own_inertia,
                  own_inertia, p.stall_torque * p.gain));
  std::array<char, 500> reason{};
  InMujoco made;
  made.model.reset(mj_loadXML((folder / "pendulum.xml").c_str(), nullptr, reason.data(), 500));
  REQUIRE_MESSAGE(made.model, reason.data());
  made.data.reset(mj_makeData(made.model.get()));
  return made;
}

Drive<double> drive_of(const Pendulum& p) {
  Drive<double> drive;
  drive[Term::stall_torque] = p.stall_torque, drive[Term::armature] = p.armature;
  drive[Term::viscous] = p.damping, drive[Term::spring] = p.spring;
  return drive;
}

double inertia_of(const Pendulum& p) {
  return own_inertia + p.mass * p.length * p.length;
}

}  // namespace

TEST_CASE("the acceleration of a driven pendulum is MuJoCo's to ten digits") {
  check_property("both mechanics agree", [] {
    const auto between = [](double low, double high) {
      return low + (high - low) * *rc::gen::inRange(0, 1000) / 1e3;
    };
    const Pendulum p{between(0.1, 2),  between(0.05, 0.4), between(0.5, 5), 0.3,
                     between(0, 0.05), between(0, 1),      between(0, 2)};
    const InMujoco other = in_mujoco(p, 1e-3);
    const double q = between(-3, 3), v = between(-9, 9), command = between(-1, 1) * 0.1;
    other.data->qpos[0] = q, other.data->qvel[0] = v, other.data->ctrl[0] = command;
    mj_forward(other.model.get(), other.data.get());
    const Drive<double> drive = drive_of(p);
    const Imposed<double> now{command, p.gain, 1, true, inertia_of(p), p.mass * p.length * 9.81};
    const Forces<double> f = forces_at(drive, now, p.gain * (command - q), q);
    const double a = (f.motor - f.against - f.damping * v) / (inertia_of(p) + p.armature);
    RC_ASSERT(std::abs(a - other.data->qacc[0]) < 1e-10 * (1 + std::abs(a)));
  });
}

TEST_CASE("a log that is rolled out is MuJoCo's, as far as steps that are halved foretell") {
  const Pendulum p{0.5, 0.12, 3.6, 0.6, 0.006, 0.25, 0.4};
  MotionLog log = test_log(drive_of(p), 4, 0);
  log.gain = p.gain, log.inertia = inertia_of(p), log.gravity = p.mass * p.length * 9.81;
  std::fill(log.supply.begin(), log.supply.end(), 1.0);
  constexpr int steps_a_reading = 50;
  const InMujoco other = in_mujoco(p, 0.01 / steps_a_reading);
  const auto by_steps_of = [&](double step) {
    step *= 1 + 1e-9;  // a whole number of steps goes into 10 ms, whatever rounding says
    return angles_of(drive_of(p), log, {0, 0, log.time.size(), step}, 0.0, 0.0);
  };
  const std::vector<double> coarse = by_steps_of(2.5e-4), fine = by_steps_of(1.25e-4);
  double most = 0;
  for (std::size_t k = 0; k < log.time.size(); ++k) {
    const double extrapolated = fine[k] + (fine[k] - coarse[k]) / 3;
    CHECK(std::abs(extrapolated - other.data->qpos[0]) < 3e-8);
    most = std::max(most, std::abs(fine[k] - coarse[k]));
    other.data->ctrl[0] = log.command[k];
    for (int i = 0; i < steps_a_reading; ++i) mj_step(other.model.get(), other.data.get());
  }
  // Halved steps differ by h^2, 6e-8 s^2, times some 100 rad/s^2. The order that is left is smaller by h
  // times the fastest rate, 20 1/s, at least: 5e-3 of 6e-6, and less where commands do not jump.
  CHECK(most < 1e-5);
}

}  // namespace plumbline::motion
