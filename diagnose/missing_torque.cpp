#include "diagnose/missing_torque.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <plumbline/kinematics.hpp>

namespace plumbline {
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

/// Mean square beyond noise, without the two percent of largest values, which may be outliers.
double excess(const std::vector<MissingTorque>& values, double scale) {
  std::vector<double> squares;
  for (const MissingTorque& value : values)
    squares.push_back(std::pow(value.torque / (scale * value.sigma), 2));
  std::sort(squares.begin(), squares.end());
  const std::size_t kept = squares.size() - squares.size() / 50;
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += squares[i] - 1;
  return std::max(0.0, sum);
}

std::vector<JointShare> normalised(const std::vector<double>& weight) {
  double sum = 0;
  for (const double w : weight) sum += w;
  std::vector<JointShare> shares;
  for (std::size_t j = 0; j < weight.size(); ++j)
    shares.push_back({j + 1, sum > 0 ? weight[j] / sum : 1 / static_cast<double>(weight.size())});
  std::sort(shares.begin(), shares.end(),
            [](const JointShare& a, const JointShare& b) { return a.share > b.share; });
  return shares;
}

/// Squared residual that a torque at this joint, free at every reading, cannot remove.
double left_by_free_torque(const Measurements& measurements, const std::vector<double>& residual,
                           const std::vector<double>& direction, const NoiseModel& noise) {
  std::vector<std::vector<std::array<double, 3>>> sums;  // [run][reading]: r.r, g.r, g.g
  for (const Series& series : measurements.series()) {
    if (series.run >= sums.size()) sums.resize(series.run + 1);
    const double scale = noise.of(series.channel.sensor());
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      auto& run = sums[series.run];
      if (series.readings[i] >= run.size()) run.resize(series.readings[i] + 1, {0, 0, 0});
      const double r = residual[series.first + i] / scale, g = direction[series.first + i] / scale;
      auto& sum = run[series.readings[i]];
      sum[0] += r * r;
      sum[1] += g * r;
      sum[2] += g * g;
    }
  }
  double left = 0;
  for (const auto& run : sums)
    for (const auto& [rr, gr, gg] : run) left += rr - (gg > 0 ? gr * gr / gg : 0);
  return left;
}

std::vector<JointShare> by_free_torque(const Experiment& experiment, const Measurements& measurements,
                                       const std::vector<double>& residual, const NoiseModel& noise) {
  const std::size_t n = experiment.link_length.size();
  std::vector<double> left(n, 0), weight(n, 0);
  double least = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (!(experiment.joint_stiffness[j] > 0)) continue;
    const Prediction predicted = predict(experiment, {{{EffectId::rest_angle, j + 1}}}, {0.0}, true);
    if (!predicted.reached) continue;
    left[j] =
        left_by_free_torque(measurements, residual, measurements.in_sigmas(predicted.sensitivity[0]), noise);
    if (least == 0 || left[j] < least) least = left[j];
  }
  // The likelihood of what is left, its own level taken as noise; eight neighbouring readings count as one.
  const double independent = static_cast<double>(measurements.size()) / 8;
  for (std::size_t j = 0; j < n; ++j)
    if (left[j] > 0) weight[j] = std::pow(least / left[j], independent / 2);
  return normalised(weight);
}

}  // namespace

std::vector<std::vector<MissingTorque>> missing_torques(const Experiment& experiment) {
  const Statics statics(experiment);
  std::vector<std::vector<MissingTorque>> by_joint(experiment.link_length.size());
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Vector2 noise = run.control == Control::displacement
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
        if (sigma(k) > 0) by_joint[j].push_back({r, i, reading.q[j], torque(k), sigma(k)});
      }
    }
  }
  return by_joint;
}

bool torques_measured(const Experiment& experiment) {
  return std::any_of(experiment.runs.begin(), experiment.runs.end(), [](const Run& run) {
    return std::any_of(run.readings.begin(), run.readings.end(), complete);
  });
}

std::vector<JointShare> joint_shares(const Experiment& experiment, const Measurements& measurements,
                                     const std::vector<double>& residual, const NoiseModel& noise) {
  if (!torques_measured(experiment)) return by_free_torque(experiment, measurements, residual, noise);
  const auto torques = missing_torques(experiment);
  const double scale = std::max(noise.of(Sensor::angle), noise.of(Sensor::force));
  std::vector<double> weight;
  for (const auto& joint : torques) weight.push_back(excess(joint, scale));
  return normalised(weight);
}

}  // namespace plumbline
