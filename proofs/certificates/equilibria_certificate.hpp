#pragma once
/// \file
/// Certificates of censuses that need none of our code to check, in the format of
/// proofs/certificates/equilibria-certificate-format.md.

#include <nlohmann/json_fwd.hpp>

#include "proofs/census/census_task.hpp"

namespace plumbline::proofs {

/// The format that a file of them names.
inline constexpr const char* equilibria_certificates = "plumbline-equilibria-certificates";

/// The entry of a census: every equilibrium to at most so many digits and the ball that it is alone in, and
/// the boxes that exclude others.
/// \throws Error where the census leaves something undecided, or more than a
/// million boxes are needed
nlohmann::json equilibria_certificate(const CensusTask& task, const Census& census, int digits);

}  // namespace plumbline::proofs
