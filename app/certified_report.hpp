#pragma once
/// \file
/// What is proved of a followed path.

#include <nlohmann/json.hpp>

#include "proofs/certified_path.hpp"
#include "proofs/followed_path.hpp"

namespace plumbline::app {

/// One certificate a branch.
using CertifiedReport = std::vector<proofs::PathCertificate>;

/// \param symmetries  that the chain has exactly
CertifiedReport certify(const proofs::PathReport& report, const Chain<Interval>& chain,
                        const Loading<Interval>& loading, const std::vector<proofs::Symmetry>& symmetries);

/// Whether everything is proved but what lies in the gaps around bifurcations.
bool complete(const CertifiedReport& report);

std::string as_text(const CertifiedReport& report);
nlohmann::ordered_json as_json(const CertifiedReport& report);

}  // namespace plumbline::app
