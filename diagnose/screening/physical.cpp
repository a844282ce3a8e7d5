#include "diagnose/screening/physical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <plumbline/base/error.hpp>
#include <plumbline/chain/kinematics.hpp>

#include "diagnose/bench/conversion.hpp"
#include "diagnose/bench/end_kind.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {
namespace {

std::string metres(double value) {
  return fmt::format("{:.6g} m", value);
}

std::string place(const Run& run, std::size_t reading) {
  return "run \"" + run.id + "\", reading " + std::to_string(reading + 1);
}

/// Distance between the end point by the joint angles and by the reading; NaN where either is missing.
double contradiction(const std::vector<double>& q, const Reading& reading, const Chain<double>& chain) {
  const Point<double> end = end_point(chain, q);
  return std::hypot(end.x - reading[column_x], end.y - reading[column_y]);
}

/// Median distance between the end points by the joint angles and by the readings; 0 without joint angles.
double middle_contradiction(const Run& run, const Chain<double>& chain) {
  std::vector<double> gaps;
  for (const Reading& reading : run.readings) {
    const double gap = contradiction(reading.angles(chain.size()), reading, chain);
    if (!std::isnan(gap)) gaps.push_back(gap);
  }
  if (gaps.empty()) return 0;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

/// The first reading whose end point is out of reach. A commanded one is exact up to rounding. A measured one
/// has noise, and lengths and offsets are what is in question: only a distance beyond all tolerance counts.
std::optional<std::size_t> out_of_reach(const Run& run, const Reach<double>& limits) {
  const double slack = (run.holds_end_point() ? 1e-4 : 0.25) * limits.largest;
  for (std::size_t r = 0; r < run.readings.size(); ++r) {
    const double distance = std::hypot(run.readings[r][column_x], run.readings[r][column_y]);
    if (distance > limits.largest + slack || distance < limits.smallest - slack) return r;
  }
  return {};
}

/// The unit, order or sense in which the end points, angles or links of an impossible run become possible: ";
/// x, y look like mm (columns.x.unit = …)". Empty where no conversion brings the run within reach, to its
/// unloaded shape at the start and into agreement with its joint angles, each to a tenth of the chain.
std::string as_if(const Experiment& experiment, const Run& run) {
  std::string best;
  double least = 0.1;
  for (const Conversion& conversion : conversions(experiment)) {
    const std::string& what = conversion.what;
    if (what == "Fx, Fy" || what == "x, y, Fx, Fy") continue;
    Experiment alone = experiment;
    alone.runs = {run};
    alone = converted(std::move(alone), conversion);
    const Run& other = alone.runs.front();
    const Reach<double> limits = reach(alone.link_length);
    if (out_of_reach(other, limits)) continue;
    const auto start = std::find_if(other.readings.begin(), other.readings.end(), [](const Reading& r) {
      return std::isfinite(r[column_x]) && std::isfinite(r[column_y]);
    });
    if (start == other.readings.end()) continue;
    const Chain<double> chain(alone.link_length, alone.joint_stiffness);
    const double gap =
        std::max(contradiction(other.rest, *start, chain), middle_contradiction(other, chain)) /
        limits.largest;
    if (gap >= least) continue;
    least = gap;
    const bool several = what.find(", ") != std::string::npos;
    best = "; " + what + (several ? " look like " : " looks like ") + conversion.looks_like + ": if so, " +
           conversion.remedy;
  }
  return best;
}

void require_reach(const Experiment& experiment, const Run& run, const Reach<double>& limits) {
  const std::optional<std::size_t> r = out_of_reach(run, limits);
  if (!r) return;
  const double distance = std::hypot(run.readings[*r][column_x], run.readings[*r][column_y]);
  const std::string expected =
      distance > limits.largest
          ? "at most the length of the chain, " + metres(limits.largest)
          : "at least " + metres(limits.smallest) + ", what the links reach when folded";
  const std::string looks_like = as_if(experiment, run);
  throw Error(place(run, *r), "an end point " + metres(distance) + " from the base",
              expected + (looks_like.empty() ? "; x and y count from joint 1: where it lies elsewhere, "
                                               "columns.x.zero and columns.y.zero say where"
                                             : looks_like));
}

/// \throws Error for joint angles in degrees, in another order or of another chain: no effect moves the end point of
///         most readings by a quarter of the chain
void require_geometry(const Experiment& experiment, const Run& run) {
  const bool tells_end = std::ranges::any_of(run.readings, [](const Reading& one) {
    return std::isfinite(one[column_x]) && std::isfinite(one[column_y]);
  });
  if (!tells_end) return;
  const Reach<double> limits = reach(experiment.link_length);
  const double gap =
      middle_contradiction(run, Chain<double>(experiment.link_length, experiment.joint_stiffness));
  if (gap > 0.25 * limits.largest)
    throw Error("run \"" + run.id + "\"",
                "joint angles that put the end point " + metres(gap) + " from where x and y say it is",
                "joint angles of this chain, relative and in radians" + as_if(experiment, run));
}

/// A channel that answers is imposed by the other control, and then needs no noise.
std::string other_control(const Run& run, const Channel& channel) {
  const std::vector<Channel> answering = run.answering();
  if (run.commands_joints() || std::find(answering.begin(), answering.end(), channel) == answering.end())
    return "";
  const EndKind& end = run.end();
  const std::string_view other = run.holds_end_point() ? end.by_load : end.by_place;
  return "; where the rig imposes it: control = \"" + std::string(other) + "\"";
}

void require_noise(const Run& run, const Noise& noise) {
  for (const Channel& channel : run.measured()) {
    const bool read = std::any_of(run.readings.begin(), run.readings.end(),
                                  [&](const Reading& r) { return !std::isnan(channel.of(r)); });
    if (!read || channel.sigma(noise) > 0) continue;
    throw Error("noise." + std::string(channel.kind().noise_key), "0, or nothing",
                "a positive figure: run \"" + run.id + "\" measures it" + other_control(run, channel));
  }
}

/// What a measured value of a sensor is compared with: the reach, a radian, and the load that turns a joint
/// by a radian.
std::pair<double, std::string_view> usual_size(const Experiment& experiment, Sensor sensor, double reach) {
  switch (sensor) {
    case Sensor::position:
    case Sensor::distance:
      return {reach, "the length of the chain"};
    case Sensor::pixel:
      return {1, "a pixel"};
    case Sensor::angle:
    case Sensor::orientation:
      return {1, "a radian"};
    default:
      break;
  }
  double turning = 0;
  for (const double k : experiment.joint_stiffness) turning = std::max(turning, k / reach);
  const bool is_torque = sensor == Sensor::torque || sensor == Sensor::second_torque;
  return {turning, is_torque ? "that of a radian" : "the force that turns a joint by a radian"};
}

/// Noise below the rounding of the measured values is none, and residuals in its units overflow.
void require_resolved(const Experiment& experiment, double reach) {
  for (const ChannelKind& kind : channel_kinds) {
    auto [measured, beside] = usual_size(experiment, kind.sensor, reach);
    for (const Run& run : experiment.runs)
      for (const std::vector<Channel>& channels : {run.imposed(), run.measurable()})
        for (const Channel& channel : channels)
          for (std::size_t r = 0; channel.name == kind.name && r < run.readings.size(); ++r)
            measured = std::fmax(measured, std::abs(channel.of(run.readings[r])));
    const double sigma = experiment.noise[kind.name];
    const double least = measured * std::numeric_limits<double>::epsilon();
    if (sigma > 0 && sigma < least)
      throw Error(
          "noise." + std::string(kind.noise_key), fmt::format("{:.4g}", sigma),
          fmt::format(
              "more than the rounding of what it is the noise of, {:.2g}: a reading, or {}, is {:.2g}", least,
              beside, measured));
  }
}

std::size_t measured_values(const Run& run) {
  std::ptrdiff_t count = 0;
  for (const Channel& channel : run.measured())
    count += std::count_if(run.readings.begin(), run.readings.end(),
                           [&](const Reading& r) { return std::isfinite(channel.of(r)); });
  return static_cast<std::size_t>(count);
}

/// A channel with a noise is measured, and there must be one.
void require_anything_measured(const Run& run, const Noise& noise) {
  std::vector<std::string_view> keys;
  for (const Channel& one : run.measurable()) {
    if (one.sigma(noise) > 0) return;
    if (std::ranges::find(keys, one.kind().noise_key) == keys.end()) keys.push_back(one.kind().noise_key);
  }
  std::string names;
  for (const std::string_view key : keys)
    names += (names.empty() ? "" : key == keys.back() ? " or " : ", ") + std::string(key);
  throw Error("noise", "no figure for anything that run \"" + run.id + "\" measures",
              "a positive one for " + names);
}

/// A rest angle of thousands of turns, also in degrees: its sine would be rounding.
void require_turns(const Run& run) {
  constexpr double most = 1e4;
  const auto require = [&](const std::string& place, const std::vector<double>& rest) {
    for (std::size_t j = 0; j < rest.size(); ++j)
      if (std::abs(rest[j]) > most)
        throw Error(place, fmt::format("rest of joint {}: {:.4g} rad", j + 1, rest[j]),
                    fmt::format("an angle within {:.0f} rad", most));
  };
  require("run \"" + run.id + "\"", run.rest);
  for (std::size_t r = 0; r < run.readings.size(); ++r) require(place(run, r), run.readings[r].rest);
}

/// \throws Error for commands that are more than turns of a joint can be, most likely degrees
void require_arm(const Experiment& experiment) {
  const NominalArm& nominal = *experiment.arm;
  constexpr std::size_t most_joints = 24;  // each reading costs the cube of it
  if (nominal.arm.size() > most_joints)
    throw Error("arm", std::to_string(nominal.arm.size()) + " joints",
                std::to_string(most_joints) + " at most");
  const Noise& noise = experiment.noise;
  constexpr double finest = 1e-15;  // m, rad or N m: the rounding of places, angles and torques of an arm
  for (const ChannelKind& kind : channel_kinds) {
    const double sigma = noise[kind.name];
    if (sigma > 0 && sigma < finest)
      throw Error("noise." + std::string(kind.noise_key), fmt::format("{:.4g}", sigma),
                  "more than the rounding of what it is the noise of, 1e-15");
  }
  constexpr double most = 20;  // rad: three turns, and some
  for (const Run& run : experiment.runs)
    for (std::size_t r = 0; r < run.readings.size(); ++r)
      for (std::size_t j = 0; j < nominal.arm.size(); ++j)
        if (const double q = run.readings[r].rest[j];
            nominal.arm.links[j].kind == JointKind::revolute && std::abs(q) > most)
          throw Error(place(run, r), fmt::format("a command of {:.4g} rad to {}", q, nominal.joint[j]),
                      "at most 20 rad; if these are degrees, units.angle = \"deg\"");
}

void require_chain(const Experiment& experiment) {
  const auto passive = std::count(experiment.joint_stiffness.begin(), experiment.joint_stiffness.end(), 0.0);
  if (passive > 2)
    throw Error("nominal.joint_stiffness", std::to_string(passive) + " passive joints",
                "at most two: with more the chain is a mechanism even with its end point held");
  const Reach<double> limits = reach(experiment.link_length);
  require_resolved(experiment, limits.largest);
  for (const Run& run : experiment.runs) {
    require_turns(run);
    if (experiment.has_links()) require_reach(experiment, run, limits);
  }
}

void require_device(const Experiment& experiment) {
  if (experiment.arm)
    require_arm(experiment);
  else
    require_chain(experiment);
}

}  // namespace

void require_bench(const Experiment& bench) {
  require_device(bench);
  for (const Run& run : bench.runs) require_anything_measured(run, bench.noise);
}

void require_physical(const Experiment& experiment) {
  require_device(experiment);
  std::size_t values = 0;
  for (const Run& run : experiment.runs) {
    require_geometry(experiment, run);
    require_noise(run, experiment.noise);
    values += measured_values(run);
  }
  const std::size_t needed = 3;  // one more than the two parameters of a single effect
  if (values < needed)
    throw Error("experiment \"" + experiment.name + "\"", std::to_string(values) + " measured values",
                "at least " + std::to_string(needed) + ", more than an effect has parameters");
}

}  // namespace plumbline::diagnose
