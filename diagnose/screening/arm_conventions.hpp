#pragma once
/// \file
/// Suspected units, signs, axes, orders, zeros and loads in the readings of an arm in space.

#include <optional>
#include <string>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A change of the readings or of the model after which the nominal arm agrees with them.
struct SuspectedSlip {
  std::string looks_like;  ///< "x1, y1, z1 look like mm"
  std::string remedy;      ///< of experiment.toml or of the table
  double as_read, left;    ///< rms distance from the nominal places, over that from their mean: now and then
};

/// The change that mends nearly all of the misfit of the places, with tracker and points where they fit best
/// if these are unknown; none where all changes leave more, for a gap is no slip.
std::optional<SuspectedSlip> suspected_slip(const Study& study);

}  // namespace plumbline::diagnose
