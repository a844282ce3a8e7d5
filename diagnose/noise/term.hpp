#pragma once
/// \file
/// A departure of noise from being even: what a kind of it says of readings, and what it changes.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "diagnose/noise/noise_shape.hpp"

namespace plumbline::diagnose {

/// What is left of the readings beyond a model and its discrepancy.
struct NoiseEvidence {
  const Experiment& experiment;
  const Measurements& measurements;
  const NoiseShape& shape;  ///< as it is known so far
  VectorXd standardised;    ///< flat, in standard deviations of that noise; outliers drawn in
  VectorXd scale;           ///< flat: of the channel, over the declared noise
  VectorXd weight;          ///< flat: independent values that a value stands for
};

/// A departure that the readings may show.
struct NoiseProposal {
  double log_odds;   ///< posterior odds that it is there, roughly: the discrepancy stays as it is
  double log_prior;  ///< of its being there, and for what its parameters might have been instead
  std::function<void(NoiseShape&)> accept;
};

/// One kind of departure. The most probable one of its kind is proposed, where its odds are better than even.
/// What was accepted once of a run and a sensor, or of a channel, is not proposed again.
class NoiseTerm {
 public:
  virtual ~NoiseTerm() = default;
  [[nodiscard]] virtual std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const = 0;
};

/// All kinds.
std::vector<std::unique_ptr<NoiseTerm>> noise_terms();

// Each kind in a file of its own, noise/terms.
std::unique_ptr<NoiseTerm> noisier_runs();
std::unique_ptr<NoiseTerm> noisier_segments();
std::unique_ptr<NoiseTerm> proportional_noise();
std::unique_ptr<NoiseTerm> quantisation();
std::unique_ptr<NoiseTerm> periodic_interference();

/// Sums of squares over values.
struct Squares {
  double sum = 0, count = 0;
  void add(double standardised, double weight) {
    sum += weight * standardised * standardised, count += weight;
  }
  [[nodiscard]] double variance() const { return count > 0 ? sum / count : 1; }
};

/// Log likelihood that two groups of values gain where each has a variance of its own.
double gain_of_two(const Squares& one, const Squares& other);

}  // namespace plumbline::diagnose
