#include "diagnose/inference/start.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// The largest deflection that the nominal model gives each joint.
std::vector<double> largest_deflection(const Experiment& experiment) {
  const Prediction nominal = predict(experiment, {}, {});
  std::vector<double> largest(experiment.link_length.size(), 0);
  for (std::size_t r = 0; r < nominal.runs.size(); ++r) {
    const Trace& trace = nominal.runs[r];
    for (std::size_t i = 0; i < largest.size(); ++i) {
      const double rest = experiment.runs[r].rest[i];
      for (const double q : trace.col(column_q + static_cast<Eigen::Index>(i)))
        if (std::isfinite(q)) largest[i] = std::max(largest[i], std::abs(q - rest));
    }
  }
  return largest;
}

/// One effect's parameter, looked at on both sides of nothing.
std::vector<std::vector<double>> scan(const ParameterRange& range) {
  std::vector<std::vector<double>> result{{0}};
  for (const double value : {range.scale, -range.scale})
    if (value > range.low && value < range.high) result.push_back({value});
  return result;
}

double largest_torque(const Experiment& experiment, const std::vector<double>& deflection) {
  double torque = 0;
  for (std::size_t i = 0; i < deflection.size(); ++i)
    torque = std::max(torque, experiment.joint_stiffness[i] * deflection[i]);
  return torque;
}

}  // namespace

Starts starts(const Experiment& experiment, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = parameter_ranges(experiment, at);
  std::vector<std::vector<double>> from;
  const auto add = [&](std::vector<double> start) {
    for (std::size_t p = 0; p < start.size(); ++p)
      start[p] = std::clamp(start[p], ranges[p].low, ranges[p].high);
    from.push_back(std::move(start));
  };
  switch (at.effect) {
    case EffectId::backlash: {
      const double reach = largest_deflection(experiment)[at.joint - 1];
      for (const double share : {0.02, 0.1, 0.4}) add({share * reach});
      return {from, 2};
    }
    case EffectId::joint_friction: {
      const double torque = largest_torque(experiment, largest_deflection(experiment));
      for (const double share : {0.002, 0.01, 0.05}) add({share * torque});
      return {from, 1};
    }
    case EffectId::joint_stop: {
      const double reach = largest_deflection(experiment)[at.joint - 1];
      for (const double share : {0.2, 0.4, 0.6, 0.8, 0.95})
        for (const double stiff : {0.3, 3.0}) add({share * reach, stiff * ranges[1].scale});
      return {from, 2};
    }
    case EffectId::viscoelasticity:
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
        add({0.5 * ranges[0].scale, ranges[1].low + share * (ranges[1].high - ranges[1].low)});
      return {from, 2};
    case EffectId::link_bending:
      for (const double share : {0.01, 0.3, 2.0}) add({share * ranges[0].scale});
      return {from, 1};
    default:
      if (ranges.size() == 1) return {scan(ranges[0]), 1};
      return {{std::vector<double>(ranges.size(), 0)}, 1};
  }
}

Starts starts(const Experiment& experiment, const Candidate& candidate) {
  Starts all{{{}}, 1};
  for (const EffectAt& at : candidate.effects) {
    const Starts own = starts(experiment, at);
    std::vector<std::vector<double>> longer;
    for (const auto& head : all.from) {
      for (const auto& tail : own.from) {
        longer.push_back(head);
        longer.back().insert(longer.back().end(), tail.begin(), tail.end());
      }
    }
    all = {std::move(longer), std::max(all.basins, own.basins)};
  }
  return all;
}

}  // namespace plumbline::diagnose
