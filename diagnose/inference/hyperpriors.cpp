#include "diagnose/inference/hyperpriors.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/inference/size_prior.hpp"
#include "diagnose/log_sum.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// Logarithm of the half-Cauchy probability that a size, over the typical one, is within a factor of the
/// square root of two of this one.
double log_half_cauchy(double size) {
  return std::log(2 * std::numbers::ln2 / std::numbers::pi * size / (1 + size * size));
}

constexpr double impossible = -std::numeric_limits<double>::infinity();

/// Both densities but for constants; the grid of sizes has equal ratios.
double small(double size) {
  return size > 0 ? std::exp(-size / priors::discrepancy_scale) : 0;
}

}  // namespace

Hyperpriors full_model() {
  Hyperpriors p;
  p.amplitude = {0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28};
  // Beside a cause any order of magnitude is as probable, with an exponential end.
  double beside = 0;
  for (const double a : p.amplitude) beside += small(a);
  for (const double a : p.amplitude)
    p.log_amplitude.push_back(a == 0 ? std::log(priors::exact_model)
                                     : std::log((1 - priors::exact_model) * small(a) / beside));
  p.set_outside(1);
  p.length = {0.15, 0.4, 1.0};
  p.correlation = {0, 0.35, 0.65, 0.85, 0.95};
  double sum = 0;
  for (const double rho : p.correlation) {
    p.log_correlation.push_back(-std::pow(rho / priors::correlation_spread, 2) / 2);
    sum += std::exp(p.log_correlation.back());
  }
  for (double& one : p.log_correlation) one -= std::log(sum);
  return p;
}

Hyperpriors noise_alone() {
  Hyperpriors p = full_model();
  p.amplitude = {0}, p.log_amplitude = {0}, p.log_amplitude_outside = {impossible}, p.length = {1};
  return p;
}

Hyperpriors white_noise_alone() {
  return {{0}, {0}, {impossible}, 1, {1}, {0}, {0}};
}

void Hyperpriors::set_outside(double typical_size) {
  typical = typical_size;
  log_amplitude_outside.clear();
  // A size below those of the grid changes nothing that readings show.
  for (const double a : amplitude)
    log_amplitude_outside.push_back(a > 0 ? log_size_prior(a / typical)
                                    : amplitude.size() == 1
                                        ? impossible
                                        : log_smaller(amplitude[1] / std::numbers::sqrt2 / typical));
}

double Hyperpriors::log_odds_of_listed(double size) const {
  // The constant of the density, from the first size that is none.
  const double first = amplitude[1], log_small = log_amplitude[1] - std::log(small(first));
  return log_small - size / priors::discrepancy_scale - log_half_cauchy(size / typical);
}

std::vector<double> log_amplitude_imitated(const Hyperpriors& priors) {
  std::vector<double> log_p;
  for (const double a : priors.amplitude)
    log_p.push_back(a > 0 ? log_half_cauchy(a / priors.typical) : impossible);
  return log_p;
}

double log_size_prior(double size) {
  constexpr double r = priors::smallest_typical;
  return std::log(std::numbers::ln2 * (1 - r) / -std::log(r) * size / ((size + r) * (1 + size)));
}

double log_smaller(double size) {
  constexpr double r = priors::smallest_typical;
  return std::log(std::log1p(size * (1 - r) / (r * (1 + size))) / -std::log(r));
}

const std::vector<GridSize>& size_grid() {
  static const std::vector<GridSize> grid = [] {
    std::vector<GridSize> all;
    std::vector<double> log_p;
    for (double size = priors::smallest_typical / 3; size < 30; size *= 3) {
      all.push_back({size, log_size_prior(size)});
      log_p.push_back(all.back().log_prior);
    }
    for (GridSize& one : all) one.log_prior -= log_sum(log_p);
    return all;
  }();
  return grid;
}

double log_scale_prior(double log_scale) {
  constexpr double freedom = 4;
  return -(freedom + 1) / 2 * std::log1p(std::pow(log_scale / priors::noise_scale_spread, 2) / freedom);
}

}  // namespace plumbline::diagnose
