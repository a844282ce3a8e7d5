#include "diagnose/noise/estimate_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/noise/term.hpp"
#include "diagnose/outside/outside_cause.hpp"
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

/// \param left  of the residual beyond interference and, or not, the discrepancy
NoiseEvidence evidence_of(const Experiment& experiment, const Measurements& measurements,
                          const NoiseShape& shape, const Decomposition& parts, const VectorXd& left) {
  NoiseEvidence evidence{experiment, measurements, shape, {}, {}, {}};
  evidence.scale = by_value(measurements, parts, [](const ChannelNoise& one) { return one.scale; });
  evidence.standardised = left.cwiseQuotient(evidence.scale.cwiseProduct(shape.relative));
  // Squares of neighbours correlate by the square of what their values do.
  evidence.weight = by_value(measurements, parts, [](const ChannelNoise& one) {
    const double square = one.correlation * one.correlation;
    return (1 - square) / (1 + square);
  });
  return evidence;
}

/// With readings that are marked as outliers, which may be those of a noisier segment, as the least of
/// outliers.
NoiseEvidence with_outliers_drawn_in(NoiseEvidence evidence) {
  const OutlierModel model = evidence.shape.outliers();
  const double least = std::sqrt(2 * (model.log_inlier(0) - model.log_outlier(0)));
  for (std::size_t i = 0; i < evidence.shape.outlier.size(); ++i)
    if (evidence.shape.outlier[i]) {
      double& z = evidence.standardised(static_cast<Eigen::Index>(i));
      z = std::clamp(z, -least, least);
    }
  return evidence;
}

/// Marks the readings that are more probably outliers than noise. \returns whether a mark changed
bool mark_outliers(const NoiseEvidence& evidence, NoiseShape& shape) {
  const OutlierModel model = shape.outliers();
  bool changed = false;
  for (std::size_t i = 0; i < shape.outlier.size(); ++i) {
    const double z = evidence.standardised(static_cast<Eigen::Index>(i));
    const bool is = model.log_outlier(z) > model.log_inlier(z);
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
  return log_sum({std::log(1 - priors::outside) + look.log_likelihood,
                  std::log(priors::outside) + log_outside({likelihood, residual, look})});
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
    const Decomposition parts = likelihood->decompose(residual);
    const auto evidence = [&](const VectorXd& left) {
      return evidence_of(experiment, measurements, known, parts, left);
    };
    const NoiseEvidence left = evidence(residual - parts.delta - parts.periodic);
    bool changed = mark_outliers(left, shape);
    if (changed) likelihood = likelihood_of(shape);
    if (!changed && may_depart) {
      // A discrepancy, or marks, may have taken what a departure does: it is looked for with and without
      // them.
      const NoiseEvidence beside = with_outliers_drawn_in(left),
                          whole = with_outliers_drawn_in(evidence(residual - parts.periodic));
      double reached = log_evidence(*likelihood, residual);
      for (const NoiseEvidence* from : {&left, &beside, &whole}) {
        const std::optional<NoiseProposal> proposed = most_probable_departure(*from);
        if (!proposed) continue;
        NoiseShape other = known;
        proposed->accept(other);
        std::unique_ptr<Likelihood> with = likelihood_of(other);
        const double gained = log_evidence(*with, residual) + proposed->log_prior;
        if (!(gained > reached)) continue;
        reached = gained, shape = std::move(other), likelihood = std::move(with), changed = true;
      }
      may_depart = changed;
    }
    if (!changed) break;
  }
  return shape;
}

}  // namespace plumbline::diagnose
