#pragma once
/// \file
/// Two data sets of one device, and the readings of one of them relative to the other.

#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A run of one state, held against the state of reference.
struct PairedRun {
  std::string run;
  std::string reference;   ///< the run that was there before; empty where none was
  std::size_t paired, of;  ///< readings with a counterpart, and all with measured values
  double rate;             ///< speed along the path over that of the reference; NaN without a clock in both
};

/// The readings of a state, less what the nominal model lacks of the reference at the same command and on the
/// same way there: y - (y' - f'). A model's lack that both states share cancels in them, and what remains is
/// noise and what changed. The declared noise is that of the difference. A reading of the reference counts
/// once, and a reading without a counterpart has no measured value any more.
struct RelativeReadings {
  Experiment experiment;
  std::vector<PairedRun> runs;
};

/// \throws Error where the nominal models of two states differ
void require_one_device(const Experiment& one, const Experiment& other);

/// \param reference  the other state of the same device, and the nominal model of the readings
/// \throws Error where too few readings have a counterpart to be judged
RelativeReadings relative_to(const Study& reference, const Experiment& state);

}  // namespace plumbline::diagnose
