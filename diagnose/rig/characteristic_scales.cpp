#include "diagnose/rig/characteristic_scales.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {
namespace {

double or_zero(double value) {
  return std::isfinite(value) ? value : 0.0;
}

/// The load of a reading: on the end point, on a joint alone, or on an arm; of loads along the chain, as if
/// there.
double load_of(const Reading& reading, const std::vector<LoadChannel>& along) {
  double load = std::max(std::hypot(or_zero(reading[column_Fx]), or_zero(reading[column_Fy])),
                         reading.wrench_force().norm());
  for (const LoadChannel& one : along)
    load = std::max(load, std::abs(reading.covariates[one.covariate]) * one.moves.norm());
  return load;
}

/// The load that nine readings of ten stay below.
double typical_force(const Experiment& experiment) {
  const std::vector<LoadChannel> along =
      load_channels(experiment.loads, experiment.link_length, experiment.covariates);
  std::vector<double> force;
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) force.push_back(load_of(reading, along));
  if (force.empty()) return 0;
  const auto place = force.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(force.size()));
  std::nth_element(force.begin(), place, force.end());
  return *place;
}

/// What tendons and pressures do.
void find_tendons(const Experiment& experiment, CharacteristicScales& size) {
  for (const Load& load : experiment.loads) {
    const auto passed =
        std::count_if(load.moment_arm.begin(), load.moment_arm.end(), [](double arm) { return arm != 0; });
    size.turned_by_loads = size.turned_by_loads || passed > 0;
    size.long_tendon = size.long_tendon || (load.kind == Load::Kind::tendon && passed > 1);
  }
}

/// The loads along the chain, and the covariates that are none.
void find_covariates(const Experiment& experiment, CharacteristicScales& size) {
  for (const LoadChannel& one :
       load_channels(experiment.loads, experiment.link_length, experiment.covariates)) {
    AppliedLoad load{one.covariate, 0};
    for (const Run& run : experiment.runs)
      for (const Reading& reading : run.readings)
        load.largest = std::max(load.largest, std::abs(reading.covariates[load.covariate]));
    size.applied.push_back(load);
  }
  for (std::size_t c = 0; c < experiment.covariates.size(); ++c)
    if (std::none_of(size.applied.begin(), size.applied.end(),
                     [&](const AppliedLoad& one) { return one.covariate == c; }))
      size.covariates.push_back(c);
}

/// A channel that some reading has.
void take(const Channel& channel, CharacteristicScales& size) {
  size.measured[static_cast<std::size_t>(channel.name)] = true;
  std::vector<Channel>& beside = size.beside_tracker;
  if (channel.kind().index == ChannelKind::Index::sensor &&
      std::find(beside.begin(), beside.end(), channel) == beside.end())
    beside.push_back(channel);
}

template <class Says>
bool any_reading(const Run& run, Says says) {
  return std::any_of(run.readings.begin(), run.readings.end(), says);
}

bool reads_force(const Run& run) {
  return run.holds_end_point() && any_reading(run, [](const Reading& reading) {
           return std::isfinite(reading[column_Fx]) || std::isfinite(reading[column_Fy]);
         });
}

/// Whether a load cell reads both components: those that answer, or those to which a servo regulates.
bool reads_both_forces(const Run& run) {
  const auto reads = [&](ChannelColumn component) {
    return any_reading(run, [&](const Reading& reading) {
      return std::isfinite(reading[component]) && (run.holds_end_point() || reading[component] != 0);
    });
  };
  return (run.holds_end_point() || !run.by_weights) && reads(column_Fx) && reads(column_Fy);
}

/// Whether a sensor, not known weights, says what loads an arm.
bool reads_wrench(const Run& run) {
  return !run.by_weights && any_reading(run, [](const Reading& reading) { return !reading.wrench.empty(); });
}

/// How the run loads the device, and by which sensor.
void find_loading(const Run& run, bool has_end, CharacteristicScales& size) {
  const bool reads = reads_force(run);
  size.measures_force = size.measures_force || reads;
  size.load_cell = size.load_cell || reads || reads_wrench(run) ||
                   (size.axes < 3 && !(run.holds_end_point() || run.by_weights));
  size.drives = size.drives || run.commands_joints() || !run.by_weights;
  const bool loaded = any_reading(run, [](const Reading& one) { return load_of(one, {}) > 0; });
  size.imposes_force = size.imposes_force || (!run.holds_end_point() && loaded);
  if (!has_end) return;
  size.end_is_loaded = size.end_is_loaded || run.holds_end_point() || loaded;
  size.pivot = size.pivot || !run.by_weights;
  size.measures_both_forces = size.measures_both_forces || reads_both_forces(run);
}

/// The largest force component that is read, and how many readings come as near to it as noise allows.
void find_plateau(const Experiment& experiment, CharacteristicScales& size) {
  const auto each_component = [&](auto use) {
    for (const Run& run : experiment.runs)
      for (const Channel& channel : run.answering())
        for (const Reading& reading : run.readings)
          if (channel.sensor() == Sensor::force)
            use(std::abs(or_zero(channel.of(reading))), channel.sigma(experiment.noise));
  };
  each_component([&](double force, double) { size.largest_reading = std::max(size.largest_reading, force); });
  constexpr double scatter = 5;  // sigma: of the largest of many readings, and of one at its side
  each_component([&](double force, double sigma) {
    size.at_largest += force > 0 && force >= size.largest_reading - scatter * sigma;
  });
}

/// The joints and links, and whether they weigh anything.
void find_device(const Experiment& experiment, CharacteristicScales& size) {
  const std::size_t n = experiment.joint_stiffness.size();
  size.joint_stiffness = experiment.joint_stiffness;
  size.link_length = experiment.link_length;
  size.link_mass = experiment.link_mass;
  size.link_mass.resize(n, 0.0);
  size.reach = experiment.link_length;
  size.axes = experiment.end().axes;
  for (std::size_t j = 0; j < n; ++j) size.slides.push_back(experiment.slides(j));
  size.rigid.assign(n, false);
  double gravity = std::hypot(experiment.gravity[0], experiment.gravity[1]);
  size.weighs = experiment.bench.plane != Bench::Plane::horizontal;
  if (experiment.arm) {
    const SerialArm<double>& arm = experiment.arm->arm;
    size.reads_encoders = true;
    for (std::size_t j = 0; j < n; ++j) {
      size.rigid[j] = !(experiment.joint_stiffness[j] > 0);
      size.reach[j] = arm.far_end(j).translation().norm();
    }
    gravity = arm.gravity.norm();
    size.weighs = gravity > 0;
    for (const MeasuredPoint& point : experiment.arm_bench.points)
      size.tool_is_measured = size.tool_is_measured || point.at.link + 1 == n;
  }
  for (const double length : experiment.link_length) size.length += length;
  size.link = size.length / static_cast<double>(n);
  for (const double mass : size.link_mass) size.mass += mass / static_cast<double>(n);
  size.nominal_weight = gravity > 0 && size.mass > 0;
  size.gravity = gravity > 0 ? gravity : standard_gravity;
  double elastic = 0;
  for (const double k : experiment.joint_stiffness) {
    size.stiffness += k;
    elastic += k > 0;
  }
  size.stiffness /= std::max(1.0, elastic);
}

/// Which commands change, and whether the temperature does.
void find_motion(const Experiment& experiment, CharacteristicScales& size) {
  const std::size_t n = size.joint_stiffness.size();
  size.moves.assign(n, false);
  size.least_command = size.largest_command =
      experiment.runs.empty() ? std::vector<double>(n, 0.0) : experiment.runs.front().rest;
  constexpr double still = 1e-3;  // rad or m
  const bool noted = std::find(experiment.covariates.begin(), experiment.covariates.end(), "temperature") !=
                     experiment.covariates.end();
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) {
      size.warms = size.warms || (noted && size.axes == 3 &&
                                  reading.covariates != experiment.runs.front().readings.front().covariates);
      for (std::size_t j = 0; j < reading.rest.size(); ++j) {
        size.least_command[j] = std::min(size.least_command[j], reading.rest[j]);
        size.largest_command[j] = std::max(size.largest_command[j], reading.rest[j]);
        size.moves[j] = size.largest_command[j] - size.least_command[j] > still;
      }
    }
}

/// Whether all commands of the joints are multiples of one shape.
bool led_together(const Experiment& experiment) {
  std::vector<Eigen::VectorXd> all;
  for (const Run& run : experiment.runs)
    for (const Reading& one : run.readings)
      if (!one.rest.empty())
        all.emplace_back(
            Eigen::Map<const Eigen::VectorXd>(one.rest.data(), static_cast<Eigen::Index>(one.rest.size())));
  const auto farthest = std::max_element(all.begin(), all.end(),
                                         [](const auto& a, const auto& b) { return a.norm() < b.norm(); });
  if (farthest == all.end() || farthest->isZero(0)) return true;
  const Eigen::VectorXd shape = farthest->normalized();
  constexpr double rounding = 1e-3;  // of degrees in tables, over the farthest
  return std::all_of(all.begin(), all.end(), [&](const Eigen::VectorXd& one) {
    return (one - one.dot(shape) * shape).norm() <= rounding * farthest->norm();
  });
}

/// Typical loads, and how far they turn a joint.
void find_sizes(const Experiment& experiment, CharacteristicScales& size) {
  const double unit = size.stiffness / size.length;
  const double weight =
      size.nominal_weight ? size.mass * static_cast<double>(size.link_mass.size()) * size.gravity : 0;
  const double force = std::max(typical_force(experiment), 0.3 * weight);
  constexpr double gram = 1e-3;  // kg
  // Without loads, as where a servo alone moves the joints, the typical one turns a joint by 0.03 rad.
  size.force = force > 0 ? std::max(force, 1e-4 * unit) : unit > 0 ? 0.1 * unit : gram * standard_gravity;
  // That on a lever of a third of the chain.
  size.torque = 0.3 * size.force * size.length;
  constexpr double yields_little = 1e-3;  // rad, of joints that are modelled as rigid
  if (!(size.stiffness > 0)) size.stiffness = size.torque / yields_little;
  if (!(size.mass > 0)) size.mass = size.force / standard_gravity;
  size.deflection = std::clamp(size.torque / size.stiffness, 1e-6, 1.0);
  // Flexures turn by a fraction of a milliradian: the angles of arms would be out of all proportion.
  constexpr double hardly = 0.01;
  const bool moves = std::find(size.moves.begin(), size.moves.end(), true) != size.moves.end();
  if (force > 0 && !moves) size.turn = std::min(1.0, size.deflection / hardly);
}

}  // namespace

std::size_t CharacteristicScales::kinds_read() const {
  return static_cast<std::size_t>(std::count(measured.begin(), measured.end(), true));
}

CharacteristicScales characteristic_scales(const Experiment& experiment) {
  CharacteristicScales size;
  find_device(experiment, size);
  find_motion(experiment, size);
  size.led_together = led_together(experiment);
  find_sizes(experiment, size);
  for (const Run& run : experiment.runs) {
    if (!run.readings.empty())
      size.duration = std::max(size.duration, run.readings.back().t - run.readings.front().t);
    if (const double pause = run.sampling_interval(); pause > 0)
      size.sampling_interval = size.sampling_interval > 0 ? std::min(size.sampling_interval, pause) : pause;
    size.clock = size.clock || !run.counts_readings();
    find_loading(run, size.axes == 2, size);
    for (const Channel& channel : run.measured())
      if (!run.planned.empty() ||
          any_reading(run, [&](const Reading& reading) { return std::isfinite(channel.of(reading)); }))
        take(channel, size);
    size.turns_back = size.turns_back || run.turns_back();
    size.bent_at_rest = size.bent_at_rest || std::any_of(run.rest.begin() + 1, run.rest.end(),
                                                         [](double angle) { return angle != 0; });
  }
  size.runs = experiment.run_count;
  find_plateau(experiment, size);
  find_tendons(experiment, size);
  find_covariates(experiment, size);
  size.duration = std::max(size.duration, 1e-3);
  size.sampling_interval = size.sampling_interval > 0 ? size.sampling_interval : size.duration;
  return size;
}

}  // namespace plumbline::diagnose
