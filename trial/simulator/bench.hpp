#pragma once
/// \file
/// A simulated bench, and its readings under effects.

#include <optional>

#include "trial/label.hpp"
#include "trial/simulator/instruments.hpp"
#include "trial/simulator/wish.hpp"

namespace plumbline::simulator {

struct Bench {
  Plan plan;
  std::vector<std::vector<State>> states;  ///< without effects
  std::vector<Readings> shown;             ///< the same, without scatter
  Scatter scatter;
};

/// Draws a bench; nothing where the chain snaps.
/// \param rough  noise of the second trial
std::optional<Bench> draw_bench(Random& random, bool rough);

Scene scene_of(const Bench& bench);

/// The experiment under effects, without noise.
struct Outcome {
  std::vector<Effect> effects;
  std::vector<Readings> shown;
  std::vector<Excess> gap;  ///< difference from the bench without effects
};

/// \throws Error where the chain snaps or does not come to rest
Outcome outcome_of(const Bench& bench, std::vector<Effect> effects);

/// Root mean square: the strength of a gap.
double rms(const std::vector<Excess>& values);

/// Aliases of the effects in this experiment, by the catalogue: lists of keys.
std::vector<std::vector<std::string>> aliases(const Bench& bench, const Outcome& outcome);

/// "id" or "id(joint)".
std::string key_of(const Effect& effect);

}  // namespace plumbline::simulator
