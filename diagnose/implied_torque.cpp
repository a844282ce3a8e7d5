#include "diagnose/implied_torque.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/missing_torque.hpp"

namespace plumbline {
namespace {

constexpr Eigen::Index knots = 8;

/// The law's terms at every reading of a run: hats over the deflection for either direction, then the run's
/// constant.
Eigen::MatrixXd law_terms(const Eigen::VectorXd& deflection, double low, double high, Eigen::Index run,
                          Eigen::Index runs) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(deflection.size(), 2 * knots + runs);
  Eigen::Index side = 0;
  for (Eigen::Index i = 0; i < deflection.size(); ++i) {
    const double step = i > 0 ? deflection(i) - deflection(i - 1) : 0;
    if (step != 0) side = step > 0 ? 0 : knots;
    const double place = high > low ? (deflection(i) - low) / (high - low) * (knots - 1) : 0;
    const auto left = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(place), 0, knots - 2);
    terms(i, side + left) = 1 - (place - static_cast<double>(left));
    terms(i, side + left + 1) = place - static_cast<double>(left);
    terms(i, 2 * knots + run) = 1;
  }
  return terms;
}

/// The terms of the law at one joint by run, at the nominal deflections.
std::vector<Eigen::MatrixXd> terms_by_run(const Experiment& experiment, const Prediction& nominal,
                                          std::size_t joint) {
  std::vector<Eigen::VectorXd> deflection;
  double low = 0, high = 0;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const auto column = nominal.runs[r].col(column_q + static_cast<Eigen::Index>(joint));
    deflection.emplace_back(column.matrix().array() - experiment.runs[r].rest[joint]);
    low = std::min(low, deflection.back().minCoeff());
    high = std::max(high, deflection.back().maxCoeff());
  }
  std::vector<Eigen::MatrixXd> terms;
  const auto runs = static_cast<Eigen::Index>(deflection.size());
  for (Eigen::Index r = 0; r < runs; ++r)
    terms.push_back(law_terms(deflection[static_cast<std::size_t>(r)], low, high, r, runs));
  return terms;
}

/// The experiment as a rig would have given it, without noise and with all joint angles measured.
Experiment as_measured(Experiment experiment, const Prediction& predicted) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
      const auto row = predicted.runs[r].row(static_cast<Eigen::Index>(i));
      Reading& reading = experiment.runs[r].readings[i];
      reading.Fx = row(column_Fx);
      reading.Fy = row(column_Fy);
      reading.q.assign(row.data() + column_q, row.data() + row.size());
    }
  }
  return experiment;
}

void sort_by_share(std::vector<JointShare>& shares) {
  std::stable_sort(shares.begin(), shares.end(),
                   [](const JointShare& a, const JointShare& b) { return a.share > b.share; });
}

/// Squared residual that the best law at this joint leaves.
double left_by_law(const Experiment& experiment, const Measurements& measurements,
                   const std::vector<double>& residual, const NoiseModel& noise, std::size_t joint) {
  const Prediction predicted = predict(experiment, {{{EffectId::rest_angle, joint + 1}}}, {0.0}, true);
  const std::vector<double> per_torque = measurements.in_sigmas(predicted.sensitivity[0]);
  const std::vector<Eigen::MatrixXd> terms = terms_by_run(experiment, predicted, joint);
  const auto count = static_cast<Eigen::Index>(residual.size());
  Eigen::MatrixXd slope(count, terms.front().cols());
  Eigen::VectorXd wanted(count);
  for (const Series& series : measurements.series()) {
    const double scale = noise.of(series.channel.sensor());
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      slope.row(row) = per_torque[series.first + i] / scale *
                       terms[series.run].row(static_cast<Eigen::Index>(series.readings[i]));
      wanted(row) = residual[series.first + i] / scale;
    }
  }
  const Eigen::VectorXd law = slope.colPivHouseholderQr().solve(wanted);
  return (wanted - slope * law).squaredNorm();
}

}  // namespace

std::vector<JointShare> shares_by_torque_law(const Experiment& experiment, const Measurements& measurements,
                                             const std::vector<double>& residual, const NoiseModel& noise) {
  std::vector<JointShare> shares;
  std::vector<double> left;
  const std::vector<double> clean = without_outliers(measurements, residual);
  double least = 0;
  for (std::size_t j = 0; j < experiment.link_length.size(); ++j) {
    shares.push_back({j + 1, 0});
    left.push_back(0);
    if (!(experiment.joint_stiffness[j] > 0)) continue;
    left[j] = left_by_law(experiment, measurements, clean, noise, j);
    if (least == 0 || left[j] < least) least = left[j];
  }
  // The likelihood of what is left, its own level taken as noise; eight neighbouring readings count as one.
  const double independent = static_cast<double>(measurements.size()) / 8;
  double sum = 0;
  for (std::size_t j = 0; j < shares.size(); ++j)
    if (left[j] > 0) sum += shares[j].share = std::pow(least / left[j], independent / 2);
  for (JointShare& one : shares)
    one.share = sum > 0 ? one.share / sum : 1 / static_cast<double>(shares.size());
  sort_by_share(shares);
  return shares;
}

std::vector<JointShare> shares_by_fits(const Experiment& experiment, const std::vector<Fit>& fits,
                                       const std::vector<double>& probability) {
  std::vector<JointShare> shares;
  for (std::size_t j = 0; j < experiment.link_length.size(); ++j) shares.push_back({j + 1, 0});
  double total = 0;
  for (std::size_t f = 0; f < fits.size(); ++f) {
    const Prediction predicted = predict(experiment, fits[f].candidate, fits[f].parameters);
    std::vector<double> square(shares.size(), 0.0);
    double sum = 0;
    const auto torques = missing_torques(as_measured(experiment, predicted));
    for (std::size_t j = 0; j < torques.size(); ++j)
      for (const MissingTorque& one : torques[j]) square[j] += one.torque * one.torque;
    for (const double s : square) sum += s;
    if (!(sum > 0)) continue;
    total += probability[f];
    for (std::size_t j = 0; j < square.size(); ++j) shares[j].share += probability[f] * square[j] / sum;
  }
  for (JointShare& one : shares)
    one.share = total > 0 ? one.share / total : 1 / static_cast<double>(shares.size());
  sort_by_share(shares);
  return shares;
}

}  // namespace plumbline
