#include "diagnose/answers/discrepancy_torque.hpp"

#include <Eigen/QR>
#include <cmath>
#include <map>

#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {
namespace {

/// By value and elastic joint: the answer to 1 N m, declared sigmas.
MatrixXd responses(const Study& study, const Rig& rig) {
  std::vector<RigVariation> pushed;
  for (std::size_t j = 0; j < study.experiment().joint_stiffness.size(); ++j) {
    const double stiffness = study.experiment().joint_stiffness[j];
    if (!(stiffness > 0)) continue;
    pushed.push_back({rig, variation_share * stiffness});
    pushed.back().rig.laws.push_back({j + 1, {{0, pushed.back().step}}});
  }
  const Prediction given = simulate(study.experiment(), rig, pushed);
  MatrixXd columns(static_cast<Eigen::Index>(study.measurements().size()),
                   static_cast<Eigen::Index>(pushed.size()));
  for (std::size_t j = 0; j < pushed.size(); ++j)
    columns.col(static_cast<Eigen::Index>(j)) = study.in_sigmas(given.sensitivity[j]);
  return columns;
}

/// The least torque that gives these values.
double smallest_torque(const MatrixXd& response, const VectorXd& values) {
  constexpr double negligible = 1e-2;  // of the strongest answer: what answers less says nothing of a torque
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> least;
  least.setThreshold(negligible);
  return least.compute(response).solve(values).norm();
}

}  // namespace

double discrepancy_torque(const Study& study, const Hypothesis& found, const VectorXd& delta) {
  const MatrixXd response = responses(study, rig_with(study, found.candidate, found.parameters));
  if (response.cols() == 0) return 0;  // rigid joints carry any torque
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Eigen::Index>> values;
  for (std::size_t i = 0; i < study.measurements().size(); ++i) {
    const ReadingPlace& place = study.measurements().places()[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (response.row(row).allFinite()) values[{place.run, place.reading}].push_back(row);
  }
  double sum = 0;
  for (const auto& [reading, rows] : values)
    sum += std::pow(smallest_torque(response(rows, Eigen::all), delta(rows)), 2);
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace plumbline::diagnose
