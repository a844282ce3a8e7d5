#include "diagnose/start.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

/// The largest deflection that the nominal model gives each joint.
std::vector<double> largest_deflection(const Experiment& experiment, const Prediction& nominal) {
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

}  // namespace

std::vector<std::vector<double>> starts(const Experiment& experiment, const Prediction& nominal,
                                        const EffectAt& at) {
  const std::vector<ParameterRange> ranges = parameter_ranges(experiment, at);
  const auto inside = [&](std::vector<double> start) {
    for (std::size_t p = 0; p < start.size(); ++p)
      start[p] = std::clamp(start[p], ranges[p].low, ranges[p].high);
    return start;
  };
  const std::vector<double> deflection = largest_deflection(experiment, nominal);
  std::vector<std::vector<double>> result;
  switch (at.effect) {
    case EffectId::backlash:
      for (const double share : {0.02, 0.3}) result.push_back(inside({share * deflection[at.joint - 1]}));
      break;
    case EffectId::joint_friction: {
      double torque = 0;
      for (std::size_t i = 0; i < deflection.size(); ++i)
        torque = std::max(torque, experiment.joint_stiffness[i] * deflection[i]);
      for (const double share : {0.005, 0.05}) result.push_back(inside({share * torque}));
      break;
    }
    case EffectId::joint_stop:
      for (const double share : {0.2, 0.55, 0.85})
        result.push_back(inside({share * deflection[at.joint - 1], ranges[1].scale}));
      break;
    case EffectId::viscoelasticity:
      for (const double share : {0.15, 0.5, 0.8})
        result.push_back({0.1 * ranges[0].scale, ranges[1].low + share * (ranges[1].high - ranges[1].low)});
      break;
    case EffectId::link_bending:
      result.push_back({0.01 * ranges[0].scale});
      break;
    default:
      result.push_back(inside(std::vector<double>(ranges.size(), 0)));
  }
  return result;
}

std::vector<std::vector<double>> starts(const Experiment& experiment, const Prediction& nominal,
                                        const Candidate& candidate) {
  std::vector<std::vector<double>> all{{}};
  for (const EffectAt& at : candidate.effects) {
    std::vector<std::vector<double>> longer;
    for (const auto& head : all) {
      for (const auto& tail : starts(experiment, nominal, at)) {
        longer.push_back(head);
        longer.back().insert(longer.back().end(), tail.begin(), tail.end());
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace plumbline
