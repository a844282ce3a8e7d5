#pragma once
/// \file
/// Is there a gap, and what else the readings show before anything is explained.

#include <map>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"
#include "diagnose/noise/gap.hpp"

namespace plumbline::diagnose {

/// A tone in one channel of one run that was taken for noise.
struct HummingChannel {
  std::string run;
  Channel channel;
  double period;  ///< readings
  double rms;     ///< declared sigmas
};

/// A run whose chain went to the other side than its nominal model goes to by itself.
struct OtherBranch {
  std::string run;
  std::size_t reading;  ///< as it was taken, from 0: the first one there
};

/// A run in which a sensor scatters more than in the others, and how many times.
struct RougherRun {
  std::string run;
  Sensor sensor;
  double times;
};

/// Readings of a run in which a sensor scatters more than elsewhere, and how many times.
struct RougherStretch {
  std::string run;
  Sensor sensor;
  std::size_t from, to;  ///< as they were taken, from 0, the first and the last one
  double times;
};

struct GapAnswer {
  bool present;
  GapTest test;
  double chi2_per_value;          ///< of the nominal residual, in the noise as it is
  std::map<Channel, double> rms;  ///< of the nominal residual by channel, in its unit
  std::vector<HummingChannel> hum;
  /// Of channels that scatter in proportion to their readings: the share of the reading, beside the rest.
  std::map<Channel::Name, double> proportional;
  /// Of joints whose angles scatter more than those of the others: how many times.
  std::map<Channel, double> uneven;
  std::vector<RougherRun> rougher;
  std::vector<RougherStretch> rougher_stretches;
  /// Runs whose forces were taken for those of weights, since they look like it (Run::weights_inferred).
  std::vector<std::string> taken_for_weights;
  std::vector<OtherBranch> other_branch;
};

/// \param residual  nominal, flat
GapAnswer ask_for_gap(const Study& study, const std::vector<double>& residual);

/// Tones, by the names of their runs and channels.
std::vector<HummingChannel> listed(const Study& study, const std::vector<Hum>& hum);

}  // namespace plumbline::diagnose
