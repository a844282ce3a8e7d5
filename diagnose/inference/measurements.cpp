#include "diagnose/inference/measurements.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/inference/imposed_noise.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<Channel> channels_of(const Experiment& experiment) {
  std::vector<Channel> all;
  for (const Run& run : experiment.runs)
    for (const Channel& channel : run.measured())
      if (std::find(all.begin(), all.end(), channel) == all.end()) all.push_back(channel);
  return all;
}

VectorXd column(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

Measurements::Measurements(const Experiment& experiment) {
  std::vector<double> value, sigma, time;
  for (const Run& run : experiment.runs) clock_.push_back(!run.counts_readings());
  const std::vector<Trace> passed_on = variance_by_imposed(experiment);
  for (const Channel& channel : channels_of(experiment)) {
    Block block{channel, static_cast<Eigen::Index>(places_.size()), 0, {}};
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
      const Run& run = experiment.runs[r];
      const std::vector<Channel> measured = run.measured();
      if (std::find(measured.begin(), measured.end(), channel) == measured.end()) continue;
      const double own = channel.sigma(experiment.noise);
      Series series{r, channel, places_.size(), {}};
      for (std::size_t i = 0; i < run.readings.size(); ++i) {
        const double one = channel.of(run.readings[i]);
        if (!std::isfinite(one)) continue;
        series.readings.push_back(i);
        places_.push_back({r, i});
        value.push_back(one);
        const double imposed =
            passed_on.empty() ? 0 : passed_on[r](static_cast<Eigen::Index>(i), channel.column);
        sigma.push_back(std::sqrt(own * own + imposed) * run.noise_of_group());
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
    const auto trace = traces[series.run].col(series.channel.column);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      values(row) = trace(static_cast<Eigen::Index>(series.readings[i])) / sigma_(row);
    }
  }
  return values;
}

VectorXd Measurements::residual(const Prediction& predicted) const {
  return value_.cwiseQuotient(sigma_) - in_sigmas(predicted.runs);
}

}  // namespace plumbline::diagnose
