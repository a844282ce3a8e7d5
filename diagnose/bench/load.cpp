#include "diagnose/bench/load.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::diagnose {
namespace {

/// The force across the end point that turns a joint as much as one unit of a tendon or a pressure does the
/// joint that it turns most.
double force_across(const Load& load, double chain_length) {
  constexpr double lever = 0.3;  // of the chain, on which a force on the end point turns a typical joint
  const double most = *std::max_element(load.moment_arm.begin(), load.moment_arm.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  return most / (lever * chain_length);
}

/// How far from the base a force acts on the stretched chain, as a share of its length.
double place_on_chain(const Load& load, const std::vector<double>& link_length) {
  const auto own = link_length.begin() + static_cast<std::ptrdiff_t>(load.link);
  const double length = std::accumulate(link_length.begin(), link_length.end(), 0.0);
  return (std::accumulate(link_length.begin(), own, 0.0) + load.at * *own) / length;
}

}  // namespace

std::vector<LoadChannel> load_channels(const std::vector<Load>& loads, const std::vector<double>& link_length,
                                       const std::vector<std::string>& names) {
  const double length = std::accumulate(link_length.begin(), link_length.end(), 0.0);
  std::vector<LoadChannel> all;
  const auto add = [&](const Load& load, std::size_t value, const Eigen::Vector2d& moves) {
    const std::size_t covariate = load.covariate + value;
    all.push_back({covariate, names[covariate], load.quantity().si, moves});
  };
  for (const Load& load : loads) {
    if (load.kind == Load::Kind::force) {
      const double share = place_on_chain(load, link_length);
      add(load, 0, {share, 0});
      add(load, 1, {0, share});
    } else {
      add(load, 0, {0, force_across(load, length)});
    }
  }
  return all;
}

}  // namespace plumbline::diagnose
