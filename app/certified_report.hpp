#pragma once
/// \file
/// What is proved of a followed path.

#include <nlohmann/json.hpp>

#include "app/loaded_paths.hpp"
#include "proofs/certified_path.hpp"

namespace plumbline {

/// One certificate a branch.
using CertifiedReport = std::vector<PathCertificate>;

CertifiedReport certify(const PathReport& report, const Chain<Interval>& chain,
                        const Loading<Interval>& loading);

/// Whether everything is proved but what lies in the gaps around bifurcations.
bool complete(const CertifiedReport& report);

std::string as_text(const CertifiedReport& report);
nlohmann::ordered_json as_json(const CertifiedReport& report);

}  // namespace plumbline
