#pragma once
/// \file
/// How readings scatter, beside the scale and the autocorrelation of each channel: which of them are
/// outliers, which are noisier than others, and what is periodic.

#include <map>
#include <string>
#include <vector>

#include "diagnose/inference/measurements.hpp"

namespace plumbline::diagnose {

/// Readings of a run in which a sensor is noisier than elsewhere; all of the run, or a segment of it.
struct NoisierSegment {
  std::size_t run;
  Sensor sensor;
  std::size_t from, to;  ///< first and last reading
  bool whole_run;
  double factor;
};

/// Periodic interference in the channels of a sensor in one run.
struct Interference {
  std::size_t run;
  Sensor sensor;
  double period;                  ///< readings
  std::map<Channel, double> rms;  ///< declared sigmas
};

/// The density of what a reading is off by, in standard deviations of the noise: Gaussian, or the wide Cauchy
/// density of an outlier.
struct OutlierModel {
  double share;  ///< of readings that are outliers
  /// With its probability.
  [[nodiscard]] double log_outlier(double distance) const;
  [[nodiscard]] double log_inlier(double distance) const;
  [[nodiscard]] double log_density(double distance) const;  ///< of either
};

struct NoiseShape {
  explicit NoiseShape(const Measurements& measurements);
  VectorXd relative;          ///< by value: its sigma over the declared one, but for the channel's scale
  std::vector<bool> outlier;  ///< by value
  MatrixXd periodic;          ///< columns that the readings may hold any amount of, flat
  // What was found, for reports.
  std::map<Channel::Name, double> proportional;  ///< noise per unit of the reading
  std::vector<NoisierSegment> noisier;
  std::vector<Interference> interference;
  bool quantised = false;  ///< coarse displays are taken into account

  [[nodiscard]] bool has_outliers() const;
  /// Each outlier is as probable as the others make it: a rate with a beta prior.
  [[nodiscard]] OutlierModel outliers() const;
  [[nodiscard]] bool is_noisier(std::size_t run, Sensor sensor) const;
};

}  // namespace plumbline::diagnose
