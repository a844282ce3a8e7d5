#pragma once
/// \file
/// Certificates that need none of our code to check, in the format of
/// proofs/certificates/certificate-format.md.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "proofs/exact/certified_modes.hpp"

namespace plumbline::proofs {

/// A force's bounds, with how many lie below each.
nlohmann::json to_json(const ForceEnclosure& force, int digits);

/// The entry of one chain and its certified modes.
nlohmann::json certificate(const std::string& name, const Chain<Rational>& chain,
                           const CertifiedModes& modes);

/// The member "matrices" of such an entry: ranks of A and B of (33), multiplicity of the eigenvalue zero of
/// B^-1 A, characteristic polynomial det(lambda B - A). O(n^4) operations on fractions for the one who
/// checks.
/// \throws Error for n = 1 or a mechanism
nlohmann::json matrix_certificate(const Chain<Rational>& chain);

/// What made a file, and from what.
struct Provenance {
  std::string command;  ///< that makes the file again
  std::string program;  ///< name and version
  std::string seed;     ///< of what is random; empty where nothing is
};
nlohmann::json to_json(const Provenance& provenance);

/// The format that a file of certificates of critical forces names.
inline constexpr const char* critical_certificates = "plumbline-certificates";

/// A file of certificates: licence CC0-1.0, closed by its own digest.
nlohmann::json certificate_file(const char* format, const Provenance& provenance,
                                std::vector<nlohmann::json> certificates);

}  // namespace plumbline::proofs
