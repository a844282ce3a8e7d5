#pragma once
/// \file
/// The subject of an experiment, drawn before its bench.

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {

/// Effects and the strength of each alone, in sigmas; places and bench are random.
struct Wish {
  std::vector<const Kind*> kinds;
  std::vector<double> strengths;
  bool tolerances = false;  ///< every joint's stiffness, length and rest angle off a little beside it
  bool rough = false;       ///< noise beyond what is declared
};

/// Tolerances that every chain has beside its effect: each stiffness within 5 %, each length within 0.5 %,
/// each rest angle within 0.5 degrees of nominal.
std::vector<Effect> draw_tolerances(const Scene& scene, Random& random);

/// The first trial: 15 % without an effect, 60 % with one of the first catalogue, 13 % with two, 12 % with
/// one outside the catalogue.
Wish draw_wish(Random& random);

/// The second trial, all with rough noise. A third is in no catalogue; a third has groups (values of its own
/// at each joint, or one common to all) or tolerances beside an effect, or tolerances alone; the last has no
/// effect, one, or two.
Wish draw_second_wish(Random& random);

}  // namespace plumbline::simulator
