#pragma once
/// \file
/// The next run: the feasible run that best distinguishes competing hypotheses.

#include <string>
#include <vector>

#include "diagnose/inference/hypothesis.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// A feasible run, with its expected benefit.
struct Proposal {
  std::string description;
  Run run;                 ///< the command; the measured channels are empty
  bool angles;             ///< the joint angles are to be measured
  bool out_of_gravity;     ///< the rig is to be turned until gravity acts across its plane
  double information;      ///< expected information about which hypothesis is true, nats
  double log_odds;         ///< expected log odds of the true hypothesis after the run
  double log_odds_so_far;  ///< the same without the run
  double gap;  ///< rms difference of the first hypothesis from the nominal model, in standard deviations
};

/// The purpose of the next run: to discriminate between the hypotheses, or first to detect the gap where the
/// held-out readings show too little of it to test any of them.
enum class Aim { discriminate, detect };

/// The runs with the largest expected information about which hypothesis is true, all being equally probable
/// and their parameters as uncertain as the readings leave them. Candidates are presses and loads from the
/// rest shapes of the runs and their mirror images, with and without joint angles, in gravity and out of it,
/// within the operating envelope, that the nominal model and every hypothesis can follow.
/// \param hypotheses  two or more, fitted to the readings of the study, the best first
/// \param noise       of these readings, and of those to come
/// \returns at most `count` runs, the best first; with Aim::detect those that show the gap clearly come first, else
///          none in which all hypotheses predict the same readings
std::vector<Proposal> next_runs(const Study& study, const std::vector<Hypothesis>& hypotheses,
                                const NoiseEstimate& noise, std::size_t count, Aim aim = Aim::discriminate);

}  // namespace plumbline::diagnose
