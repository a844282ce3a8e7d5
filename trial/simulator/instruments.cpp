#include "trial/simulator/instruments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plumbline::simulator {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The load cell turns with the rail, and feels the friction of the guide.
Pair load_cell(const Physics& is, const PlannedRun& run, const State& state, double direction) {
  const double c = std::cos(is.misalignment), s = std::sin(is.misalignment);
  const Pair turned{c * state.force[0] + s * state.force[1], c * state.force[1] - s * state.force[0]};
  const Pair mixed{turned[0] + is.cross_talk[0] * turned[1], turned[1] + is.cross_talk[1] * turned[0]};
  const double wave = std::sin(2 * std::numbers::pi * state.t / is.zero.period);
  const double warm = -std::expm1(-state.t / is.warming_time);
  Pair shown;
  for (std::size_t a = 0; a < 2; ++a) {
    shown[a] = (1 + is.gain) * mixed[a] * (1 + is.curvature[a] * mixed[a]) + is.bias[a] +
               is.drift[a] * state.t + is.zero.amplitude[a] * wave + is.warming[a] * warm + is.tare(run)[a];
  }
  shown[0] += is.guide_friction * direction;
  return shown;
}

/// First-order lag for forces that change linearly between readings.
void let_lag(Readings& readings, double lag) {
  Pair shown = readings.front().force, before = shown;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double dt = readings[i].t - readings[i - 1].t, left = std::exp(-dt / lag);
    for (std::size_t a = 0; a < 2; ++a) {
      const double now = readings[i].force[a], rate = (now - before[a]) / dt;
      shown[a] = now - rate * lag + left * (shown[a] - before[a] + rate * lag);
      before[a] = now;
      readings[i].force[a] = shown[a];
    }
  }
}

/// A load cell with hysteresis: below the largest force so far it shows more.
void let_loop(Readings& readings, double loop) {
  for (std::size_t a = 0; a < 2; ++a) {
    double largest = 0;
    for (Reading& one : readings) {
      const double size = std::abs(one.force[a]);
      largest = std::max(largest, size);
      if (largest > 0) one.force[a] *= 1 + 4 * loop * (largest - size) / largest;
    }
  }
}

/// Noise of one channel along a run.
class Channel {
 public:
  /// \param sensor  its number in what is told by sensor
  Channel(const std::string& name, double Sigma::*sensor, const Scatter& scatter, Random& random)
      : sigma_((name == scatter.bad_channel ? scatter.bad_factor : 1) * scatter.sigma.*sensor),
        share_(scatter.proportional.*sensor),
        correlation_(scatter.correlation.*sensor),
        scatter_(scatter),
        random_(random),
        last_(random.normal()) {}

  double operator()(double value, double t) {
    if (sigma_ == 0 || std::isnan(value)) return value;
    const double r = correlation_;
    last_ = r * last_ + std::sqrt(1 - r * r) * random_.normal();
    double shown = value + std::hypot(sigma_, share_ * value) * last_;
    if (scatter_.interference > 0)
      shown +=
          scatter_.interference * sigma_ * std::sin(2 * std::numbers::pi * t / scatter_.interference_period);
    if (random_.chance(scatter_.outliers)) shown += random_.sign() * random_.uniform(8, 25) * sigma_;
    if (scatter_.resolution > 0) shown = rounded(shown, significant(scatter_.resolution * sigma_, 1));
    return random_.chance(scatter_.missing) ? nothing : shown;
  }

 private:
  double sigma_, share_, correlation_;
  const Scatter& scatter_;
  Random& random_;
  double last_;
};

}  // namespace

Readings show(const Plan& plan, const Physics& physics, const PlannedRun& run,
              const std::vector<State>& states) {
  Readings readings;
  double direction = 0;  // of the last motion along x
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State& state = states[i];
    const Pair& told = run.commands[i].value;
    Reading reading{state.t, told, told, {}};
    if (run.force_controlled) {
      reading.end_point = state.end_point;
    } else {
      const double motion = i > 0 ? told[0] - run.commands[i - 1].value[0] : 0;
      if (motion != 0) direction = std::copysign(1, motion);
      reading.force = load_cell(physics, run, state, direction);
    }
    if (plan.angles_measured) reading.q = state.q;
    readings.push_back(std::move(reading));
  }
  if (run.force_controlled) return readings;
  if (physics.cell_loop != 0) let_loop(readings, physics.cell_loop);
  if (physics.lag > 0) let_lag(readings, physics.lag);
  for (Reading& one : readings) {
    for (double& force : one.force) force = std::clamp(force, -physics.saturation, physics.saturation);
    if (!plan.cross_force_measured) one.force[1] = nothing;
  }
  return readings;
}

Readings scattered(const PlannedRun& run, Readings readings, const Scatter& scatter, Random& random) {
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string name(1, "xy"[a]);
    Channel channel(run.force_controlled ? name : "F" + name,
                    run.force_controlled ? &Sigma::position : &Sigma::force, scatter, random);
    for (Reading& one : readings) {
      double& value = run.force_controlled ? one.end_point[a] : one.force[a];
      value = channel(value, one.t);
    }
  }
  for (std::size_t j = 0; j < readings.front().q.size(); ++j) {
    Channel channel("q" + std::to_string(j + 1), &Sigma::angle, scatter, random);
    for (Reading& one : readings) one.q[j] = channel(one.q[j], one.t);
  }
  return readings;
}

std::vector<Excess> gap(const Plan& plan, const std::vector<Readings>& readings,
                        const std::vector<Readings>& reference, const Sigma& sigma) {
  std::vector<Excess> all;
  const auto add = [&](const std::string& channel, double one, double other, double unit) {
    if (!std::isnan(one)) all.push_back({channel, (one - other) / unit});
  };
  for (std::size_t r = 0; r < readings.size(); ++r) {
    for (std::size_t i = 0; i < readings[r].size(); ++i) {
      const Reading &one = readings[r][i], &other = reference[r][i];
      if (plan.runs[r].force_controlled) {
        add("x", one.end_point[0], other.end_point[0], sigma.position);
        add("y", one.end_point[1], other.end_point[1], sigma.position);
      } else {
        add("Fx", one.force[0], other.force[0], sigma.force);
        add("Fy", one.force[1], other.force[1], sigma.force);
      }
      for (std::size_t j = 0; j < one.q.size(); ++j)
        add("q" + std::to_string(j + 1), one.q[j], other.q[j], sigma.angle);
    }
  }
  return all;
}

}  // namespace plumbline::simulator
