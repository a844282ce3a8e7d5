#include "diagnose/rig/characteristic_scales.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {
namespace {

double or_zero(double value) {
  return std::isfinite(value) ? value : 0.0;
}

/// The force that nine readings of ten stay below, on the end point or, of loads along the chain, as if
/// there.
double typical_force(const Experiment& experiment) {
  const std::vector<LoadChannel> loads =
      load_channels(experiment.loads, experiment.link_length, experiment.covariates);
  std::vector<double> force;
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) {
      force.push_back(std::hypot(or_zero(reading[column_Fx]), or_zero(reading[column_Fy])));
      for (const LoadChannel& load : loads)
        force.back() =
            std::max(force.back(), std::abs(reading.covariates[load.covariate]) * load.moves.norm());
    }
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

template <class Says>
bool any_reading(const Run& run, Says says) {
  return std::any_of(run.readings.begin(), run.readings.end(), says);
}

bool reads_force(const Run& run) {
  return run.holds_end_point() && any_reading(run, [](const Reading& reading) {
           return std::isfinite(reading[column_Fx]) || std::isfinite(reading[column_Fy]);
         });
}

bool reads_both_forces(const Run& run) {
  return run.holds_end_point() &&
         any_reading(run, [](const Reading& reading) { return std::isfinite(reading[column_Fx]); }) &&
         any_reading(run, [](const Reading& reading) { return std::isfinite(reading[column_Fy]); });
}

/// How the run loads the chain, or the joint, and by which sensor.
void find_loading(const Run& run, CharacteristicScales& size) {
  const bool reads = reads_force(run), senses = reads || !(run.holds_end_point() || run.by_weights);
  if (run.alone != Alone::no) {
    size.reads_load = size.reads_load || reads;
    size.load_sensor = size.load_sensor || senses;
    return;
  }
  const auto loaded = [&](const Reading& one) { return run.imposed_at(one).norm() > 0; };
  size.measures_force = size.measures_force || reads;
  size.imposes_force = size.imposes_force || (!run.holds_end_point() && any_reading(run, loaded));
  size.pivot = size.pivot || !run.by_weights;
  size.load_cell = size.load_cell || senses;
  size.measures_both_forces = size.measures_both_forces || reads_both_forces(run);
}

/// The largest force component that is read, and how many readings come as near to it as noise allows.
void find_plateau(const Experiment& experiment, CharacteristicScales& size) {
  const auto each_component = [&](auto use) {
    for (const Run& run : experiment.runs)
      for (const Reading& reading : run.readings) {
        if (!run.holds_end_point() || run.alone != Alone::no) continue;
        use(std::abs(or_zero(reading[column_Fx])), experiment.noise[Channel::Name::Fx]);
        use(std::abs(or_zero(reading[column_Fy])), experiment.noise[Channel::Name::Fy]);
      }
  };
  each_component([&](double force, double) { size.largest_reading = std::max(size.largest_reading, force); });
  constexpr double scatter = 5;  // sigma: of the largest of many readings, and of one at its side
  each_component([&](double force, double sigma) {
    size.at_largest += force > 0 && force >= size.largest_reading - scatter * sigma;
  });
}

/// Whether weights of known masses, without a sensor, load an arm.
bool reads_wrench(const Run& run) {
  return !run.by_weights && any_reading(run, [](const Reading& reading) { return !reading.wrench.empty(); });
}

/// Scales of loads on an arm in space, and what its joints do.
void add_arm(const Experiment& experiment, CharacteristicScales& size) {
  const SerialArm<double>& arm = experiment.arm->arm;
  size.arm = experiment.arm;
  size.moves.assign(arm.size(), false);
  double mass = 0, force = 0;
  for (const ArmLink<double>& link : arm.links) {
    mass += link.mass;
    size.yields = size.yields || link.joint_compliance > 0 || yields(link);
  }
  for (const Run& run : experiment.runs) {
    size.load_cell = size.load_cell || reads_wrench(run);
    for (const Reading& reading : run.readings) {
      force = std::max(force, reading.wrench_force().norm());
      size.warms = size.warms || reading.covariates != experiment.runs.front().readings.front().covariates;
      for (std::size_t j = 0; j < arm.size(); ++j)
        size.moves[j] = size.moves[j] || std::abs(reading.rest[j] - experiment.runs.front().rest[j]) > 1e-3;
    }
  }
  for (const MeasuredPoint& point : experiment.arm_bench.points)
    size.tool_is_measured = size.tool_is_measured || point.at.link + 1 == arm.size();
  const double kilogram = 1, weight = mass * arm.gravity.norm();
  size.imposes_force = force > 0;
  size.mass = mass > 0 ? mass / static_cast<double>(arm.size()) : kilogram;
  size.nominal_weight = weight > 0;
  size.weighs = true;
  size.force = std::max({force, 0.3 * weight, 1e-3 * standard_gravity});
  size.torque = 0.3 * size.force * size.length;
  constexpr double yields_little = 1e-3;  // rad, of joints that are modelled as rigid, under a typical torque
  if (!(size.stiffness > 0)) size.stiffness = size.torque / yields_little;
  size.deflection = std::clamp(size.torque / size.stiffness, 1e-6, 1.0);
}

}  // namespace

CharacteristicScales characteristic_scales(const Experiment& experiment) {
  CharacteristicScales size;
  size.links = experiment.alone == Alone::no;
  size.joint_stiffness = experiment.joint_stiffness;
  size.link_length = experiment.link_length;
  double elastic = 0;
  for (const double k : experiment.joint_stiffness) {
    size.stiffness += k;
    elastic += k > 0;
  }
  size.stiffness /= std::max(1.0, elastic);
  for (const double length : experiment.link_length) size.length += length;
  size.link = size.length / static_cast<double>(experiment.link_length.size());
  for (const Run& run : experiment.runs) {
    if (!run.readings.empty())
      size.duration = std::max(size.duration, run.readings.back().t - run.readings.front().t);
    if (const double pause = run.sampling_interval(); pause > 0)
      size.sampling_interval = size.sampling_interval > 0 ? std::min(size.sampling_interval, pause) : pause;
    size.clock = size.clock || !run.counts_readings();
    find_loading(run, size);
    for (const Channel& channel : run.measured())
      if (!run.planned.empty() ||
          any_reading(run, [&](const Reading& reading) { return std::isfinite(channel.of(reading)); }))
        size.measured[static_cast<std::size_t>(channel.name)] = true;
    size.turns_back = size.turns_back || run.turns_back();
    size.bent_at_rest = size.bent_at_rest || std::any_of(run.rest.begin() + 1, run.rest.end(),
                                                         [](double angle) { return angle != 0; });
  }
  size.runs = experiment.run_count;
  find_plateau(experiment, size);
  find_tendons(experiment, size);
  // Without forces, as in a sag test, the typical force turns a joint by a tenth of a radian.
  const double force = typical_force(experiment), unit = size.stiffness / size.length;
  size.force = force > 0 ? std::max(force, 1e-4 * unit) : 0.1 * unit;
  size.duration = std::max(size.duration, 1e-3);
  size.sampling_interval = size.sampling_interval > 0 ? size.sampling_interval : size.duration;
  // The deflection that the force gives a lever of half the chain, kept to what angles can be.
  size.deflection = std::clamp(0.3 * size.force * size.length / size.stiffness, 1e-4, 1.0);
  // Flexures turn by a fraction of a milliradian: what is typical of arms would be out of all proportion.
  constexpr double hardly = 0.01;
  if (force > 0) size.turn = std::min(1.0, size.deflection / hardly);
  const bool falls = experiment.gravity[0] != 0 || experiment.gravity[1] != 0;
  size.nominal_weight = falls && std::any_of(experiment.link_mass.begin(), experiment.link_mass.end(),
                                             [](double mass) { return mass > 0; });
  size.weighs = experiment.bench.plane != Bench::Plane::horizontal;
  if (experiment.arm) add_arm(experiment, size);
  return size;
}

}  // namespace plumbline::diagnose
