#include "diagnose/rig/chain_loads.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {

ChainLoads between(const ChainLoads& from, const ChainLoads& to, double share) {
  ChainLoads loads = to;
  for (std::size_t i = 0; i < loads.moment.size(); ++i) {
    const double start = from.moment.empty() ? 0 : from.moment[i];
    loads.moment[i] = start + share * (to.moment[i] - start);
  }
  for (std::size_t i = 0; i < loads.forces.size(); ++i) {
    const Eigen::Vector2d start = from.forces.empty() ? Eigen::Vector2d(0, 0) : from.forces[i].value;
    loads.forces[i].value = start + share * (to.forces[i].value - start);
  }
  return loads;
}

LoadHistory::LoadHistory(const std::vector<Load>& loads, std::size_t joints, double moment_arm_error,
                         double friction)
    : loads_(&loads),
      joints_(joints),
      moment_arm_error_(moment_arm_error),
      friction_(friction),
      tension_(loads.size(), std::vector<double>(joints, 0)) {}

ChainLoads LoadHistory::next(std::span<const double> covariates) {
  ChainLoads now;
  if (loads_->empty()) return now;
  now.moment.assign(joints_, 0);
  for (std::size_t l = 0; l < loads_->size(); ++l) {
    const Load& load = (*loads_)[l];
    const double* const value = &covariates[load.covariate];
    if (load.kind == Load::Kind::force) {
      now.forces.push_back({load.link, load.at, {value[0], value[1]}});
    } else {
      add_moments(load, *value, tension_[l], now.moment);
    }
  }
  return now;
}

void LoadHistory::add_moments(const Load& load, double value, std::vector<double>& tension,
                              std::vector<double>& moment) const {
  const double lost = load.kind == Load::Kind::tendon ? std::exp(-friction_) : 1;
  double before = value;  // the tension before the joint
  bool first = true;
  for (std::size_t j = 0; j < joints_; ++j) {
    if (load.moment_arm[j] == 0) continue;
    if (!first) {
      const auto [least, most] = std::minmax({before * lost, before / lost});
      before = std::clamp(tension[j], least, most);
    }
    first = false;
    tension[j] = before;
    moment[j] += load.moment_arm[j] * (1 + moment_arm_error_) * before;
  }
}

}  // namespace plumbline::diagnose
