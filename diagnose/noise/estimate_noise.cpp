#include "diagnose/noise/estimate_noise.hpp"

#include "diagnose/noise/term.hpp"

namespace plumbline::diagnose {
namespace {

/// Flat, from values by block.
template <class Value>
VectorXd by_value(const Measurements& measurements, const Decomposition& parts, Value value) {
  VectorXd all(static_cast<Eigen::Index>(measurements.size()));
  for (std::size_t b = 0; b < parts.noise.size(); ++b) {
    const Block& block = measurements.blocks()[b];
    all.segment(block.first, block.count).setConstant(value(parts.noise[b]));
  }
  return all;
}

NoiseEvidence evidence_of(const Experiment& experiment, const Measurements& measurements, const NoiseShape& shape,
                          const Decomposition& parts, const VectorXd& residual) {
  NoiseEvidence evidence{experiment, measurements, shape, {}, {}, {}};
  evidence.scale = by_value(measurements, parts, [](const ChannelNoise& one) { return one.scale; });
  evidence.standardised =
      (residual - parts.delta).cwiseQuotient(evidence.scale.cwiseProduct(shape.relative));
  // Squares of neighbours correlate by the square of what their values do.
  evidence.weight = by_value(measurements, parts, [](const ChannelNoise& one) {
    const double square = one.correlation * one.correlation;
    return (1 - square) / (1 + square);
  });
  for (std::size_t i = 0; i < shape.outlier.size(); ++i)
    if (shape.outlier[i]) evidence.weight(static_cast<Eigen::Index>(i)) = 0;
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

/// Accepts the most probable departure. \returns whether there is one
bool accept_departure(const NoiseEvidence& evidence, NoiseShape& shape) {
  std::optional<NoiseProposal> best;
  for (const std::unique_ptr<NoiseTerm>& term : noise_terms())
    if (std::optional<NoiseProposal> one = term->propose(evidence); one && (!best || one->log_odds > best->log_odds))
      best = std::move(one);
  if (best) best->accept(shape);
  return best.has_value();
}

}  // namespace

NoiseShape estimate_noise(const Experiment& experiment, const Measurements& measurements,
                          const CommandStates& states, const VectorXd& nominal_residual, const VectorXd& residual,
                          NoiseShape shape) {
  constexpr int rounds = 10;  // that end before: each accepts one departure, or moves marks
  for (int round = 0; round < rounds; ++round) {
    const Likelihood likelihood(measurements, states, full_model(), shape, nominal_residual);
    const NoiseShape known = shape;
    const NoiseEvidence evidence = evidence_of(experiment, measurements, known, likelihood.decompose(residual), residual);
    const bool departs = accept_departure(evidence, shape);
    if (!mark_outliers(evidence, shape) && !departs) break;
  }
  return shape;
}

}  // namespace plumbline::diagnose
