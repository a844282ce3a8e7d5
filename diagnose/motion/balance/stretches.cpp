#include "diagnose/motion/balance/stretches.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "diagnose/motion/balance/balance_terms.hpp"

namespace plumbline::motion {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Half the window of derivatives, s: of seven readings at least.
double half_window_of(const TorqueLog& log) {
  const double step = (log.time.back() - log.time.front()) / static_cast<double>(log.time.size() - 1);
  return std::max(0.05, 4 * step);
}

/// Angle, speed and acceleration at one time.
struct Derivatives {
  VectorXd q, v, a;
};

/// The polynomial of the fourth degree through the readings within half a window.
Derivatives derivatives_at(const TorqueLog& log, double half_window, double t) {
  const auto first = std::lower_bound(log.time.begin(), log.time.end(), t - half_window) - log.time.begin();
  const auto end = std::upper_bound(log.time.begin(), log.time.end(), t + half_window) - log.time.begin();
  constexpr Index powers = 5;
  const Index n = end - first;
  MatrixXd design(n, powers);
  for (Index k = 0; k < n; ++k) {
    const double x = (log.time[static_cast<std::size_t>(first + k)] - t) / half_window;
    for (Index p = 0; p < powers; ++p) design(k, p) = std::pow(x, p);
  }
  const MatrixXd found = design.colPivHouseholderQr().solve(log.angle.middleRows(first, n));
  return {found.row(0).transpose(), found.row(1).transpose() / half_window,
          2 * found.row(2).transpose() / (half_window * half_window)};
}

/// Torques between readings, each joint's a column.
VectorXd torque_at(const TorqueLog& log, double t) {
  const auto after = std::upper_bound(log.time.begin() + 1, log.time.end() - 1, t) - log.time.begin();
  const double t0 = log.time[static_cast<std::size_t>(after - 1)],
               t1 = log.time[static_cast<std::size_t>(after)];
  const double share = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
  return (1 - share) * log.torque.row(after - 1).transpose() + share * log.torque.row(after).transpose();
}

}  // namespace

const std::vector<double>& leads() {
  static const std::vector<double> all = [] {
    std::vector<double> some;
    for (int ms = -20; ms <= 20; ms += 2) some.push_back(1e-3 * ms);
    return some;
  }();
  return all;
}

Stretches stretches_of(const diagnose::NominalArm& arm, const TorqueLog& log) {
  constexpr int points = 10;  // of a mean
  Stretches all;
  all.torque.resize(leads().size());
  const double half_window = half_window_of(log);
  const double first = log.time.front() + half_window + leads().back(),
               last = log.time.back() - half_window - leads().back();
  for (double begin = first; begin + mean_of_balance <= last; begin += mean_of_balance) {
    all.time.push_back(begin);
    all.columns.emplace_back();
    for (std::vector<VectorXd>& one : all.torque) one.emplace_back(VectorXd::Zero(log.torque.cols()));
    for (int i = 0; i < points; ++i) {
      const double t = begin + (i + 0.5) / points * mean_of_balance;
      const Derivatives at = derivatives_at(log, half_window, t);
      const MatrixXd columns = balance_columns(arm, at.q, at.v, at.a) / points;
      all.columns.back() = i == 0 ? columns : MatrixXd(all.columns.back() + columns);
      for (std::size_t l = 0; l < leads().size(); ++l)
        all.torque[l].back() += torque_at(log, t - leads()[l]) / points;
    }
  }
  return all;
}

}  // namespace plumbline::motion
