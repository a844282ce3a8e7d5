#pragma once
/// \file
/// The units of the nominal model in experiment.toml.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/section.hpp"
#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

struct NominalUnits {
  Unit link_length, joint_stiffness, link_mass, gravity, rest;

  /// \param nominal  whether the file contains the nominal model
  [[nodiscard]] std::vector<Origin> origins(bool nominal) const;
};

/// \param root    experiment.toml, with or without a table [units]
/// \param slides  whether the joints slide: angles are then lengths
/// \throws Error at a unit that is none of its quantity
NominalUnits read_nominal_units(const Section& root, bool slides);

/// A nominal model in these units.
NominalChain in_si(NominalChain chain, const NominalUnits& units);

}  // namespace plumbline::diagnose
