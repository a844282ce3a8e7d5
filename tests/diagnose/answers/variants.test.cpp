/// \file
/// Ten benches of each of the kinds of tests/cases, with other numbers: the statics are solved here, from the
/// formulas alone.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/screening/conventions.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * uniform_(engine_); }
  double noise(double sigma) { return sigma * normal_(engine_); }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> uniform_;
  std::normal_distribution<double> normal_;
};

/// The root of a rising function.
double root(const std::function<double(double)>& torque, double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (torque(middle) > 0 ? high : low) = middle;
  }
  return (low + high) / 2;
}

/// One link in a vertical plane in which it hangs at angle 0, or in a horizontal plane.
Experiment lever(double length, double stiffness, Bench::Plane plane, const Noise& noise) {
  Experiment experiment;
  experiment.name = "variant";
  experiment.link_length = {length};
  experiment.joint_stiffness = {stiffness};
  experiment.link_mass = {0};
  experiment.gravity = {0, 0};
  experiment.bench = {plane, {1, 0}, plane == Bench::Plane::vertical};
  experiment.noise = noise;
  return experiment;
}

Run commanded(const std::vector<double>& commands, const std::vector<double>& reached) {
  Run run{"commanded", Control::force, {commands.front()}, {}};
  run.by_weights = true;
  for (std::size_t i = 0; i < commands.size(); ++i)
    run.readings.push_back({0.5 * static_cast<double>(i),
                            chain_values(nan_value(), nan_value(), 0, 0, {reached[i]}),
                            {commands[i]}});
  return run;
}

/// A servo joint that its arm's weight holds back, in a few poses.
Experiment sag(Dice& dice) {
  const double k = dice.between(15, 40), weight = dice.between(0.3, 0.5) * k, sigma = dice.between(0.05, 0.3);
  Experiment experiment = lever(0.5, k, Bench::Plane::vertical, {0, 0, 0, 0, 0.1 * degree});
  std::vector<double> commands, reached;
  for (double angle = 20 + dice.between(0, 10); angle < 90; angle += dice.between(10, 16)) {
    const double command = angle * degree;
    const auto torque = [&](double q) { return k * (q - command) + weight * std::sin(q); };
    commands.push_back(command);
    reached.push_back(root(torque, -2, 2) + dice.noise(sigma * degree));
  }
  experiment.runs = {commanded(commands, reached)};
  return experiment;
}

/// A servo joint with weight and dry friction, swept there and back.
Experiment sweep(Dice& dice) {
  const double k = dice.between(15, 40), weight = dice.between(0.2, 0.4) * k,
               friction = dice.between(0.03, 0.08) * k;
  Experiment experiment = lever(0.5, k, Bench::Plane::vertical, {0, 0, 0, 0, 0.1 * degree});
  std::vector<double> commands, reached;
  double q = -1;  // it comes from below
  for (int i = 0; i <= 60; ++i) {
    const double command = 0.05 * (30 - std::abs(30 - i));
    const auto up = [&](double a) { return k * (a - command) + weight * std::sin(a) + friction; };
    const auto down = [&](double a) { return up(a) - 2 * friction; };
    q = std::min(std::max(q, root(up, -2, 2)), root(down, -2, 2));
    commands.push_back(command);
    reached.push_back(q + dice.noise(0.1 * degree));
  }
  experiment.runs = {commanded(commands, reached)};
  experiment.runs[0].begins_moving = true;
  return experiment;
}

/// A lever under the forces along y, with a torque law of its own.
Experiment pulled(Dice& dice, double length, double k, const std::vector<double>& forces,
                  const std::function<double(double)>& law, double sigma) {
  Experiment experiment = lever(length, k, Bench::Plane::horizontal, {0, 0, 0, 0, sigma});
  Run run{"pull", Control::force, {0}, {}};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto torque = [&](double q) { return law(q) - forces[i] * length * std::cos(q); };
    run.readings.push_back(
        {2.0 * static_cast<double>(i), chain_values(nan_value(), nan_value(), 0, forces[i],
                                                    {root(torque, -1.5, 1.5) + dice.noise(sigma)})});
  }
  run.by_weights = true;
  experiment.runs = {run};
  return experiment;
}

/// A spring that is too soft, under loads whose signs alternate, or which are taken off in between.
Experiment soft(Dice& dice, bool alternating) {
  const double k = dice.between(1, 5), length = dice.between(0.2, 0.4),
               own = (1 - dice.between(0.1, 0.3)) * k;
  std::vector<double> forces;
  for (int i = 0; i < 20; ++i) {
    const double size = 0.3 * k / length * (i / 2 + 1) / 10;
    forces.push_back(i % 2 == 0 ? size : alternating ? -size : 0);
  }
  return pulled(
      dice, length, k, forces, [=](double q) { return own * q; }, dice.between(0.5e-3, 2e-3));
}

/// A stop far stiffer than the spring, loading only.
Experiment stopped(Dice& dice) {
  const double k = dice.between(1, 5), length = dice.between(0.08, 0.2), stop = dice.between(0.04, 0.1),
               stiff = dice.between(30, 120) * k;
  std::vector<double> forces;
  for (int i = 0; i < 30; ++i) forces.push_back(1.5 * k * stop / length * i / 29);
  const auto law = [=](double q) { return k * q + stiff * std::max(0.0, q - stop); };
  return pulled(dice, length, k, forces, law, 0.01 * stop);
}

/// Two links, the second joint passive: the force acts along the second link. A stop that the last readings
/// reach.
Experiment strut(Dice& dice, bool back) {
  const double k = dice.between(2, 5), stop = dice.between(0.04, 0.09), stiff = dice.between(60, 120) * k;
  constexpr double length = 0.1, sigma = 0.02;
  Experiment experiment = lever(length, k, Bench::Plane::horizontal, {0, 0, sigma, 0, 0});
  experiment.link_length = {length, length};
  experiment.joint_stiffness = {k, 0};
  experiment.link_mass = {0, 0};
  Run run{"press", Control::end_point, {90 * degree, -90 * degree}, {}};
  // Joint 1 at 90 degrees less d puts joint 2 at length (sin d, cos d); link 2 ends at y = length.
  const auto place = [&](double d) {
    const double rise = 1 - std::cos(d);
    return length * (std::sin(d) + std::sqrt(1 - rise * rise));
  };
  const double farthest = place(stop * 1.06);  // two of thirty readings are beyond the stop
  for (int i = 0; i < (back ? 60 : 30); ++i) {
    const double share = (i < 30 ? i : 59 - i) / 29.0, x = length + share * (farthest - length);
    const double d = root([&](double a) { return place(a) - x; }, 0, 0.5), rise = 1 - std::cos(d);
    const double torque = k * d + stiff * std::max(0.0, d - stop);
    // The force (f cos b, f sin b) along link 2 at slope b has the moment -f length cos(d + b) about joint 1.
    const double b = std::asin(rise), f = torque / (length * std::cos(d + b));
    run.readings.push_back({static_cast<double>(i), {x, length, f * std::cos(b) + dice.noise(sigma)}});
  }
  experiment.runs = {run};
  return experiment;
}

/// Two servo joints in six poses with a weight at the end point.
Experiment payload(Dice& dice) {
  const double weight = dice.between(5, 12);
  const std::vector<double> k{dice.between(18, 30), dice.between(12, 20)};
  Experiment experiment = lever(0.3, k[0], Bench::Plane::vertical, {0, 0, 0, 0, 0.1 * degree});
  experiment.link_length = {0.3, 0.3};
  experiment.joint_stiffness = k;
  experiment.link_mass = {0, 0};
  for (int pose = 0; pose < 6; ++pose) {
    const std::vector<double> rest{dice.between(0, 90) * degree, dice.between(-30, 90) * degree};
    double q1 = rest[0], q2 = rest[1];
    for (int i = 0; i < 2000;
         ++i) {  // a contraction: the weight is less than the springs by a factor of three
      const double t2 = -weight * 0.3 * std::sin(q1 + q2), t1 = t2 - weight * 0.3 * std::sin(q1);
      q1 += 0.2 * (rest[0] + t1 / k[0] - q1), q2 += 0.2 * (rest[1] + t2 / k[1] - q2);
    }
    Run run{"pose " + std::to_string(pose), Control::force, rest, {}};
    run.by_weights = true;
    run.readings.push_back({0, chain_values(nan_value(), nan_value(), 0, 0,
                                            {q1 + dice.noise(0.1 * degree), q2 + dice.noise(0.1 * degree)})});
    experiment.runs.push_back(run);
  }
  return experiment;
}

/// Torque of a joint alone that is turned there and back twice.
Experiment loop(Dice& dice) {
  const double k = dice.between(50, 500), friction = dice.between(0.05, 0.2) * k * 0.05;
  Experiment experiment = lever(1, k, Bench::Plane::horizontal, {});
  experiment.device = Device::turning_joint;
  experiment.noise[Channel::Name::torque] = 0.05 * friction;
  Run run{"loop", Control::end_point, {0}, {}};
  run.device = Device::turning_joint;
  double last = 0, rub = 0;
  for (int i = 0; i <= 60; ++i) {
    const double q = 0.05 * std::sin(4 * std::numbers::pi * i / 60);
    rub = std::clamp(rub + 1e6 * k * (q - last), -friction, friction);
    last = q;
    run.readings.push_back({0.5 * i, {q, 0, k * q + rub + dice.noise(0.05 * friction), 0}});
  }
  experiment.runs = {run};
  return experiment;
}

/// A flexure that turns by 0.3 mrad under weights.
Experiment flexure(Dice& dice) {
  const double k = dice.between(1, 4), own = (1 + dice.between(0.05, 0.3)) * k;
  Experiment experiment = lever(1, k, Bench::Plane::horizontal, {});
  experiment.device = Device::turning_joint;
  experiment.noise[Channel::Name::angle] = 5e-7;
  Run run{"weights", Control::force, {0}, {}};
  run.device = Device::turning_joint;
  run.by_weights = true;
  for (int i = 0; i <= 14; ++i) {
    const double torque = 3e-4 * k * (7 - std::abs(7 - i)) / 7;
    run.readings.push_back({2.0 * i, {torque / own + dice.noise(5e-7), 0, torque, 0}});
  }
  experiment.runs = {run};
  return experiment;
}

/// Whether a cause of exactly these effects is among those named.
bool causes_hold(const Diagnosis& diagnosis, std::vector<std::string> effects) {
  std::sort(effects.begin(), effects.end());
  for (std::size_t i = 0; i < diagnosis.cause.named; ++i) {
    std::vector<std::string> own;
    for (const EffectAt& at : diagnosis.cause.ranking[i].cause.effects) own.push_back(at.label());
    std::sort(own.begin(), own.end());
    if (own == effects) return true;
  }
  return false;
}

struct Kind {
  const char* name;
  std::function<Experiment(Dice&)> make;
  std::vector<std::string> effects;
  int least;  ///< right ones of ten
};

}  // namespace

TEST_CASE("ten variants of each kind of bench" * doctest::test_suite("long")) {
  const std::vector<Kind> kinds{
      {"servo sag", sag, {"gravity"}, 9},
      {"servo sweep", sweep, {"gravity", "joint_friction"}, 9},
      {"alternating", [](Dice& dice) { return soft(dice, true); }, {"joint_stiffness(1)"}, 9},
      {"zero return", [](Dice& dice) { return soft(dice, false); }, {"joint_stiffness(1)"}, 9},
      {"stiff stop", stopped, {"joint_stop(1)"}, 9},
      {"two readings at the end", [](Dice& dice) { return strut(dice, false); }, {"joint_stop(1)"}, 9},
      {"two readings at the turn", [](Dice& dice) { return strut(dice, true); }, {"joint_stop(1)"}, 9},
      {"sag with payload", payload, {"tip_payload"}, 9},
      {"joint loop", loop, {"joint_friction"}, 9},
      {"flexure", flexure, {"joint_stiffness(1)"}, 9},
  };
  for (const Kind& kind : kinds) {
    int right = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      Dice dice(seed);
      const Diagnosis diagnosis = diagnose::diagnose(Study(kind.make(dice)));
      const bool named = causes_hold(diagnosis, kind.effects);
      right += named;
      if (!named)
        MESSAGE(std::string(kind.name), ", seed ", seed, ": ",
                (diagnosis.cause.ranking.empty() ? std::string("no gap")
                                                 : diagnosis.cause.ranking.front().cause.label()));
    }
    MESSAGE(std::string(kind.name), ": ", right, " of 10");
    CHECK(right >= kind.least);
  }
}

TEST_CASE("the run in another unit is asked about, alone and by its factor" * doctest::test_suite("long")) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const double k = dice.between(1, 5), length = dice.between(0.1, 0.3);
    std::vector<double> forces;
    for (int i = 0; i < 20; ++i) forces.push_back(0.5 * k / length * i / 20);
    const auto law = [=](double q) { return k * q; };
    Experiment experiment = pulled(dice, length, k, forces, law, 2e-4);
    experiment.runs.push_back(pulled(dice, length, k, forces, law, 2e-4).runs[0]);
    experiment.runs[0].id = "a", experiment.runs[1].id = "b";
    for (Reading& one : experiment.runs[1].readings) one[column_Fy] *= 10;
    const auto doubt = suspected_convention(Study(experiment));
    REQUIRE(doubt);
    CHECK(doubt->looks_like == "numbers ten times as large");
    CHECK(doubt->runs == std::vector<std::string>{"b"});
  }
}
