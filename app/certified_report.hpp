#pragma once
/// \file
/// What is proved of a followed path.

#include <nlohmann/json.hpp>

#include "proofs/paths/certified_structure.hpp"
#include "proofs/paths/joined_branches.hpp"

namespace plumbline::app {

/// Whether everything is proved but what lies in the gaps around bifurcations.
bool complete(const proofs::JoinedBranches& proved);

std::string as_text(const proofs::JoinedBranches& proved);
/// One entry a branch.
nlohmann::ordered_json as_json(const proofs::JoinedBranches& proved);

std::string as_text(const std::vector<proofs::StructureCertificate>& proved);
/// One entry a branch.
nlohmann::ordered_json as_json(const std::vector<proofs::StructureCertificate>& proved);

}  // namespace plumbline::app
