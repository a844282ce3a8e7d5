#pragma once
/// \file
/// What to measure next: which feasible run would best tell competing explanations apart.

#include <string>
#include <vector>

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// A run that the lab could make.
struct Proposal {
  std::string description;
  Run run;              ///< what to command; the measured channels are empty
  bool angles;          ///< whether its joint angles are to be measured
  bool out_of_gravity;  ///< whether the rig is to be turned until gravity acts across its plane
  double information;   ///< of which hypothesis is right, that the run is expected to give, nats
  double log_odds;  ///< expected after the run, in favour of whichever hypothesis is right; natural logarithm
  double log_odds_so_far;  ///< the same without it
  double gap;              ///< that the first hypothesis would leave to the nominal model, rms in the noise
};

/// What the next run is for: to tell the hypotheses apart; or, where too little of the gap shows in what is
/// held out to test any of them, to show it first.
enum class Aim { discriminate, detect };

/// Of the presses and loads that the bench could make, from the rest shapes of the runs so far and their
/// mirror images, joint angles measured or not, in gravity and out of it, those that are expected to lower
/// the entropy of the choice among the hypotheses most, each as probable as the other, their parameters as
/// uncertain as the readings leave them. Left out is what some hypothesis, or the nominal chain, could not
/// follow, and what would need more than twice the force, or more than half as much deflection again, as the
/// runs so far. \param hypotheses  two explanations or more, fitted to the same readings, the best first
/// \returns the most telling runs first, at most `count`; where they are to show the gap, those that show it
/// clearly first
std::vector<Proposal> next_runs(const Study& study, const std::vector<Fit>& hypotheses,
                                const NoiseModel& noise, std::size_t count, Aim aim = Aim::discriminate);

}  // namespace plumbline::diagnose
