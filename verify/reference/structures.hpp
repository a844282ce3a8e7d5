#pragma once
/// \file
/// The straight chains of the reference values with other ends and loads than the paper's.

#include <nlohmann/json.hpp>
#include <plumbline/structure/structure.hpp>

#include "verify/reference/chains.hpp"

namespace plumbline::verify {

struct StructureCase {
  std::string name;  ///< family, a dash, and what tells it from the others of the family
  Structure<Rational> structure;
  std::size_t modes;  ///< the lowest so many factors
};

/// | family         | chains                                                                             |
/// |----------------|------------------------------------------------------------------------------------|
/// | pinned-pinned, fixed-free, fixed-pinned, fixed-fixed | unit links, unit springs at joints, also at a
/// fixed end | | clamped-clamped | the same, first and last link held in direction | | rod            | bars
/// of a rod of unit E I and length, half a bar's spring at clamped ends           | | sprung         | unit
/// chain, springs across and against turning at the end point, and at the base    | | bed            | unit
/// chain, pinned, on an elastic foundation                                         | | weight         | unit
/// chain, fixed and free, under the weight of its links                           | | weight-and-force | the
/// same, a fixed weight below the critical one, a force that is multiplied       | | mid-force      | unit
/// chain, pinned, a force in the middle                                           | | held-joint     | unit
/// chain, pinned, a joint held across                                             | | follower       | unit
/// chain, fixed and free, a force that follows the last link, unit masses; ziegler | | random-ends    |
/// decimals of three digits, any ends, supports and loads                              |
std::vector<StructureCase> structure_cases(ReferenceSize size, std::uint64_t seed);

/// What is published about one, and its proof.
struct StructureEntry {
  nlohmann::json entry, certificate;
};
StructureEntry structure_entry(const StructureCase& one);

/// `structure,mode,factor,kind`, a row a factor.
std::string structures_csv(const std::vector<nlohmann::json>& entries);

}  // namespace plumbline::verify
