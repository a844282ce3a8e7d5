#pragma once
/// \file
/// How an explanation predicts readings that it has not seen, in rotation over the parts of an experiment.

#include <functional>
#include <optional>
#include <vector>

#include "diagnose/decision/shrink.hpp"

namespace plumbline::diagnose {

struct Rotated {
  Shrink shrink;
  std::vector<HeldOut> parts;  ///< that it was measured on
};

/// What is left of the whole experiment's residual, flat, by what was fitted to `seen`, which is without the
/// part; nothing where `seen` does not tell. Parts are asked for side by side.
using LeftBlind = std::function<std::optional<std::vector<double>>(const Study& seen, const HeldOut& part)>;

/// What is left of each part by what was fitted without it; all parts together. A part of which the others
/// do not tell is passed over. Parts of the runs, or of blocks where none of those will do or carries the
/// gap. Nothing where none of these will do either, or nothing can be held out.
std::optional<Rotated> rotated(const Study& study, const NoiseModel& noise, const LeftBlind& left_blind);

/// The explanation, refitted without each part in its turn. The others do not tell where they do not
/// determine what is fitted: the open parameters would spread the prediction by more than a part of the
/// noise.
/// \param allowed  what it may leave, where that is more than noise: fits are weighed by it, and what is open
///                 is measured by it
std::optional<Rotated> rotated(const Study& study, const Fit& fitted, const NoiseModel& noise,
                               const NoiseModel& allowed);

}  // namespace plumbline::diagnose
