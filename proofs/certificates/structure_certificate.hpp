#pragma once
/// \file
/// Certificates of the critical factors of straight structures, in the format of
/// proofs/certificates/structure-certificate-format.md. Each carries its chain as it was stated, so that a
/// checker assembles that itself.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_space.hpp"
#include "proofs/exact/straight_structure.hpp"

namespace plumbline::proofs {

/// The format that a file of such certificates names.
inline constexpr const char* structure_certificates = "plumbline-structure-certificates";

/// The entry of one structure and its lowest critical factors, so many, each to so many digits.
/// \param chain  as it was stated
nlohmann::json structure_certificate(const std::string& name, const nlohmann::json& chain,
                                     const StraightStructure& straight, std::size_t lowest, int digits);
/// The same of a chain in space.
nlohmann::json structure_certificate(const std::string& name, const nlohmann::json& chain,
                                     const StraightSpace& straight, std::size_t lowest, int digits);
/// The entry of one structure under a load that follows it: where it loses its stability, and where it has it
/// again.
nlohmann::json structure_certificate(const std::string& name, const nlohmann::json& chain,
                                     const StabilityLoss& loss, int digits);

}  // namespace plumbline::proofs
