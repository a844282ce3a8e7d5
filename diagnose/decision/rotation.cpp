#include "diagnose/decision/rotation.hpp"

#include <plumbline/base/parallel.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/evidence.hpp"

namespace plumbline::diagnose {
namespace {

/// Mean variance, in that of the noise, by which the open parameters spread the prediction of what is held
/// out.
double spread(const Study& study, const Prediction& predicted, const HeldOut& part,
              const Eigen::MatrixXd& covariance, const NoiseModel& noise) {
  std::vector<std::vector<double>> slopes;
  for (const std::vector<Trace>& one : predicted.sensitivity)
    slopes.push_back(study.measurements().in_sigmas(one));
  double sum = 0, count = 0;
  Eigen::VectorXd slope(covariance.rows());
  for (const Series& series : study.measurements().series())
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      if (!part.reading[series.run][series.readings[i]]) continue;
      for (Eigen::Index p = 0; p < slope.size(); ++p)
        slope(p) = slopes[static_cast<std::size_t>(p)][series.first + i] / noise.of(series.channel);
      sum += slope.dot(covariance * slope);
      count += 1;
    }
  return count > 0 ? sum / count : 0;
}

/// Adds what is held out, and what is left there.
void add(const Study& study, const HeldOut& part, const std::vector<double>& left, HeldOut& all,
         std::vector<double>& after) {
  for (const Series& series : study.measurements().series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      if (part.reading[series.run][series.readings[i]]) after[series.first + i] = left[series.first + i];
  for (std::size_t r = 0; r < part.reading.size(); ++r)
    for (std::size_t i = 0; i < part.reading[r].size(); ++i)
      if (part.reading[r][i]) all.reading[r][i] = true;
  all.names.insert(all.names.end(), part.names.begin(), part.names.end());
}

}  // namespace

std::optional<Rotated> rotated(const Study& study, const NoiseModel& noise, const LeftBlind& left_blind) {
  std::optional<Rotated> first;
  for (const auto& parts : {run_parts(study.experiment()), block_parts(study.experiment())}) {
    HeldOut all = nothing_held(study.experiment());
    std::vector<double> after = study.nominal_residual();
    std::vector<HeldOut> used;
    std::vector<std::optional<std::vector<double>>> left(parts.size());
    in_parallel(parts.size(), study.threads(), [&](std::size_t p) {
      left[p] = left_blind(study.of(without(study.experiment(), parts[p])), parts[p]);
    });
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (!left[p]) continue;
      add(study, parts[p], *left[p], all, after);
      used.push_back(parts[p]);
    }
    if (used.empty()) continue;
    Rotated found{measure_shrink(study.measurements(), all, study.nominal_residual(), after, noise), used};
    if (found.shrink.tested()) return found;
    if (!first) first = std::move(found);
  }
  return first;
}

std::optional<Rotated> rotated(const Study& study, const Fit& fitted, const NoiseModel& noise,
                               const NoiseModel& allowed) {
  FitSettings settings;
  settings.noise = allowed;
  return rotated(
      study, noise, [&](const Study& seen, const HeldOut& part) -> std::optional<std::vector<double>> {
        const Fit blind = fit_from(seen, fitted.candidate, settings, fitted.parameters);
        if (!blind.converged) return std::nullopt;
        const Prediction predicted = predict(study, blind.candidate, blind.parameters, true);
        if (!predicted.reached || spread(study, predicted, part, posterior_covariance(seen, blind), allowed) >
                                      beliefs::undetermined)
          return std::nullopt;
        return study.residual(predicted);
      });
}

}  // namespace plumbline::diagnose
