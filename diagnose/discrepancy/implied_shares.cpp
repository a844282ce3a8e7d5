#include "diagnose/discrepancy/implied_shares.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

/// How finely a torque law is drawn, and whether each run has a constant of its own beside.
struct LawFineness {
  Eigen::Index knots;
  bool constants;
};

constexpr LawFineness law_shapes[] = {{4, false}, {4, true}, {8, false}, {8, true}, {16, false}, {16, true}};

/// A joint's nominal deflection along every run, and its range.
struct Deflections {
  std::vector<Eigen::VectorXd> by_run;
  double low = 0, high = 0;
};

Deflections deflections(const Experiment& experiment, const Prediction& nominal, std::size_t joint) {
  Deflections all;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const auto column = nominal.runs[r].col(column_q + static_cast<Eigen::Index>(joint));
    all.by_run.emplace_back(column.matrix().array() - experiment.runs[r].rest[joint]);
    all.low = std::min(all.low, all.by_run.back().minCoeff());
    all.high = std::max(all.high, all.by_run.back().maxCoeff());
  }
  return all;
}

/// The law's terms at every reading of a run: hats over the deflection for either direction, then the runs'
/// constants.
Eigen::MatrixXd law_terms(const Deflections& all, std::size_t run, const LawFineness& shape) {
  const Eigen::VectorXd& deflection = all.by_run[run];
  const auto constants = static_cast<Eigen::Index>(shape.constants ? all.by_run.size() : 0);
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(deflection.size(), 2 * shape.knots + constants);
  const double scale = all.high > all.low ? static_cast<double>(shape.knots - 1) / (all.high - all.low) : 0.0;
  Eigen::Index side = 0;
  for (Eigen::Index i = 0; i < deflection.size(); ++i) {
    const double step = i > 0 ? deflection(i) - deflection(i - 1) : 0;
    if (step != 0) side = step > 0 ? 0 : shape.knots;
    const double place = scale * (deflection(i) - all.low);
    const auto left = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(place), 0, shape.knots - 2);
    terms(i, side + left) = 1 - (place - static_cast<double>(left));
    terms(i, side + left + 1) = place - static_cast<double>(left);
    if (shape.constants) terms(i, 2 * shape.knots + static_cast<Eigen::Index>(run)) = 1;
  }
  return terms;
}

/// Residuals of the nominal model, in standard deviations, and their derivative by a torque at one joint.
struct TorqueEffect {
  Eigen::VectorXd residual, per_torque;
  Deflections deflection;
};

TorqueEffect torque_effect(const Study& study, const std::vector<double>& residual, const NoiseModel& noise,
                           std::size_t joint) {
  // An error of the rest angle is a torque at the joint, up to the joint's stiffness.
  const Prediction predicted = predict(study, {{{"rest_angle", joint + 1}}}, {0.0}, true);
  const std::vector<double> per_torque = study.measurements().in_sigmas(predicted.sensitivity[0]);
  const auto count = static_cast<Eigen::Index>(residual.size());
  TorqueEffect effect{Eigen::VectorXd(count), Eigen::VectorXd(count),
                      deflections(study.experiment(), predicted, joint)};
  for (const Series& series : study.measurements().series()) {
    const double scale = noise.of(series.channel);
    for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i) {
      effect.residual(static_cast<Eigen::Index>(i)) = residual[i] / scale;
      effect.per_torque(static_cast<Eigen::Index>(i)) = per_torque[i] / scale;
    }
  }
  return effect;
}

/// Schwarz's criterion of the best law of this shape: what it leaves is taken as noise that four neighbouring
/// readings share.
double criterion(const Measurements& measurements, const TorqueEffect& effect, const LawFineness& shape) {
  Eigen::MatrixXd slope;
  for (const Series& series : measurements.series()) {
    const Eigen::MatrixXd terms = law_terms(effect.deflection, series.run, shape);
    if (slope.size() == 0) slope.resize(effect.residual.size(), terms.cols());
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      slope.row(row) = effect.per_torque(row) * terms.row(static_cast<Eigen::Index>(series.readings[i]));
    }
  }
  const LeastSquares factors(slope);
  // Fewer readings than terms leave nothing, which is less than one squared deviation of noise.
  const double left = std::max(1.0, (effect.residual - slope * factors.solve(effect.residual)).squaredNorm());
  const double independent = std::max(2.0, static_cast<double>(effect.residual.size()) / 4);
  return independent * std::log(left) + static_cast<double>(factors.rank()) * std::log(independent);
}

}  // namespace

std::vector<JointShare> shares_by_torque_law(const Study& study, const std::vector<double>& residual,
                                             const NoiseModel& noise) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::vector<double> clean = without_outliers(study.measurements(), residual);
  std::vector<double> least(study.experiment().link_length.size(), none);
  for (std::size_t j = 0; j < least.size(); ++j) {
    if (!(study.experiment().joint_stiffness[j] > 0)) continue;
    const TorqueEffect effect = torque_effect(study, clean, noise, j);
    for (const LawFineness& shape : law_shapes)
      least[j] = std::min(least[j], criterion(study.measurements(), effect, shape));
  }
  const double best = *std::min_element(least.begin(), least.end());
  std::vector<double> weight;
  weight.reserve(least.size());
  for (const double one : least) weight.push_back(one < none ? std::exp((best - one) / 2) : 0);
  return joint_shares(weight);
}

std::vector<JointShare> shares_by_fits(const Study& study, const std::vector<Fit>& fits,
                                       const std::vector<double>& probability) {
  std::vector<double> weight(study.experiment().link_length.size(), 0.0);
  for (std::size_t f = 0; f < fits.size(); ++f) {
    const Prediction predicted = predict(study, fits[f].candidate, fits[f].parameters);
    std::vector<double> square(weight.size(), 0.0);
    double sum = 0;
    const auto torques = missing_torques(study, as_measured(study.experiment(), predicted));
    for (std::size_t j = 0; j < torques.size(); ++j)
      for (const MissingTorque& one : torques[j]) square[j] += one.torque * one.torque;
    for (const double s : square) sum += s;
    if (!(sum > 0)) continue;
    for (std::size_t j = 0; j < square.size(); ++j) weight[j] += probability[f] * square[j] / sum;
  }
  return joint_shares(weight);
}

}  // namespace plumbline::diagnose
