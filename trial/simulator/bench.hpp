#pragma once
/// \file
/// A bench that works as the lab believes, and what it shows under effects.

#include <optional>

#include "trial/simulator/instruments.hpp"
#include "trial/simulator/wish.hpp"
#include "trial/label.hpp"

namespace plumbline::simulator {

struct Bench {
  Plan plan;
  std::vector<std::vector<State>> states;  ///< without any effect
  std::vector<Readings> shown;             ///< the same, without scatter
  Scatter scatter;
};

/// Nothing where the chain snaps. \param rough  noise beyond what is declared
std::optional<Bench> draw_bench(Random& random, bool rough);

Scene scene_of(const Bench& bench);

/// The experiment under some effects, without scatter.
struct Outcome {
  std::vector<Effect> effects;
  std::vector<Readings> shown;
  std::vector<Excess> gap;  ///< to the bench without any
};

/// \throws Error where the chain snaps or does not come to rest
Outcome outcome_of(const Bench& bench, std::vector<Effect> effects);

/// Root mean square: the strength of a gap.
double rms(const std::vector<Excess>& values);

/// What the catalogue itself says this experiment cannot tell apart from its effects: lists of keys.
std::vector<std::vector<std::string>> equivalents(const Bench& bench, const Outcome& outcome);

/// "id" or "id(joint)".
std::string key_of(const Effect& effect);

}  // namespace plumbline::simulator
