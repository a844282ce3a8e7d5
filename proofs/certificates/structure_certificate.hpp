#pragma once
/// \file
/// Certificates of the critical factors of straight structures, in the format of
/// proofs/certificates/structure-certificate-format.md.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_space.hpp"
#include "proofs/exact/straight_structure.hpp"

namespace plumbline::proofs {

/// The format that a file of such certificates names.
inline constexpr const char* structure_certificates = "plumbline-structure-certificates";

/// The entry of one structure and its lowest critical factors, so many, each to so many digits.
nlohmann::json structure_certificate(const std::string& name, const Structure<Rational>& structure,
                                     const StraightStructure& straight, std::size_t lowest, int digits);
/// The same of a chain in space.
nlohmann::json structure_certificate(const std::string& name, const SpaceChain<Rational>& chain,
                                     const SpaceLoad<Rational>& load, const StraightSpace& straight,
                                     std::size_t lowest, int digits);
/// The entry of one structure under a load that follows it, and where it loses its stability.
nlohmann::json structure_certificate(const std::string& name, const Structure<Rational>& structure,
                                     const StabilityLoss& loss, int digits);

}  // namespace plumbline::proofs
