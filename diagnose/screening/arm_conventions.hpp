#pragma once
/// \file
/// Suspected units, signs, axes and orders in the readings of an arm in space.

#include <optional>
#include <string>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A change of the readings after which the nominal arm agrees with them.
struct SuspectedSlip {
  std::string looks_like;  ///< "x1, y1, z1 look like mm"
  std::string remedy;      ///< of experiment.toml or of the table
  double as_read, left;    ///< rms distance from the nominal places, over the reach: now and then
};

/// The change that mends nearly all of a large misfit of the places; none where they are near, for a gap is
/// no slip.
std::optional<SuspectedSlip> suspected_slip(const Study& study);

}  // namespace plumbline::diagnose
