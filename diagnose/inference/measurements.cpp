#include "diagnose/inference/measurements.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

std::vector<Channel> channels_of(const Experiment& experiment) {
  std::vector<Channel> all;
  for (const Run& run : experiment.runs)
    for (const Channel& channel : run.measured())
      if (std::find(all.begin(), all.end(), channel) == all.end()) all.push_back(channel);
  return all;
}

/// Noise of the imposed channel of a joint alone, as the nominal spring passes it on to the measured one;
/// that of a chain's imposed channels does not count.
double passed_on(const Experiment& experiment, const Run& run) {
  const double k = experiment.joint_stiffness.front();
  if (run.alone == Alone::no || run.commands_joints() || k == 0) return 0;
  const double imposed = run.imposed().front().sigma(experiment.noise);
  return run.holds_end_point() ? k * imposed : imposed / k;
}

VectorXd column(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

Measurements::Measurements(const Experiment& experiment) {
  std::vector<double> value, sigma, time;
  for (const Channel& channel : channels_of(experiment)) {
    Block block{channel, static_cast<Eigen::Index>(places_.size()), 0, {}};
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
      const Run& run = experiment.runs[r];
      const std::vector<Channel> measured = run.measured();
      if (std::find(measured.begin(), measured.end(), channel) == measured.end()) continue;
      const double sigma_of_one = std::hypot(channel.sigma(experiment.noise), passed_on(experiment, run));
      Series series{r, channel, places_.size(), {}, sigma_of_one * run.noise_of_group()};
      for (std::size_t i = 0; i < run.readings.size(); ++i) {
        const double one = channel.of(run.readings[i]);
        if (!std::isfinite(one)) continue;
        series.readings.push_back(i);
        places_.push_back({r, i});
        value.push_back(one);
        sigma.push_back(series.sigma);
        time.push_back(run.readings[i].t);
      }
      if (series.readings.empty()) continue;
      block.count += static_cast<Eigen::Index>(series.readings.size());
      block.series.push_back(series_.size());
      series_.push_back(std::move(series));
    }
    if (block.count > 0) blocks_.push_back(std::move(block));
  }
  value_ = column(value);
  sigma_ = column(sigma);
  time_ = column(time);
}

VectorXd Measurements::in_sigmas(const std::vector<Trace>& traces) const {
  VectorXd values(static_cast<Eigen::Index>(size()));
  for (const Series& series : series_) {
    const auto trace = traces[series.run].col(column_of(series.channel));
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      values(static_cast<Eigen::Index>(series.first + i)) =
          trace(static_cast<Eigen::Index>(series.readings[i])) / series.sigma;
  }
  return values;
}

VectorXd Measurements::residual(const Prediction& predicted) const {
  return value_.cwiseQuotient(sigma_) - in_sigmas(predicted.runs);
}

}  // namespace plumbline::diagnose
