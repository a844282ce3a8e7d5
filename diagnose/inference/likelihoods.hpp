#pragma once
/// \file
/// The likelihoods that a search weighs and fits by, in the noise that one residual shows.

#include <memory>

#include "diagnose/inference/likelihood.hpp"
#include "diagnose/noise/estimate_noise.hpp"

namespace plumbline::diagnose {

struct Likelihoods {
  std::shared_ptr<const Likelihood> full;          ///< beside a discrepancy
  std::shared_ptr<const Likelihood> rough;         ///< in white noise
  std::shared_ptr<const Likelihood> all_readings;  ///< the same, no reading an outlier; or none
  VectorXd weight;                                 ///< by value: one over its noise, in declared sigmas

  /// \param residual  from which the noise is estimated, flat, declared sigmas
  /// \param start     the shape of the noise from which the estimate begins
  Likelihoods(const Study& study, const CommandStates& states, const VectorXd& residual, NoiseShape start,
              Departures departures) {
    const Measurements& measurements = study.measurements();
    const VectorXd nominal = study.nominal_residual();
    const NoiseShape shape = estimate_noise(study.experiment(), measurements, states, nominal, residual,
                                            std::move(start), departures);
    const auto likelihood_of = [&](const Hyperpriors& priors, const NoiseShape& in) {
      return std::make_shared<Likelihood>(measurements, states, priors, in, nominal);
    };
    const auto pruned = likelihood_of(full_model(), shape);
    pruned->prune(residual);
    full = pruned;
    rough = likelihood_of(white_noise_alone(), shape);
    if (shape.has_outliers()) all_readings = likelihood_of(white_noise_alone(), NoiseShape(measurements));
    weigh(measurements, shape, full->decompose(residual));
  }

 private:
  void weigh(const Measurements& measurements, const NoiseShape& shape, const Decomposition& parts) {
    weight = shape.relative.cwiseInverse();
    for (std::size_t b = 0; b < parts.noise.channels.size(); ++b) {
      const Block& block = measurements.blocks()[b];
      weight.segment(block.first, block.count) /= parts.noise.channels[b].scale;
    }
    for (std::size_t i = 0; i < shape.outlier.size(); ++i)
      if (shape.outlier[i]) weight(static_cast<Eigen::Index>(i)) = 0;
  }
};

}  // namespace plumbline::diagnose
