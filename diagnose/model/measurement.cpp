#include "diagnose/model/measurement.hpp"

#include <cmath>

namespace plumbline::diagnose {
namespace {

std::vector<Channel> measured_channels(const Run& run) {
  using Name = Channel::Name;
  std::vector<Channel> channels;
  if (run.control == Control::end_point) {
    channels = {{Name::Fx, 0}, {Name::Fy, 0}};
  } else {
    channels = {{Name::x, 0}, {Name::y, 0}};
  }
  for (std::size_t j = 0; j < run.readings.front().q.size(); ++j) channels.push_back({Name::q, j});
  return channels;
}

}  // namespace

Sensor Channel::sensor() const {
  if (name == Name::q) return Sensor::angle;
  return name == Name::x || name == Name::y ? Sensor::position : Sensor::force;
}

std::string Channel::label() const {
  switch (name) {
    case Name::x:
      return "x";
    case Name::y:
      return "y";
    case Name::Fx:
      return "Fx";
    case Name::Fy:
      return "Fy";
    case Name::q:
      break;
  }
  return "q" + std::to_string(joint + 1);
}

double Channel::of(const Reading& reading) const {
  switch (name) {
    case Name::x:
      return reading.x;
    case Name::y:
      return reading.y;
    case Name::Fx:
      return reading.Fx;
    case Name::Fy:
      return reading.Fy;
    case Name::q:
      break;
  }
  return reading.q[joint];
}

Eigen::Index Channel::column() const {
  switch (name) {
    case Name::x:
      return column_x;
    case Name::y:
      return column_y;
    case Name::Fx:
      return column_Fx;
    case Name::Fy:
      return column_Fy;
    case Name::q:
      break;
  }
  return column_q + static_cast<Eigen::Index>(joint);
}

double Channel::sigma(const Noise& noise) const {
  switch (name) {
    case Name::x:
      return noise.x;
    case Name::y:
      return noise.y;
    case Name::Fx:
      return noise.Fx;
    case Name::Fy:
      return noise.Fy;
    case Name::q:
      break;
  }
  return noise.q;
}

Measurements::Measurements(const Experiment& experiment) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : measured_channels(run)) {
      Series series{r, channel, channel.sigma(experiment.noise), size_, {}};
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
    const auto column = traces[series.run].col(series.channel.column());
    for (const std::size_t i : series.readings)
      values.push_back(column(static_cast<Eigen::Index>(i)) / series.sigma);
  }
  return values;
}

}  // namespace plumbline::diagnose
