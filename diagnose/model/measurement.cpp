#include "diagnose/model/measurement.hpp"

#include <cmath>

namespace plumbline::diagnose {

Measurements::Measurements(const Experiment& experiment) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      Series series{r, channel, channel.sigma(experiment.noise) * run.noise_of_group(), size_, {}};
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        if (!std::isnan(channel.of(run.readings[i]))) series.readings.push_back(i);
      if (series.readings.empty()) continue;
      size_ += series.readings.size();
      series_.push_back(std::move(series));
    }
  }
}

std::vector<double> Measurements::residual(const Experiment& experiment, const Prediction& predicted) const {
  std::vector<double> values = in_sigmas(predicted.runs);
  for (const Series& series : series_) {
    const std::vector<Reading>& measured = experiment.runs[series.run].readings;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      double& value = values[series.first + i];
      value = series.channel.of(measured[series.readings[i]]) / series.sigma - value;
    }
  }
  return values;
}

std::vector<double> Measurements::in_sigmas(const std::vector<Trace>& traces) const {
  std::vector<double> values;
  values.reserve(size_);
  for (const Series& series : series_) {
    const auto column = traces[series.run].col(column_of(series.channel));
    for (const std::size_t i : series.readings)
      values.push_back(column(static_cast<Eigen::Index>(i)) / series.sigma);
  }
  return values;
}

}  // namespace plumbline::diagnose
