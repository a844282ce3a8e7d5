#include "diagnose/discrepancy/torque_balance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <optional>

#include "diagnose/rig/chain_loads.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

/// Sums over the links from each joint on: from absolute angles to joint angles.
Eigen::MatrixXd beyond(Eigen::MatrixXd rows) {
  for (Eigen::Index i = rows.rows() - 1; i-- > 0;) rows.row(i) += rows.row(i + 1);
  return rows;
}

/// The missing torques of one reading and their standard deviations.
struct Balance {
  Eigen::VectorXd torque, sigma;
};

/// What loads along the chain do to links in absolute angles, as the residual counts it.
Eigen::VectorXd turned_by(const ChainLoads& loads, const std::vector<double>& length,
                          const Vector<double>& angle) {
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(angle.size());
  for (std::size_t j = 0; j < loads.moment.size(); ++j) {
    const auto own = static_cast<Eigen::Index>(j);
    residual(own) -= loads.moment[j];
    if (j > 0) residual(own - 1) += loads.moment[j];
  }
  for (const ChainLoads::Force& force : loads.forces)
    for (std::size_t j = 0; j <= force.link; ++j) {
      const double theta = angle(static_cast<Eigen::Index>(j)),
                   lever = length[j] * (j < force.link ? 1 : force.at);
      residual(static_cast<Eigen::Index>(j)) -=
          lever * force.value.dot(Vector2(-std::sin(theta), std::cos(theta)));
    }
  return residual;
}

/// What the nominal model's equilibrium misses at measured joint angles and force.
/// \param force_sigma  zero where the force is imposed
Balance balance(const NominalModel<double>& nominal, const Reading& reading, const ChainLoads& loads,
                const std::vector<double>& length, const Vector2& force_sigma, double angle_sigma) {
  Expansion<double, NominalModel<double>::bandwidth> at;
  const Eigen::VectorXd angles = absolute_angles(reading.angles(length.size()));
  nominal.expand(angles, {reading[column_Fx], reading[column_Fy]}, at);
  at.residual += turned_by(loads, length, angles);
  const Eigen::Index n = at.residual.size();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) stiffness(i, i) = at.hessian(0, i);
  for (Eigen::Index i = 0; i + 1 < n; ++i) stiffness(i + 1, i) = stiffness(i, i + 1) = at.hessian(1, i);
  const Eigen::MatrixXd by_force = beyond(at.force_gradient) * force_sigma.asDiagonal();
  const Eigen::MatrixXd by_angle = beyond(beyond(stiffness).transpose()) * angle_sigma;
  return {beyond(at.residual),
          (by_force.rowwise().squaredNorm() + by_angle.colwise().squaredNorm().transpose()).cwiseSqrt()};
}

bool complete(const Reading& reading, std::size_t joints) {
  const std::vector<double> angles = reading.angles(joints);
  return std::isfinite(reading[column_Fx]) && std::isfinite(reading[column_Fy]) &&
         std::all_of(angles.begin(), angles.end(), [](double q) { return std::isfinite(q); });
}

/// Mean square of unit normal values without a share of those that are largest.
double trimmed_square(double share) {
  if (share == 0) return 1;
  const boost::math::normal_distribution<double> unit;
  const double largest = boost::math::quantile(boost::math::complement(unit, share / 2));
  return 1 - 2 * largest * boost::math::pdf(unit, largest) / (1 - share);
}

/// Sum of squares beyond noise, without the two percent of largest values, which may be outliers; none where
/// noise alone may give as much.
double excess(const std::vector<MissingTorque>& values, double scale) {
  constexpr double significant = 5;  // standard deviations
  std::vector<double> squares;
  for (const MissingTorque& value : values)
    if (value.sigma > 0) squares.push_back(std::pow(value.torque / (scale * value.sigma), 2));
  if (squares.empty()) return 0;
  std::sort(squares.begin(), squares.end());
  const std::size_t dropped = squares.size() / 50, kept = squares.size() - dropped;
  const double expected = trimmed_square(static_cast<double>(dropped) / static_cast<double>(squares.size()));
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += squares[i] - expected;
  return sum > significant * std::sqrt(2 * static_cast<double>(kept)) ? sum : 0;
}

}  // namespace

std::vector<std::vector<MissingTorque>> missing_torques(const Experiment& experiment) {
  std::vector<std::vector<MissingTorque>> by_joint(experiment.link_length.size());
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    std::optional<NominalModel<double>> nominal;
    LoadHistory loads(experiment.loads, experiment.link_length.size());
    const double of_group = run.noise_of_group();
    const Vector2 noise =
        run.holds_end_point()
            ? Vector2(experiment.noise[Channel::Name::Fx], experiment.noise[Channel::Name::Fy]) * of_group
            : Vector2(0, 0);
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const Reading& reading = run.readings[i];
      if (!complete(reading, by_joint.size())) continue;
      if (!nominal || run.commands_joints()) nominal.emplace(nominal_model(experiment, run.rest_at(reading)));
      const Balance found = balance(*nominal, reading, loads.next(reading.covariates), experiment.link_length,
                                    noise, experiment.noise[Channel::Name::q] * of_group);
      for (std::size_t j = 0; j < by_joint.size(); ++j) {
        const auto k = static_cast<Eigen::Index>(j);
        by_joint[j].push_back({r, i, reading[column_q + k], found.torque(k), found.sigma(k)});
      }
    }
  }
  return by_joint;
}

std::vector<std::vector<MissingTorque>> missing_torques(const Study& study, const Experiment& readings) {
  std::vector<std::vector<MissingTorque>> by_joint = missing_torques(readings);
  if (study.experiment().plain()) return by_joint;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> place;
  const auto carried = missing_torques(as_measured(study.experiment(), study.nominal()));
  for (const MissingTorque& one : carried.front()) place.try_emplace({one.run, one.reading}, place.size());
  for (std::size_t j = 0; j < by_joint.size(); ++j)
    for (MissingTorque& one : by_joint[j])
      if (const auto same = place.find({one.run, one.reading}); same != place.end())
        one.torque -= carried[j][same->second].torque;
  return by_joint;
}

Experiment as_measured(Experiment experiment, const Prediction& predicted) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
      const auto row = predicted.runs[r].row(static_cast<Eigen::Index>(i));
      Reading& reading = experiment.runs[r].readings[i];
      reading[column_Fx] = row(column_Fx);
      reading[column_Fy] = row(column_Fy);
      for (std::size_t j = 0; j < experiment.link_length.size(); ++j) {
        const Channel angle(Channel::Name::q, j);
        angle.in(reading) = row(angle.column);
      }
    }
  }
  return experiment;
}

std::vector<JointShare> shares_by_missing_torque(const Study& study, const NoiseEstimate& noise) {
  using Name = Channel::Name;
  const double scale =
      std::max({noise.scale_of(Name::q), noise.scale_of(Name::Fx), noise.scale_of(Name::Fy)});
  std::vector<double> weight;
  for (const auto& torques : missing_torques(study, study.experiment()))
    weight.push_back(excess(torques, scale));
  const bool any = std::any_of(weight.begin(), weight.end(), [](double w) { return w > 0; });
  return any ? joint_shares(weight) : std::vector<JointShare>();
}

}  // namespace plumbline::diagnose
