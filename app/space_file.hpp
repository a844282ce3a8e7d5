#pragma once
/// \file
/// Chains in space as users write them: the key `joints` in place of `stiffness` and `rest`.

#include <optional>
#include <plumbline/space/bent_structure.hpp>
#include <plumbline/space/end_torque.hpp>
#include <string>

namespace plumbline::app {

/// A chain in space with its ends and loads, exact.
struct SpaceCase {
  SpaceChain<Rational> chain;
  SpaceSetting<Rational> setting;    ///< for bent ones
  SpaceLoad<Rational> straight;      ///< for the straight one
  std::optional<TorqueKind> torque;  ///< a unit torque at the end point, instead of forces
  bool axial = true;                 ///< whether all forces lie along x
  std::string words;                 ///< "base turns in joint 1, end point guided, …"
};

/// Whether the text is of a chain in space.
bool is_space_chain(const std::string& text, const std::string& source);
/// \throws Error that names the source and the line or key
SpaceCase parse_space_chain(const std::string& text, const std::string& source);

/// The same to solve in doubles.
BentStructure<double> bent_structure(const SpaceCase& space);

}  // namespace plumbline::app
