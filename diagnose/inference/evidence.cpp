#include "diagnose/inference/evidence.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"

namespace plumbline::diagnose {
namespace {

using beliefs::outlier_share, beliefs::outlier_width;

double log_density(double innovation) {
  const double square = innovation * innovation;
  const double core = (1 - outlier_share) * std::exp(-square / 2);
  const double tail = outlier_share / outlier_width * std::exp(-square / (2 * outlier_width * outlier_width));
  // Far out both vanish, and the tail alone counts.
  if (core + tail > 0) return std::log(core + tail);
  return std::log(outlier_share / outlier_width) - square / (2 * outlier_width * outlier_width);
}

bool has_natural_zero(const ParameterRange& range) {
  return range.may_be_nothing() || range.coordinate == Coordinate::reciprocal;
}

const double root_2_pi = std::sqrt(2 * std::numbers::pi);

/// Density of a parameter's prior where it is largest.
double largest_density(const ParameterRange& range) {
  const double sides = range.low < 0 ? 1 : 2;
  if (range.tolerance > 0) return sides / (range.tolerance * root_2_pi);
  if (!has_natural_zero(range)) return 1 / (range.high - range.low);
  return sides / (std::numbers::pi * range.scale);
}

/// Width of a parameter's prior: standard deviation of the Gaussian that is as high. What readings do not
/// tell is then worth nothing, whatever the shape of the prior.
double prior_width(const ParameterRange& range) {
  return 1 / (largest_density(range) * root_2_pi);
}

double log_parameter_prior(const ParameterRange& range, double value) {
  const double largest = std::log(largest_density(range));
  if (range.tolerance > 0) return largest - std::pow(value / range.tolerance, 2) / 2;
  return has_natural_zero(range) ? largest - std::log1p(std::pow(value / range.scale, 2)) : largest;
}

/// How common an effect is beside a plain one.
double commonness(const Effect& effect) {
  return effect.nested.empty() ? 1 : beliefs::refinement;
}

/// Of effects that may be made of several elements, the share of those with as many as this row has.
double share_of_number(const Effect& effect) {
  if (!effect.orders) return 1;
  double own = 0, all = 0, common = 1;
  for (const Effect* row : effect.orders()) {
    if (row == &effect) own = common;
    all += common;
    common *= beliefs::one_more_element;
  }
  return own / all;
}

/// At how many joints or links an effect may sit; one where it sits at none.
double places_of(const Study& study, const EffectAt& at) {
  if (at.joint == 0) return 1;
  const std::vector<EffectAt> possible = possible_effects(study);
  const auto places = std::count_if(possible.begin(), possible.end(), [&](const EffectAt& one) {
    return one.effect->at_joint && one.effect->id == at.effect->id;
  });
  return std::max(1.0, static_cast<double>(places));
}

}  // namespace

double log_likelihood(const Measurements& measurements, const std::vector<double>& residual,
                      const NoiseModel& noise) {
  double sum = 0;
  for (const double innovation : whiten(measurements, residual, noise)) sum += log_density(innovation);
  return sum;
}

double log_prior(const Study& study, const Candidate& candidate) {
  constexpr double share[] = {1.0, beliefs::one_cause, beliefs::two_causes, beliefs::three_causes};
  const std::size_t others = candidate.count() - (candidate.has_all_tolerances() ? 1 : 0),
                    causes = std::max<std::size_t>(others, candidate.has_all_tolerances() ? 1 : 0);
  double log_p = std::log(share[std::min<std::size_t>(causes, 3)]);
  double all = 0;
  for (const Effect* one : study.effects()) all += commonness(*one);
  for (std::size_t i = 0; i < causes; ++i) log_p += std::log(static_cast<double>(i + 1));  // in any order
  if (candidate.has_all_tolerances()) log_p -= std::log(all);
  if (candidate.has_all_tolerances() && others > 0) log_p += std::log(beliefs::cause_beside_machining);
  for (const EffectAt& at : candidate.effects) {
    if (candidate.has_as_tolerance(at)) continue;
    log_p += std::log(commonness(*at.effect) * share_of_number(*at.effect) / (all * places_of(study, at)));
  }
  return log_p;
}

Eigen::MatrixXd posterior_covariance(const Study& study, const Fit& fit) {
  const std::vector<ParameterRange> ranges = study.ranges(fit.candidate);
  Eigen::VectorXd width(static_cast<Eigen::Index>(ranges.size()));
  for (std::size_t p = 0; p < ranges.size(); ++p)
    width(static_cast<Eigen::Index>(p)) = fit.at_bound[p] ? 0 : prior_width(ranges[p]);
  const Eigen::MatrixXd told = width.asDiagonal() * fit.information * width.asDiagonal();
  const Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(told.rows(), told.cols()) + told;
  return width.asDiagonal() * precision.llt().solve(Eigen::MatrixXd(width.asDiagonal()));
}

double log_evidence(const Study& study, const Fit& fit, const NoiseModel& noise) {
  double value = log_likelihood(study.measurements(), fit.residual, noise) + log_prior(study, fit.candidate);
  const Eigen::MatrixXd information =
      fit.noise == noise ? fit.information : in_noise(study, fit, noise).information;
  const std::vector<ParameterRange> ranges = study.ranges(fit.candidate);
  std::vector<Eigen::Index> inside;
  std::vector<double> width;
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const auto k = static_cast<Eigen::Index>(p);
    // At a bound, or untouched by the readings, a parameter has used no freedom.
    if (fit.at_bound[p] || !(information(k, k) > 0)) continue;
    inside.push_back(k);
    width.push_back(prior_width(ranges[p]));
    value += log_parameter_prior(ranges[p], fit.parameters[p]) + std::log(root_2_pi);
  }
  if (inside.empty()) return value;
  // Posterior precisions along the principal axes, the prior's width being one. What the readings do not tell
  // keeps the width of the prior: nothing is known worse than before.
  const Eigen::VectorXd unit =
      Eigen::Map<const Eigen::VectorXd>(width.data(), static_cast<Eigen::Index>(width.size()));
  const Eigen::MatrixXd scaled =
      unit.asDiagonal() * Eigen::MatrixXd(information(inside, inside)) * unit.asDiagonal();
  const Eigen::VectorXd precisions = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  for (const double precision : precisions) value -= 0.5 * std::log1p(std::max(0.0, precision));
  return value + unit.array().log().sum();
}

double tolerance_charge(const Study& study, const Fit& fit) {
  const std::vector<ParameterRange> ranges = study.ranges(fit.candidate);
  double sum = 0;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0) sum += std::pow(fit.parameters[p] / ranges[p].tolerance, 2);
  return sum;
}

}  // namespace plumbline::diagnose
