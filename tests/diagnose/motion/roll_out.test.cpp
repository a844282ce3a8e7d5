#include "diagnose/motion/roll_out.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {

TEST_CASE("the mean of a held signal is exact, and so is its derivative by the delay") {
  const std::vector<double> time{0, 1, 2}, value{1, 3, 7};
  CHECK(HeldSignal(time, value).mean(0.5, 1.0, 0.0) == close_to(2));  // half of 1, half of 3
  CHECK(HeldSignal(time, value).mean(0.5, 2.0, 0.25) == close_to(0.75 / 2 * 1 + 0.5 * 3 + 0.25 / 2 * 7));
  CHECK(HeldSignal(time, value).mean(5.0, 1.0, 0.0) == close_to(7));  // holds its last value
  const auto late = HeldSignal(time, value).mean(0.5, 1.0, Dual<1>::variable(0.0, 0));
  CHECK(late.derivative(0) == close_to(-2));  // a later signal has more of 1 and less of 3
}

TEST_CASE("a delay of whole readings is a command that is shifted by them") {
  const MotionLog log = test_log(planted_drive(Term::command_delay, 0.03), 8, 0);
  MotionLog shifted = log;
  for (std::size_t k = 0; k < log.time.size(); ++k) shifted.command[k] = log.command[k < 3 ? 0 : k - 3];
  const Segment whole{0, 0, log.time.size()};
  const std::vector<double> late = angles_of(planted_drive(Term::command_delay, 0.03), log, whole, 0.1, 0.0),
                            other =
                                angles_of(planted_drive(Term::command_delay, 0), shifted, whole, 0.1, 0.0);
  // Stamps are multiples of 10 ms to rounding alone, which moves a jump of the command by so little.
  for (std::size_t k = 0; k < late.size(); ++k) CHECK(late[k] == doctest::Approx(other[k]).epsilon(1e-9));
}

TEST_CASE("the error of a roll-out falls with the square of its step, stops and turns included") {
  const Drive<double> drive = planted_drive(Term::command_delay, 0);
  const MotionLog log = test_log(drive, 8, 0);
  const auto angles = [&](double step) {
    return angles_of(drive, log, {0, 0, log.time.size(), step}, 0.1, 0.0);
  };
  const std::vector<double> exact = angles(1e-4);
  const auto error = [&](double step) {
    const std::vector<double> coarse = angles(step);
    double sum = 0;
    for (std::size_t k = 0; k < coarse.size(); ++k) sum += std::pow(coarse[k] - exact[k], 2);
    return std::sqrt(sum);
  };
  // Orders of 1 and 3 would be factors of 2 and 8.
  const double factor = error(0.005) / error(0.0025);
  CHECK(factor > std::sqrt(2.0 * 4));
  CHECK(factor < std::sqrt(4.0 * 8));
}

TEST_CASE("sensitivities are those of differences") {
  using Number = Dual<1>;
  const MotionLog log = test_log(planted_drive(Term::command_delay, 0.02), 8, 0);
  const Segment part{0, 0, 60};
  for (const Term term : {Term::stall_torque, Term::armature, Term::zero, Term::viscous, Term::command_delay,
                          Term::loss_driving, Term::command_scale, Term::load_mass, Term::drive_lag}) {
    CAPTURE(static_cast<int>(term));
    Drive<double> drive = planted_drive(Term::loss_driven, 0.2);
    drive[Term::command_delay] = 0.0213, drive[Term::loss_driving] = 0.1, drive[Term::drive_lag] = 0.01;
    Drive<Number> carried = carried_by<Number>(drive);
    carried[term].derivative(0) = 1;
    const std::vector<Number> angle = angles_of(carried, log, part, Number(0.1), Number(0));
    constexpr double step = 1e-6;
    Drive<double> more = drive, less = drive;
    more[term] += step, less[term] -= step;
    const double difference =
        (angles_of(more, log, part, 0.1, 0.0).back() - angles_of(less, log, part, 0.1, 0.0).back()) /
        (2 * step);
    // Central differences: rounding 1e-16 / 1e-6, and steps in which friction changes sides.
    CHECK(angle.back().derivative(0) == doctest::Approx(difference).epsilon(1e-4));
  }
}

}  // namespace plumbline::motion
