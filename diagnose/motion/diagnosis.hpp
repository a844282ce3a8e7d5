#pragma once
/// \file
/// The diagnosis of logs: verdict, causes with their sizes, and how far a correction goes.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/decision/verdict.hpp"
#include "diagnose/motion/log_look.hpp"
#include "diagnose/motion/next_motion.hpp"
#include "diagnose/motion/phases.hpp"
#include "diagnose/motion/search.hpp"

namespace plumbline::motion {

/// A number that was found, with the bounds of its 95 % interval.
struct Estimate {
  std::string name, unit;
  double value, low, high;
  bool at_bound;  ///< at the end of its range: without interval
};

struct NamedEffect {
  std::string id, words;
  std::vector<Estimate> values;
};

/// A cause that is named, or one of several.
struct NamedCause {
  std::vector<NamedEffect> effects;
  double probability;
  Drive<double> drive = {};  ///< with it
};

/// Mean |predicted - measured| over one log that is rolled out whole, rad.
struct LogError {
  std::string log;
  bool held_out;
  double before, after;
};

/// A row that surely acts, and changes too little to be part of what is named.
struct MinorEffect {
  std::string id, words;
  double probability;
};

struct Diagnosis {
  std::string name;
  LogsLook look;
  diagnose::CauseVerdict verdict;
  double gap = 0;                     ///< probability that there is one
  double seen_gap = 0;                ///< as diagnose::GapPosterior
  double outside = 0;                 ///< probability of a cause outside of the catalogue
  bool or_outside = false;            ///< whether that is one of the alternatives
  std::string rest;                   ///< why something is left beside what is named; empty where nothing is
  std::vector<NamedCause> causes;     ///< those that are named, most probable first
  std::vector<MinorEffect> beside;    ///< the first that is named
  std::vector<NamedCause> ranking;    ///< the most probable ones, named or not
  std::vector<Estimate> before;       ///< the drive's unknown numbers without a cause
  std::vector<Estimate> after;        ///< and beside the first that is named
  double spread = 0;                  ///< of what the first that is named leaves, standard deviation, rad
  std::vector<LogError> errors;       ///< of every log; before and after are the same without a cause
  Drive<double> without, drive;       ///< without a cause, and with the first that is named
  std::vector<ChannelLook> channels;  ///< what is read beside position
  std::vector<PhaseError> phases;     ///< over the logs that were fitted
  std::optional<double> repeatability;  ///< of logs that were commanded alike, rad

  std::optional<NextMotion> next;  ///< in which the two most probable explanations differ most

  /// Mean error of the logs held out, or of the others.
  [[nodiscard]] LogError mean(bool held_out) const;
};

/// \param progress  called with the share of the work that is done
Diagnosis diagnose_motion(const Study& study, const std::function<void(double)>& progress = {});

}  // namespace plumbline::motion
