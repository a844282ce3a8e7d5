#pragma once
/// \file
/// How an explanation predicts readings that it has not seen, in rotation over the parts of an experiment.

#include <optional>
#include <vector>

#include "diagnose/answers/shrink.hpp"

namespace plumbline::diagnose {

struct Rotated {
  Shrink shrink;
  std::vector<HeldOut> parts;  ///< that it was measured on
};

/// The explanation, refitted without each part in its turn, on that part; all parts together. A part is
/// passed over where what is left does not determine what is fitted: the open parameters would spread the
/// prediction by more than a part of the noise. Parts of the runs, or of blocks where none of those will do.
/// Nothing where none of these will do either, or nothing can be held out.
std::optional<Rotated> rotated(const Study& study, const Fit& fitted, const NoiseModel& noise);

}  // namespace plumbline::diagnose
