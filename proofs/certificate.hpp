#pragma once
/// \file
/// Certificates that need none of our code to check, in the format of proofs/certificate-format.md.

#include <nlohmann/json_fwd.hpp>
#include <plumbline/chain.hpp>
#include <string>
#include <vector>

namespace plumbline {

/// What a certificate is to prove about a chain.
struct CertificateContents {
  std::size_t lowest;   ///< so many of the lowest critical forces
  int digits;           ///< significant digits of the forces, and of the angles where there are shapes
  bool shapes = false;  ///< a mode shape with each force; takes two digits or more
  bool matrices =
      false;  ///< ranks, the double zero and the characteristic polynomial of B^-1 A; O(n^5) to check
};

/// The entry of one chain. \throws Error for n = 1 or a mechanism
nlohmann::json certificate(const std::string& name, const Chain<Rational>& chain,
                           const CertificateContents& contents);

/// What made a file, and from what.
struct Provenance {
  std::string command;  ///< as typed
  std::string program;  ///< name and version
  std::string seed;     ///< of what is random; empty where nothing is
};

/// A file of certificates: licence CC0-1.0, closed by its own digest.
nlohmann::json certificate_file(const Provenance& provenance, std::vector<nlohmann::json> certificates);

}  // namespace plumbline
