#pragma once
/// \file
/// The events of a followed path to up to fifty digits.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proofs/paths/followed_path.hpp"
#include "proofs/paths/located_event.hpp"

namespace plumbline::app {

/// Events branch by branch, located.
using LocatedReport = std::vector<std::vector<BranchEvent<proofs::Located>>>;

LocatedReport locate(const proofs::PathReport& report, const Chain<Rational>& chain,
                     const Loading<proofs::Located>& loading);

std::string as_text(const LocatedReport& report, int digits);
nlohmann::ordered_json as_json(const LocatedReport& report, int digits);

}  // namespace plumbline::app
