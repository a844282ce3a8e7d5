#pragma once
/// \file
/// Suspected unit, sign, axis or order conventions in an experiment, before anything is fitted.

#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Numbers that agree with the model after a conversion. This is a question to the user: the nominal model
/// itself may be wrong.
struct SuspectedConvention {
  std::vector<std::string> runs;  ///< affected runs; empty for all
  std::string what;               ///< the columns or keys, "Fx, Fy"
  std::string looks_like;         ///< "kgf"
  std::string expected;           ///< "N"
  std::string remedy;             ///< what to write in experiment.toml if the suspicion is right
  std::vector<std::string>
      alternatives;  ///< other readings that fit as well: "joint_stiffness like N cm/rad"
  double misfit_as_read,
      left;  ///< rms of what the nominal model leaves, over the readings' own: now and then
  /// Sum of the distances between the runs' starts and the unloaded end points, in lengths of the chain, as
  /// read and after the conversion; zero as read where the suspicion does not rest on it.
  double start_error_as_read, start;
};

/// Compares the readings with the nominal model as they are and under every conversion of
/// bench/conversion.hpp; nothing is fitted. A conversion is suspected where it removes most of the squared
/// misfit of every column that it changes, in every run with a misfit, and where the best remaining common
/// factor is one. The thresholds are such that a gap does not hide a slip of convention and does not look
/// like one. A reversed order of the chain must remove nearly all of the misfit, unless it alone places the
/// unloaded end points at the starts of the runs. A conversion that alone does so is suspected for that
/// reason: no gap moves unloaded end points.
std::optional<SuspectedConvention> suspected_convention(const Study& study);

/// \throws Error with the question, in one line, where a unit, sign, axis or order is suspected, or where a measured
///         column is stuck: a search for causes would be wasted
void require_conventions(const Study& study);

}  // namespace plumbline::diagnose
