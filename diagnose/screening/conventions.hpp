#pragma once
/// \file
/// Before anything is fitted: do the numbers mean what the format says, or do they betray another unit, sign,
/// axis or order?

#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Numbers that look as if they were meant otherwise. A question, not a finding: the nominal model itself may
/// be what is wrong.
struct SuspectedConvention {
  std::vector<std::string> runs;  ///< that look so; empty where all do
  std::string what;               ///< the columns or keys, "Fx, Fy"
  std::string looks_like;         ///< "kgf"
  std::string expected;           ///< "N"
  std::string remedy;             ///< what to write in experiment.toml if they are
  std::vector<std::string>
      alternatives;  ///< other readings that fit as well: "joint_stiffness like N cm/rad"
  double misfit_as_read,
      left;  ///< rms of what the nominal model leaves, over the readings' own: now and then
  /// Distances of the runs' starts from the unloaded end points, lengths of the chain, together: now and
  /// then, where they are what betrays it; otherwise zero now.
  double start_error_as_read, start;
};

/// Compares the readings with the nominal model as they stand and under each of the closed list of
/// conversions (bench/conversion.hpp); nothing is fitted. A conversion is suspected where it removes most of
/// the squared misfit of every column that it changes, in every run that misfits, and where no common factor
/// but its own would do. How much it must remove, and how far off that factor may be, are such that a gap
/// beside the slip does not hide it and a gap alone does not look like one. Of the order of a chain it is
/// nearly all, but where only the other order stands unloaded where the runs start. Where a conversion alone
/// places all starts, that is enough: no gap moves them.
std::optional<SuspectedConvention> suspected_convention(const Study& study);

/// A search among causes is wasted on numbers that were meant otherwise.
/// \throws Error with the question, in one line, where a unit, sign, axis or order is in doubt, or where a
/// measured column does not move
void require_conventions(const Study& study);

}  // namespace plumbline::diagnose
