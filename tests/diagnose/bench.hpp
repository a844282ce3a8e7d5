#pragma once
/// \file
/// Experiments made up for the tests: a chain of three unequal links on a vertical bench.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "diagnose/inference/study.hpp"
#include "diagnose/noise/noise_estimate.hpp"
#include "tests/diagnose/chain_values.hpp"

namespace plumbline::diagnose::test {

inline double nan_value() {
  return std::nan("");
}

inline Candidate only(const char* effect, std::size_t joint = 0) {
  return {{{effect, joint}}};
}

/// The form of an effect for the chain that is not the simplest one of its id.
inline const Effect& other_form(std::string_view id) {
  const auto row = std::find_if(catalogue().begin(), catalogue().end(), [&](const Effect& one) {
    return one.id == id && !one.at_joint && !one.form.empty();
  });
  REQUIRE(row != catalogue().end());
  return *row;
}

/// An effect's parameters where zero and half a scale are no good choice.
struct Chosen {
  std::vector<double> nothing, sizeable;
};

inline std::optional<Chosen> chosen(const EffectAt& at) {
  const double t = std::log(7.0), later = std::log(20.0);
  // EI a million times k L: the links bend by a millionth of what the joints do
  static const std::map<std::string_view, Chosen> all{
      {"joint_stop", {{10, 1}, {0.05, 1}}},
      {"joint_stops", {{10, 1}, {0.05, 1}}},
      {"piecewise_spring", {{10, 0.5}, {0.03, 0.5}}},
      {"viscoelasticity", {{0, t}, {0.3, t}}},
      {"relaxation_spectrum", {{0, t, 0, later}, {0.3, t, 0.2, later}}},
      {"series_friction", {{0}, {20}}},
      {"sensor_creep", {{0, t}, {0.1, t}}},
      {"link_bending", {{3e-6}, {}}},
      {"hysteresis", {{0, 0.02, 0, 0.05, 0, 0.1}, {0.5, 0.02, 0.3, 0.05, 0.2, 0.1}}},
      {"hardening_spread", {{0, 0, 0}, {0.8, 0.4, 1.2}}},
      {"load_friction", {{0, 0}, {0.02, 3}}},
      {"direction_friction", {{0, 0}, {0.02, 0.5}}},
      {"speed_friction", {{0, 1, std::log(0.02)}, {0.02, 1, std::log(0.02)}}},
      {"plastic_set", {{0.05, 0}, {0.05, 0.3}}}};
  if (at.effect->id == "joint_stops" && at.effect != &effect("joint_stops"))  // each at its own angle
    return Chosen{{1, 10, 10, 10}, {1, 0.05, 0.08, 0.03}};
  if (at.effect->id == "joint_friction" && !at.effect->form.empty())  // gives before it slips
    return Chosen{{0, std::log(0.01)}, {0.02, std::log(0.01)}};
  const auto place = all.find(at.effect->id);
  return place == all.end() ? std::nullopt : std::optional(place->second);
}

inline Experiment three_links() {
  Experiment experiment;
  experiment.name = "three links";
  experiment.link_length = {0.20, 0.25, 0.15};
  experiment.joint_stiffness = {2.0, 1.5, 1.0};
  experiment.link_mass = {0, 0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::vertical, {0, -1}, true};
  experiment.noise = {1e-4, 1e-4, 0.01, 0.01, 1e-3};
  return experiment;
}

/// Adds a run that presses the end point by `by` in `steps` readings and, if asked, lets it come back.
inline void press(Experiment& experiment, const std::vector<double>& rest, std::array<double, 2> by,
                  int steps, bool back, double interval = 2) {
  Run run{"press-" + std::to_string(experiment.runs.size() + 1), Control::end_point, rest, {}};
  double theta = 0, x = 0, y = 0;
  for (std::size_t j = 0; j < rest.size(); ++j) {
    theta += rest[j];
    x += experiment.link_length[j] * std::cos(theta);
    y += experiment.link_length[j] * std::sin(theta);
  }
  const int last = back ? 2 * steps : steps;
  for (int i = 0; i <= last; ++i) {
    const double share = 1.0 - std::abs(1.0 - static_cast<double>(i) / steps);
    run.readings.push_back({i * interval, chain_values(x + share * by[0], y + share * by[1], 0, 0,
                                                       std::vector<double>(rest.size(), 0))});
  }
  experiment.runs.push_back(run);
}

/// Adds a run under an imposed force that grows from `from` to `to`.
inline void load(Experiment& experiment, const std::vector<double>& rest, std::array<double, 2> from,
                 std::array<double, 2> to, int steps) {
  Run run{"load-" + std::to_string(experiment.runs.size() + 1), Control::force, rest, {}};
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    run.readings.push_back({static_cast<double>(i), chain_values(0, 0, from[0] + share * (to[0] - from[0]),
                                                                 from[1] + share * (to[1] - from[1]),
                                                                 std::vector<double>(rest.size(), 0))});
  }
  experiment.runs.push_back(run);
}

/// Three links with a press along x and back, an oblique press and a force run.
inline Experiment full_bench() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 15, false, 2.5);
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-2.0, 1.0}, 15);
  return experiment;
}

/// The experiment as the candidate would have given it, with noise of the declared sigma; every `outlier`-th
/// value off by 20 sigma.
inline Experiment measured(Experiment experiment, const Candidate& truth,
                           const std::vector<double>& parameters, unsigned seed, int outlier = 0) {
  const Prediction predicted = predict(Study(experiment), truth, parameters);
  REQUIRE(predicted.reached);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  int count = 0;
  const auto noisy = [&](double value, double sigma) {
    const double off = outlier > 0 && ++count % outlier == 0 ? 20 * sigma : 0;
    return value + sigma * normal(engine) + off;
  };
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const auto row = predicted.runs[r].row(static_cast<Eigen::Index>(i));
      Reading& reading = run.readings[i];
      if (run.control == Control::end_point) {
        reading[column_Fx] = noisy(row(column_Fx), experiment.noise[Channel::Name::Fx]);
        reading[column_Fy] = noisy(row(column_Fy), experiment.noise[Channel::Name::Fy]);
      } else {
        reading[column_x] = noisy(row(column_x), experiment.noise[Channel::Name::x]);
        reading[column_y] = noisy(row(column_y), experiment.noise[Channel::Name::y]);
      }
      for (Eigen::Index c = column_q; c < static_cast<Eigen::Index>(reading.value.size()); ++c)
        reading[c] = noisy(row(c), experiment.noise[Channel::Name::q]);
    }
  }
  return experiment;
}

/// The noise that is declared, of every channel that is measured.
inline NoiseEstimate declared_noise(const Measurements& measurements) {
  NoiseEstimate noise{{}, NoiseShape(measurements)};
  for (const Block& block : measurements.blocks()) noise.channels.push_back({block.channel, 1, 0, 1});
  return noise;
}
inline NoiseEstimate declared_noise(const Study& study) {
  return declared_noise(study.measurements());
}

inline ChannelNoise& noise_of(NoiseEstimate& noise, const Channel& channel) {
  return *std::find_if(noise.channels.begin(), noise.channels.end(),
                       [&](const ChannelNoise& one) { return one.channel == channel; });
}

/// Predicted angle of joint i, from 0.
inline double angle(const Trace& trace, Eigen::Index row, std::size_t i) {
  return trace(row, column_q + static_cast<Eigen::Index>(i));
}

/// The largest by which two predicted runs differ.
inline double difference(const Trace& a, const Trace& b) {
  return (a - b).abs().maxCoeff();
}

}  // namespace plumbline::diagnose::test
