#include "diagnose/decision/cross_validation.hpp"

#include <plumbline/base/parallel.hpp>

namespace plumbline::diagnose {
namespace {

/// Whether a value of the flat list is held out.
std::vector<bool> heldout_values(const Measurements& measurements, const HeldOut& part) {
  std::vector<bool> held;
  for (const ReadingPlace& place : measurements.places())
    held.push_back(part.reading[place.run][place.reading]);
  return held;
}

void add(const HeldOut& part, HeldOut& all) {
  for (std::size_t r = 0; r < part.reading.size(); ++r)
    for (std::size_t i = 0; i < part.reading[r].size(); ++i)
      if (part.reading[r][i]) all.reading[r][i] = true;
  all.names.insert(all.names.end(), part.names.begin(), part.names.end());
}

/// The noise of the readings that are seen, from that of all.
NoiseEstimate noise_of(const NoiseEstimate& noise, const Measurements& measurements, const HeldOut& part,
                       const Measurements& seen) {
  const NoiseShape& all = noise.shape;
  NoiseShape shape(seen);
  const std::vector<bool> held = heldout_values(measurements, part);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) continue;
    shape.relative(next) = all.relative(static_cast<Eigen::Index>(i));
    shape.outlier[static_cast<std::size_t>(next++)] = all.outlier[i];
  }
  return {noise.channels, shape};
}

/// Mean square over a part of what a prediction is uncertain by, in declared sigmas.
double uncertainty(const Study& study, const HeldOut& part, const Prediction& predicted,
                   const MatrixXd& covariance) {
  const std::vector<bool> held = heldout_values(study.measurements(), part);
  MatrixXd slopes(static_cast<Eigen::Index>(held.size()), covariance.cols());
  for (Eigen::Index p = 0; p < slopes.cols(); ++p)
    slopes.col(p) = study.in_sigmas(predicted.sensitivity[static_cast<std::size_t>(p)]);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) continue;
    const VectorXd slope = slopes.row(static_cast<Eigen::Index>(i));
    sum += slope.dot(covariance * slope), count += 1;
  }
  return count > 0 ? sum / count : 0;
}

double mean_square(const Study& study, const HeldOut& part, const VectorXd& residual) {
  const std::vector<bool> held = heldout_values(study.measurements(), part);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i]) sum += std::pow(residual(static_cast<Eigen::Index>(i)), 2), count += 1;
  return count > 0 ? sum / count : 0;
}

}  // namespace

std::optional<Shrink> cross_validated(const Study& study, const NoiseEstimate& noise,
                                      const LeftUnseen& left_unseen, const LeftUnseen& left_before) {
  const VectorXd nominal = study.nominal_residual();
  std::optional<Shrink> first;
  for (const auto& parts : {run_parts(study.experiment()), block_parts(study.experiment())}) {
    std::vector<std::optional<VectorXd>> before(parts.size()), left(parts.size());
    in_parallel(parts.size(), study.threads(), [&](std::size_t p) {
      const Study seen = study.of(without(study.experiment(), parts[p]));
      const NoiseEstimate noise_seen = noise_of(noise, study.measurements(), parts[p], seen.measurements());
      left[p] = left_unseen(seen, noise_seen, parts[p]);
      if (left[p]) before[p] = left_before ? left_before(seen, noise_seen, parts[p]) : nominal;
    });
    HeldOut all = nothing_held(study.experiment());
    VectorXd was = nominal, is = nominal;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (!before[p]) continue;
      const std::vector<bool> held = heldout_values(study.measurements(), parts[p]);
      for (std::size_t i = 0; i < held.size(); ++i)
        if (const auto k = static_cast<Eigen::Index>(i); held[i])
          was(k) = (*before[p])(k), is(k) = (*left[p])(k);
      add(parts[p], all);
    }
    if (all.empty()) continue;
    const Shrink found = measure_shrink(study.measurements(), all, was, is, noise);
    if (found.tested()) return found;
    if (!first) first = found;
  }
  return first;
}

LeftUnseen left_by(const Study& study, const Findings& findings, const Hypothesis& hypothesis) {
  return [&](const Study& seen, const NoiseEstimate& noise, const HeldOut& part) -> std::optional<VectorXd> {
    constexpr Effort effort{6, 0.03};
    const CommandStates states(seen.experiment());
    const Likelihood likelihood(seen.measurements(), states, findings.likelihood->priors(), noise.shape,
                                seen.nominal_residual());
    const Hypothesis fitted =
        maximised(seen, likelihood, hypothesis.candidate, hypothesis.parameters, effort);
    if (!fitted.converged) return std::nullopt;
    const Prediction predicted = predict(study, fitted.candidate, fitted.parameters, true);
    if (!predicted.reached || uncertainty(study, part, predicted, covariance(seen, fitted)) >
                                  mean_square(study, part, study.nominal_residual()))
      return std::nullopt;
    return study.residual(predicted);
  };
}

std::optional<Shrink> cross_validated(const Study& study, const Findings& findings,
                                      const NoiseEstimate& noise, const Hypothesis& hypothesis) {
  return cross_validated(study, noise, left_by(study, findings, hypothesis));
}

}  // namespace plumbline::diagnose
