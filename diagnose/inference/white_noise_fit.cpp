#include "diagnose/inference/white_noise_fit.hpp"

#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {

Hypothesis fit_in_white_noise(const Study& study, const Candidate& candidate) {
  constexpr Effort to_the_end{50, 1e-3, true};
  const Measurements& measurements = study.measurements();
  const Likelihood likelihood(measurements, CommandStates(study.experiment()), white_noise_alone(),
                              NoiseShape(measurements), study.nominal_residual());
  return maximised(study, likelihood, candidate, initial_guesses(study, candidate), to_the_end);
}

}  // namespace plumbline::diagnose
