#pragma once
/// \file
/// Is there a gap, and which readings stand apart.

#include <map>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// A reading that is an outlier: more probably a slip, a knock or a dropout than noise.
struct Outlier {
  std::string run;
  std::size_t reading;  ///< as it was taken, from 0
  Channel channel;
  double deviation;  ///< from the model and its discrepancy, standard deviations of the noise
  bool at_end;       ///< of its run: an event that began there would look the same
};

/// A run whose chain went to the other side than its nominal model goes to by itself.
struct OtherBranch {
  std::string run;
  std::size_t reading;  ///< as it was taken, from 0: the first one there
};

/// A sensor that is noisier than elsewhere: in a run than in the others, or in a segment of a run than in its
/// rest.
struct NoisierReadings {
  std::string run;
  Sensor sensor;
  std::size_t from, to;  ///< first and last reading, as they were taken, from 0
  bool whole_run;
  double factor;
};

/// Periodic interference in a channel of a run, which counts as noise.
struct ChannelInterference {
  std::string run;
  Channel channel;
  double period;  ///< readings
  double rms;     ///< declared sigmas
};

/// A run that was written as several (continued_runs.hpp).
struct ContinuedRun {
  std::string run;
  std::vector<std::string> by;  ///< ids of its later parts
};

/// A covariate without a value at some readings of a run, interpolated in time.
struct InterpolatedCovariate {
  std::string run, covariate;
  std::size_t count, of;  ///< such readings, and all
};

/// A run of an arm of which some readings were left out (thin_poses.hpp).
struct ThinnedRun {
  std::string run;
  std::size_t count, of;  ///< readings that are used, and all
};

struct GapAnswer {
  bool present = false;
  double probability = 0;         ///< that there is one
  double log_odds = 0;            ///< the same, as the logarithm of its odds
  double seen = 0;                ///< probability of a gap that the readings speak for
  double chi2_per_value = 1;      ///< of the nominal residual, in the noise as it is
  std::map<Channel, double> rms;  ///< of the nominal residual by channel, in its unit
  std::vector<Outlier> outliers;
  /// Runs whose forces were taken for those of weights, since they look like it (Run::weights_inferred).
  std::vector<std::string> taken_for_weights;
  std::vector<OtherBranch> other_branch;
  std::vector<ContinuedRun> continued;
  std::vector<InterpolatedCovariate> interpolated;
  std::vector<ThinnedRun> thinned;
  std::vector<NoisierReadings> noisier;
  std::vector<ChannelInterference> interference;
};

/// \param left  of the readings by the model that is believed and its discrepancy, flat, declared sigmas
GapAnswer describe_gap(const Study& study, const NoiseEstimate& noise, const VectorXd& left);

}  // namespace plumbline::diagnose
