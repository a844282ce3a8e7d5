#include "diagnose/answers/torque_balance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <plumbline/chain/kinematics.hpp>

namespace plumbline::diagnose {
namespace {

/// Statics of the nominal chain at measured joint angles and force: the missing torques and their covariance.
class Statics {
 public:
  explicit Statics(const Experiment& experiment)
      : experiment_(experiment), chain_(experiment.link_length, experiment.joint_stiffness) {}

  [[nodiscard]] Eigen::VectorXd torque(const std::vector<double>& rest, const std::vector<double>& q,
                                       const Vector2& force) const {
    const auto n = static_cast<Eigen::Index>(q.size());
    Eigen::VectorXd missing(n);
    const Eigen::MatrixXd J = jacobian(chain_, q);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(i);
      missing(i) = experiment_.joint_stiffness[j] * (q[j] - rest[j]) - J.col(i).dot(force) - weight(j, q);
    }
    return missing;
  }

  /// Standard deviations, the force's noise being zero where it is imposed.
  [[nodiscard]] Eigen::VectorXd sigma(const std::vector<double>& rest, const std::vector<double>& q,
                                      const Vector2& force, const Vector2& force_sigma) const {
    const Eigen::VectorXd here = torque(rest, q, force);
    const Eigen::MatrixXd J = jacobian(chain_, q);
    Eigen::VectorXd variance = (J.transpose() * force_sigma.asDiagonal()).rowwise().squaredNorm();
    constexpr double step = 1e-6;
    for (std::size_t l = 0; l < q.size(); ++l) {
      std::vector<double> moved = q;
      moved[l] += step;
      const Eigen::VectorXd slope = (torque(rest, moved, force) - here) / step;
      variance += (slope * experiment_.noise.q).cwiseAbs2();
    }
    return variance.cwiseSqrt();
  }

 private:
  /// Torque of the links' nominal weight on joint i.
  [[nodiscard]] double weight(std::size_t i, const std::vector<double>& q) const {
    double theta = 0, x = 0, y = 0, torque = 0;
    for (std::size_t j = 0; j < q.size(); ++j) {
      theta += q[j];
      if (j < i) continue;
      const double dx = experiment_.link_length[j] * std::cos(theta),
                   dy = experiment_.link_length[j] * std::sin(theta);
      torque += experiment_.link_mass[j] *
                ((x + dx / 2) * experiment_.gravity[1] - (y + dy / 2) * experiment_.gravity[0]);
      x += dx;
      y += dy;
    }
    return torque;
  }

  const Experiment& experiment_;
  Chain<double> chain_;
};

bool complete(const Reading& reading) {
  return !reading.q.empty() && std::isfinite(reading.Fx) && std::isfinite(reading.Fy) &&
         std::all_of(reading.q.begin(), reading.q.end(), [](double q) { return std::isfinite(q); });
}

/// Sum of squares beyond noise, without the two percent of largest values, which may be outliers; none where
/// noise alone may give as much.
double excess(const std::vector<MissingTorque>& values, double scale) {
  constexpr double significant = 5;  // standard deviations
  std::vector<double> squares;
  for (const MissingTorque& value : values)
    if (value.sigma > 0) squares.push_back(std::pow(value.torque / (scale * value.sigma), 2));
  std::sort(squares.begin(), squares.end());
  const std::size_t kept = squares.size() - squares.size() / 50;
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += squares[i] - 1;
  return sum > significant * std::sqrt(2 * static_cast<double>(kept)) ? sum : 0;
}

}  // namespace

std::vector<std::vector<MissingTorque>> missing_torques(const Experiment& experiment) {
  const Statics statics(experiment);
  std::vector<std::vector<MissingTorque>> by_joint(experiment.link_length.size());
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Vector2 noise = run.control == ControlMode::displacement
                              ? Vector2(experiment.noise.Fx, experiment.noise.Fy)
                              : Vector2(0, 0);
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const Reading& reading = run.readings[i];
      if (!complete(reading)) continue;
      const Vector2 force(reading.Fx, reading.Fy);
      const Eigen::VectorXd torque = statics.torque(run.rest, reading.q, force);
      const Eigen::VectorXd sigma = statics.sigma(run.rest, reading.q, force, noise);
      for (std::size_t j = 0; j < by_joint.size(); ++j) {
        const auto k = static_cast<Eigen::Index>(j);
        by_joint[j].push_back({r, i, reading.q[j], torque(k), sigma(k)});
      }
    }
  }
  return by_joint;
}

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

std::vector<JointShare> shares_by_missing_torque(const Experiment& experiment, const NoiseModel& noise) {
  using Name = Channel::Name;
  const double scale = std::max({noise.of({Name::q, 0}), noise.of({Name::Fx, 0}), noise.of({Name::Fy, 0})});
  std::vector<double> weight;
  for (const auto& torques : missing_torques(experiment)) weight.push_back(excess(torques, scale));
  const bool any = std::any_of(weight.begin(), weight.end(), [](double w) { return w > 0; });
  return any ? joint_shares(weight) : std::vector<JointShare>();
}

}  // namespace plumbline::diagnose
