#pragma once
/// \file
/// An experiment at random, with what is to be withheld from whoever diagnoses it.

#include <cstdint>
#include <string>

#include "rig/instruments.hpp"
#include "trial/label.hpp"

namespace plumbline::rig {

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

/// The experiment with this number of the trial with this seed. Of a hundred, 15 have no effect, 60 have one,
/// 13 two, and 12 one that is in no catalogue.
Experiment make_experiment(std::uint64_t seed, std::size_t number, const std::string& name);

}  // namespace plumbline::rig
