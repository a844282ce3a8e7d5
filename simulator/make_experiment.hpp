#pragma once
/// \file
/// An experiment at random, with what is to be withheld from whoever diagnoses it.

#include <cstdint>
#include <string>

#include "simulator/effect.hpp"
#include "simulator/instruments.hpp"
#include "trial/label.hpp"

namespace plumbline::simulator {

struct Experiment {
  std::string name;
  Plan plan;
  Scatter scatter;
  std::vector<Readings> runs;
  trial::Label label;
  /// How far the rig without any effect is from the nominal statics at worst, in sigmas; NaN where the
  /// nominal model includes weights.
  double nominal_error;
};

/// Which effects, and how strong each alone should be, in sigmas; where and on which bench is left to chance.
struct Wish {
  std::vector<const Kind*> kinds;
  std::vector<double> strengths;
};

/// Of a hundred, 15 have no effect, 60 have one, 13 two, and 12 one that is in no catalogue.
Wish draw_wish(Random& random);

/// \throws Error where no bench of hundreds can grant the wish
Experiment make_experiment(const Wish& wish, const std::string& name, Random& random);

/// The experiment with this number of the trial with this seed.
Experiment make_experiment(std::uint64_t seed, std::size_t number, const std::string& name);

}  // namespace plumbline::simulator
