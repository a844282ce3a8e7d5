#include "diagnose/inference/imposed_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

using Eigen::VectorXd;

double sigma_of_imposed(const Experiment& experiment, const Run& run) {
  if (run.imposed().size() != 1 || run.commands_joints()) return 0;
  return run.imposed().front().sigma(experiment.noise);
}

/// What one standard deviation of an imposed angle or torque, the same at every reading, changes in every
/// predicted value, through the nominal model: a trace a run. Empty where nothing imposed has noise.
std::vector<Trace> passed_on_by_one_sigma(const Experiment& experiment) {
  const std::vector<Run>& runs = experiment.runs;
  if (std::all_of(runs.begin(), runs.end(),
                  [&](const Run& run) { return sigma_of_imposed(experiment, run) == 0; }))
    return {};
  Experiment moved = experiment;
  for (Run& run : moved.runs) {
    const double by = sigma_of_imposed(experiment, run);
    for (Reading& reading : run.readings) run.imposed().front().in(reading) += by;
  }
  const Rig rig = nominal_rig(experiment);
  const Prediction given = simulate(experiment, rig, {}), beside = simulate(moved, rig, {});
  std::vector<Trace> passed_on;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Trace by = beside.runs[r] - given.runs[r];
    passed_on.push_back(by.isFinite().select(by, 0));
  }
  return passed_on;
}

/// Readings of the run from one to the next, in mean intervals; all alike without a clock.
VectorXd intervals(const Run& run) {
  const auto count = static_cast<Eigen::Index>(run.readings.size()) - 1;
  VectorXd all = VectorXd::Ones(count);
  if (run.counts_readings()) return all;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    all(i) = run.readings[k + 1].t - run.readings[k].t;
  }
  return all.minCoeff() > 0 ? VectorXd(all / all.mean()) : VectorXd::Ones(count);
}

/// The motion behind values of unit noise: Gaussian given the weights of its changes of speed, which are
/// estimated with their size (EM).
class ProbableMotion {
 public:
  ProbableMotion(VectorXd read, const VectorXd& interval)
      : read_(std::move(read)), slow_(interval.cwiseInverse()), weight_(VectorXd::Ones(read_.size() - 2)) {
    VectorXd change(weight_.size());
    for (Eigen::Index i = 0; i < change.size(); ++i) change(i) = change_at(i, read_);
    const double first = change.squaredNorm() / static_cast<double>(change.size());
    constexpr int rounds = 30;
    constexpr double freedom = 2, least = 1e-9;  // then straight over two hundred readings
    double size = std::max(first, least);
    for (int round = 0; round < rounds && first > 0; ++round) {
      solve(size);
      double sum = 0;
      for (Eigen::Index i = 0; i < change.size(); ++i) {
        const double square = std::pow(change_at(i, value), 2) + variance_of_change(i);
        weight_(i) = (freedom + 1) / (freedom + square / size);
        sum += weight_(i) * square;
      }
      size = std::max(sum / static_cast<double>(change.size()), least);
    }
    solve(size);
  }

  VectorXd value, variance;

 private:
  /// Of the speed, at the reading after this one.
  [[nodiscard]] double change_at(Eigen::Index i, const VectorXd& x) const {
    return slow_(i) * x(i) - (slow_(i) + slow_(i + 1)) * x(i + 1) + slow_(i + 1) * x(i + 2);
  }
  [[nodiscard]] double variance_of_change(Eigen::Index i) const {
    const double a = slow_(i), b = -slow_(i) - slow_(i + 1), c = slow_(i + 1);
    return a * a * variance(i) + b * b * variance(i + 1) + c * c * variance(i + 2) +
           2 * (a * b * next_(i) + b * c * next_(i + 1) + a * c * second_(i));
  }

  /// The mean and the elements of the covariance within its band, by the factors L D L' of the precision,
  /// whose band is two wide (Takahashi, Fagan and Chin 1973).
  void solve(double size) {
    const Eigen::Index n = read_.size();
    VectorXd d = VectorXd::Ones(n), one = VectorXd::Zero(n), two = VectorXd::Zero(n);
    for (Eigen::Index i = 0; i + 2 < n; ++i) {
      const double a = slow_(i), b = -slow_(i) - slow_(i + 1), c = slow_(i + 1), w = weight_(i) / size;
      d(i) += w * a * a, d(i + 1) += w * b * b, d(i + 2) += w * c * c;
      one(i) += w * a * b, one(i + 1) += w * b * c, two(i) += w * a * c;
    }
    value = read_;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i > 0) value(i) -= one(i - 1) * value(i - 1);
      if (i > 1) value(i) -= two(i - 2) * value(i - 2);
      if (i + 1 < n) {
        const double whole = one(i);
        d(i + 1) -= whole * whole / d(i);
        if (i + 2 < n) one(i + 1) -= two(i) * whole / d(i), d(i + 2) -= two(i) * two(i) / d(i);
        one(i) = whole / d(i), two(i) /= d(i);
      }
    }
    value.array() /= d.array();
    variance = d.cwiseInverse();
    next_ = second_ = VectorXd::Zero(n);
    for (Eigen::Index i = n - 2; i >= 0; --i) {
      const double far = i + 2 < n ? two(i) : 0, further = i + 2 < n ? variance(i + 2) : 0;
      value(i) -= one(i) * value(i + 1) + (i + 2 < n ? far * value(i + 2) : 0);
      next_(i) = -one(i) * variance(i + 1) - far * next_(i + 1);
      second_(i) = -one(i) * next_(i + 1) - far * further;
      variance(i) -= one(i) * next_(i) + far * second_(i);
    }
  }

  VectorXd read_, slow_, weight_;
  VectorXd next_, second_;  ///< covariances with the next reading, and with the one after it
};

/// Whether a run has too few readings to tell its motion, or readings without what is imposed.
bool is_unclear(const Run& run) {
  return run.readings.size() < 4 ||
         std::any_of(run.readings.begin(), run.readings.end(),
                     [&](const Reading& one) { return !std::isfinite(run.imposed().front().of(one)); });
}

/// Whether some run imposes something else, or measures it.
bool is_measured_elsewhere(const Experiment& experiment, const Channel& imposed) {
  return std::any_of(experiment.runs.begin(), experiment.runs.end(), [&](const Run& run) {
    const std::vector<Channel> measured = run.measured();
    return run.imposed().front().name != imposed.name ||
           std::find(measured.begin(), measured.end(), imposed) != measured.end();
  });
}

}  // namespace

Experiment with_probable_motion(Experiment experiment) {
  if (experiment.runs.empty()) return experiment;
  const double sigma = sigma_of_imposed(experiment, experiment.runs.front());
  if (sigma == 0) return experiment;
  const Channel imposed = experiment.runs.front().imposed().front();
  if (is_measured_elsewhere(experiment, imposed)) return experiment;
  const std::vector<Trace> passed_on = passed_on_by_one_sigma(experiment);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    if (is_unclear(run)) continue;
    const std::vector<Channel> measured = run.measured();
    VectorXd read(static_cast<Eigen::Index>(run.readings.size()));
    for (Eigen::Index i = 0; i < read.size(); ++i)
      read(i) = imposed.of(run.readings[static_cast<std::size_t>(i)]) / sigma;
    const VectorXd probable = ProbableMotion(read, intervals(run)).value;
    for (Eigen::Index i = 0; i < read.size(); ++i) {
      Reading& reading = run.readings[static_cast<std::size_t>(i)];
      imposed.in(reading) = sigma * probable(i);
      for (const Channel& channel : measured)
        channel.in(reading) -= passed_on[r](i, channel.column) * (read(i) - probable(i));
    }
  }
  return experiment;
}

std::vector<Trace> variance_by_imposed(const Experiment& experiment) {
  std::vector<Trace> variance = passed_on_by_one_sigma(experiment);
  for (Trace& one : variance) one = one.square();
  return variance;
}

}  // namespace plumbline::diagnose
