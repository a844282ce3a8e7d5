#include "diagnose/noise/estimate_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/noise/term.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// Flat, from values by block.
template <class Value>
VectorXd by_value(const Measurements& measurements, const Decomposition& parts, Value value) {
  VectorXd all(static_cast<Eigen::Index>(measurements.size()));
  for (std::size_t b = 0; b < parts.noise.channels.size(); ++b) {
    const Block& block = measurements.blocks()[b];
    all.segment(block.first, block.count).setConstant(value(parts.noise.channels[b]));
  }
  return all;
}

NoiseEvidence evidence_of(const Experiment& experiment, const Measurements& measurements,
                          const NoiseShape& shape, const Decomposition& parts, const VectorXd& residual) {
  NoiseEvidence evidence{experiment, measurements, shape, {}, {}, {}};
  evidence.scale = by_value(measurements, parts, [](const ChannelNoise& one) { return one.scale; });
  evidence.standardised =
      (residual - parts.delta - parts.periodic).cwiseQuotient(evidence.scale.cwiseProduct(shape.relative));
  // Squares of neighbours correlate by the square of what their values do.
  evidence.weight = by_value(measurements, parts, [](const ChannelNoise& one) {
    const double square = one.correlation * one.correlation;
    return (1 - square) / (1 + square);
  });
  // Readings that are marked as outliers may be those of a noisier segment: they count as the least of
  // outliers.
  constexpr double least_outlier = 4;  // about where an outlier is as probable as noise
  for (std::size_t i = 0; i < shape.outlier.size(); ++i)
    if (shape.outlier[i]) {
      double& z = evidence.standardised(static_cast<Eigen::Index>(i));
      z = std::clamp(z, -least_outlier, least_outlier);
    }
  return evidence;
}

/// Marks the readings that are more probably outliers than noise. \returns whether a mark changed
bool mark_outliers(const NoiseEvidence& evidence, NoiseShape& shape) {
  bool changed = false;
  for (std::size_t i = 0; i < shape.outlier.size(); ++i) {
    const double z = evidence.standardised(static_cast<Eigen::Index>(i));
    const bool is = log_outlier(z) > log_inlier(z);
    changed = changed || shape.outlier[i] != is;
    shape.outlier[i] = is;
  }
  return changed;
}

/// The most probable departure of any kind.
std::optional<NoiseProposal> most_probable_departure(const NoiseEvidence& evidence) {
  std::optional<NoiseProposal> best;
  for (const std::unique_ptr<NoiseTerm>& term : noise_terms())
    if (std::optional<NoiseProposal> one = term->propose(evidence);
        one && (!best || one->log_odds > best->log_odds))
      best = std::move(one);
  return best;
}

/// Log likelihood of what is left, be its cause in the catalogue or outside of it: what an outside cause does
/// is no departure of noise.
double log_evidence(const Likelihood& likelihood, const VectorXd& residual) {
  const Look look = likelihood.look(residual);
  const double common = 1 - priors::step - priors::one_channel;
  return log_sum(
      Eigen::Vector4d(std::log(1 - priors::outside) + look.log_likelihood,
                      std::log(priors::outside * common) + likelihood.log_outside(look.log_by_amplitude),
                      std::log(priors::outside * priors::one_channel) + look.log_one_channel,
                      std::log(priors::outside * priors::step) + likelihood.log_step(residual)));
}

}  // namespace

NoiseShape estimate_noise(const Experiment& experiment, const Measurements& measurements,
                          const CommandStates& states, const VectorXd& nominal_residual,
                          const VectorXd& residual, NoiseShape shape, Departures departures) {
  const auto likelihood_of = [&](const NoiseShape& one) {
    return std::make_unique<Likelihood>(measurements, states, full_model(), one, nominal_residual);
  };
  std::unique_ptr<Likelihood> likelihood = likelihood_of(shape);
  bool may_depart = departures == Departures::sought;
  constexpr int rounds = 10;  // that end before: each accepts a departure, or moves marks
  for (int round = 0; round < rounds; ++round) {
    const NoiseShape known = shape;
    const NoiseEvidence evidence =
        evidence_of(experiment, measurements, known, likelihood->decompose(residual), residual);
    bool changed = mark_outliers(evidence, shape);
    if (changed) likelihood = likelihood_of(shape);
    if (!changed && may_depart) {
      const std::optional<NoiseProposal> proposed = most_probable_departure(evidence);
      may_depart = proposed.has_value();
      if (may_depart) {
        NoiseShape other = shape;
        proposed->accept(other);
        std::unique_ptr<Likelihood> with = likelihood_of(other);
        // The discrepancy may explain as much as the departure does.
        may_depart =
            log_evidence(*with, residual) + proposed->log_prior > log_evidence(*likelihood, residual);
        if (may_depart) shape = std::move(other), likelihood = std::move(with), changed = true;
      }
    }
    if (!changed) break;
  }
  return shape;
}

}  // namespace plumbline::diagnose
