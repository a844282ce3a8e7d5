#pragma once
/// \file
/// Which further run would tell apart what this experiment cannot.

#include "diagnose/verdict.hpp"

namespace plumbline {

/// A run that the rig could make, and what it promises.
struct Proposal {
  std::string description;
  double
      log_odds;  ///< expected logarithm of the odds between the two candidates that are hardest to tell apart
};

/// Tries runs like those that were made, but pushed aside, pushed twice as far, and back, from the mirrored
/// shape, under an imposed force, with the joint angles measured, and with gravity turned away: each is
/// predicted with every candidate of the class, its rivals are fitted to that prediction together with the
/// old runs, and what they cannot follow, in units of the declared noise, is the expected evidence. Best
/// first, at most five.
std::vector<Proposal> what_next(const Experiment& experiment, const Cause& cause);

}  // namespace plumbline
