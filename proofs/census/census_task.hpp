#pragma once
/// \file
/// What a census is asked for, in exact numbers.

#include <string>

#include "proofs/census/census.hpp"

namespace plumbline::proofs {

/// What is given besides the chain.
enum class Given {
  end_point,   ///< the place at which it is held
  deflection,  ///< how far it is held from where it is without load: against x (compression) and along y
  force        ///< that acts on it
};

struct CensusTask {
  std::string name;
  Chain<Rational> chain;
  bool rest_in_pi = false;  ///< the rest angles are multiples of pi
  Given given = Given::end_point;
  Point<Rational> load;
  int turns = 0;  ///< further full turns that are counted, where the end point is held

  [[nodiscard]] Control control() const {
    return given == Given::force ? Control::force : Control::end_point;
  }
};

/// The chain, rest angles in radians.
Chain<Interval> enclosed_chain(const CensusTask& task);

/// The place of the end point, or the force.
Point<Interval> enclosed_load(const CensusTask& task);

/// \throws Error as census_at_end_point and census_under_force do
Census take_census(const CensusTask& task);

}  // namespace plumbline::proofs
