#include "diagnose/inference/hyperpriors.hpp"

#include <cmath>
#include <limits>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double impossible = -std::numeric_limits<double>::infinity();

/// Both densities but for constants; the grid of sizes has equal ratios.
double small(double size) {
  return size > 0 ? std::exp(-size / priors::discrepancy_scale) : 0;
}

}  // namespace

Hyperpriors full_model() {
  Hyperpriors p;
  p.amplitude = {0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28};
  // Beside a cause any order of magnitude is as probable, with an exponential end; where the cause is outside
  // of the catalogue any size is.
  double beside = 0, outside = 0;
  for (const double a : p.amplitude) beside += small(a), outside += a;
  for (const double a : p.amplitude) {
    p.log_amplitude.push_back(a == 0 ? std::log(priors::exact_model)
                                     : std::log((1 - priors::exact_model) * small(a) / beside));
    p.log_amplitude_outside.push_back(a == 0 ? impossible : std::log(a / outside));
  }
  p.length = {0.15, 0.4, 1.0};
  p.correlation = {0, 0.35, 0.65, 0.85};
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
  return {{0}, {0}, {impossible}, {1}, {0}, {0}};
}

double Hyperpriors::log_odds_of_listed(double size) const {
  // The constants of both densities, from the first size that is none.
  const double first = amplitude[1], log_small = log_amplitude[1] - std::log(small(first)),
               log_any = log_amplitude_outside[1] - std::log(first);
  return log_small - size / priors::discrepancy_scale - log_any - std::log(size);
}

double log_scale_prior(double log_scale) {
  constexpr double freedom = 4;
  return -(freedom + 1) / 2 * std::log1p(std::pow(log_scale / priors::noise_scale_spread, 2) / freedom);
}

}  // namespace plumbline::diagnose
