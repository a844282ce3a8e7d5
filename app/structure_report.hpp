#pragma once
/// \file
/// Paths and equilibria of chains with other ends and loads, in the plane and in space, as text, CSV and
/// JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "proofs/census/structure_census.hpp"
#include "proofs/paths/structure_path.hpp"

namespace plumbline::app {

/// A chain with what is said of its ends and loads.
struct NamedModel {
  std::string name, words;
  BentStructure<double> model;
  BentStructure<Mpfr50> wide;  ///< the same, in which singular shapes are judged
};

/// The curve in a few lines, and every event.
std::string as_text(const NamedModel& chain, const proofs::StructurePath& path);
/// `branch,point,factor,x,y,z,energy,negative_directions,event,q1,…`, a row a point, events among them.
std::string as_csv(const NamedModel& chain, const proofs::StructurePath& path);
nlohmann::ordered_json as_json(const NamedModel& chain, const proofs::StructurePath& path);

/// Equilibria at a factor, by energy.
std::string as_text(const NamedModel& chain, double factor,
                    const std::vector<proofs::SampledEquilibrium>& found, std::size_t starts);
nlohmann::ordered_json as_json(const NamedModel& chain, double factor,
                               const std::vector<proofs::SampledEquilibrium>& found);

/// A certified census.
std::string as_text(const NamedModel& chain, double factor, const proofs::StructureCensus& census);
nlohmann::ordered_json as_json(const NamedModel& chain, double factor, const proofs::StructureCensus& census);

}  // namespace plumbline::app
