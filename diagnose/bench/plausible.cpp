#include "diagnose/bench/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/conversion.hpp"

namespace plumbline::diagnose {
namespace {

std::string metres(double value) {
  return fmt::format("{:.6g} m", value);
}

std::string place(const Run& run, std::size_t reading) {
  return "run \"" + run.id + "\", reading " + std::to_string(reading + 1);
}

/// Distance between the end point that joint angles give and where a reading says it is; NaN where either is
/// missing.
double contradiction(const std::vector<double>& q, const Reading& reading,
                     const std::vector<double>& length) {
  double theta = 0, x = 0, y = 0;
  for (std::size_t j = 0; j < q.size(); ++j) {
    theta += q[j];
    x += length[j] * std::cos(theta);
    y += length[j] * std::sin(theta);
  }
  return std::hypot(x - reading.x, y - reading.y);
}

/// Middle distance between the measured joint angles and the measured end point; 0 without such angles.
double middle_contradiction(const Run& run, const std::vector<double>& length) {
  std::vector<double> gaps;
  for (const Reading& reading : run.readings) {
    if (reading.q.empty()) return 0;
    const double gap = contradiction(reading.q, reading, length);
    if (!std::isnan(gap)) gaps.push_back(gap);
  }
  if (gaps.empty()) return 0;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

/// What a run that cannot be would mean if its end points or angles were in another unit, order or sense:
/// "; x, y look like mm". Empty where no conversion makes it start at its unloaded shape and agree with
/// itself, each to a tenth of the chain.
std::string as_if(const Run& run, const std::vector<double>& length, const Reach& limits) {
  std::string best;
  double least = 0.1 * limits.largest;
  for (const Conversion& conversion : conversions()) {
    if (conversion.what != "q" && conversion.what != "x, y") continue;
    Run other = run;
    conversion.run(other);
    const auto start = std::find_if(other.readings.begin(), other.readings.end(), [](const Reading& r) {
      return std::isfinite(r.x) && std::isfinite(r.y);
    });
    if (start == other.readings.end()) continue;
    const double gap = std::max(contradiction(run.rest, *start, length), middle_contradiction(other, length));
    if (gap >= least) continue;
    least = gap;
    best = "; " + conversion.what + (conversion.what == "q" ? " looks like " : " look like ") +
           conversion.looks_like;
  }
  return best;
}

/// A commanded end point is exact: beyond the reach by more than its rounding it has no equilibrium. A
/// measured one carries noise, and lengths and zero are what is in question: only what no tolerance explains
/// is refused.
void require_reach(const Run& run, const std::vector<double>& length, const Reach& limits) {
  const double slack = (run.control == ControlMode::displacement ? 1e-4 : 0.25) * limits.largest;
  for (std::size_t r = 0; r < run.readings.size(); ++r) {
    const double distance = std::hypot(run.readings[r].x, run.readings[r].y);
    if (distance > limits.largest + slack)
      throw Error(place(run, r), "an end point " + metres(distance) + " from the base",
                  "at most the length of the chain, " + metres(limits.largest) + as_if(run, length, limits));
    if (distance < limits.smallest - slack)
      throw Error(place(run, r), "an end point " + metres(distance) + " from the base",
                  "at least " + metres(limits.smallest) + ", what the links reach when folded" +
                      as_if(run, length, limits));
  }
}

/// Joint angles in degrees, in another order or of another chain. No effect moves the end point of most
/// readings by a quarter of the chain.
void require_geometry(const Run& run, const std::vector<double>& length, const Reach& limits) {
  const double gap = middle_contradiction(run, length);
  if (gap > 0.25 * limits.largest)
    throw Error("run \"" + run.id + "\"",
                "joint angles that put the end point " + metres(gap) + " from where x and y say it is",
                "joint angles of this chain, relative and in radians" + as_if(run, length, limits));
}

void require_noise(const Run& run, const Noise& noise) {
  const bool displacement = run.control == ControlMode::displacement;
  const auto require = [&](const char* name, double sigma, auto value) {
    const bool measured = std::any_of(run.readings.begin(), run.readings.end(),
                                      [&](const Reading& r) { return !std::isnan(value(r)); });
    if (measured && !(sigma > 0))
      throw Error(std::string("noise.") + name, "0, or nothing",
                  "a positive figure: run \"" + run.id + "\" measures it");
  };
  require(displacement ? "Fx" : "x", displacement ? noise.Fx : noise.x,
          [&](const Reading& r) { return displacement ? r.Fx : r.x; });
  require(displacement ? "Fy" : "y", displacement ? noise.Fy : noise.y,
          [&](const Reading& r) { return displacement ? r.Fy : r.y; });
  if (run.readings.front().q.empty()) return;
  for (std::size_t j = 0; j < run.rest.size(); ++j)
    require("q", noise.q, [&](const Reading& r) { return r.q[j]; });
}

std::size_t measured_values(const Run& run) {
  const bool displacement = run.control == ControlMode::displacement;
  std::size_t count = 0;
  for (const Reading& r : run.readings) {
    count += std::isfinite(displacement ? r.Fx : r.x);
    count += std::isfinite(displacement ? r.Fy : r.y);
    count += static_cast<std::size_t>(
        std::count_if(r.q.begin(), r.q.end(), [](double q) { return std::isfinite(q); }));
  }
  return count;
}

}  // namespace

Reach reach(const std::vector<double>& link_length) {
  const double sum = std::accumulate(link_length.begin(), link_length.end(), 0.0);
  const double longest = *std::max_element(link_length.begin(), link_length.end());
  return {std::max(0.0, 2 * longest - sum), sum};
}

void require_physical(const Experiment& experiment) {
  const auto passive = std::count(experiment.joint_stiffness.begin(), experiment.joint_stiffness.end(), 0.0);
  if (passive > 2)
    throw Error("nominal.joint_stiffness", std::to_string(passive) + " passive joints",
                "at most two: with more the chain is a mechanism even with its end point held");
  const Reach limits = reach(experiment.link_length);
  std::size_t values = 0;
  for (const Run& run : experiment.runs) {
    require_reach(run, experiment.link_length, limits);
    require_geometry(run, experiment.link_length, limits);
    require_noise(run, experiment.noise);
    values += measured_values(run);
  }
  const std::size_t needed = 3;  // one more than the two parameters that a single effect can have
  if (values < needed)
    throw Error("experiment \"" + experiment.name + "\"", std::to_string(values) + " measured values",
                "at least " + std::to_string(needed) + ", more than an effect has parameters");
}

}  // namespace plumbline::diagnose
