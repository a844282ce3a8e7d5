#pragma once
/// \file
/// A random experiment with its label.

#include <cstdint>
#include <string>

#include "trial/label.hpp"
#include "trial/simulator/instruments.hpp"
#include "trial/simulator/wish.hpp"

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

/// \throws Error where no bench of hundreds can grant the wish
Experiment make_experiment(const Wish& wish, const std::string& name, Random& random);

/// Which trial: the first draws from the catalogue, the second from what benches bring.
enum class Trial { first, second };

/// The experiment with this number of the trial with this seed.
Experiment make_experiment(Trial trial, std::uint64_t seed, std::size_t number, const std::string& name);

}  // namespace plumbline::simulator
