#pragma once
/// \file
/// Certificates of paths that need none of our code to check, in the format of
/// proofs/certificates/path-certificate-format.md.

#include <nlohmann/json_fwd.hpp>

#include "proofs/paths/joined_branches.hpp"

namespace plumbline::proofs {

/// The format that a file of them names.
inline constexpr const char* path_certificates = "plumbline-path-certificates";

/// What a path was followed with, in exact numbers.
struct PathGiven {
  std::string name;
  Chain<Rational> chain;
  bool rest_in_pi;  ///< the rest angles are multiples of pi
  Control control;
  Point<Rational> direction;  ///< of the load, of any length
};

/// The entry of proved branches: their points, to nine decimals (ProvedPoints::rounded), and what is proved
/// of the curves through them.
/// \throws Error where something failed
nlohmann::json path_certificate(const PathGiven& given, const JoinedBranches& proved);

}  // namespace plumbline::proofs
