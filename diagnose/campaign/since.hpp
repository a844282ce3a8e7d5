#pragma once
/// \file
/// Since when an effect is there, by diagnoses in the order of time.

#include "diagnose/campaign/outcome.hpp"

namespace plumbline::campaign {

/// An effect that is named, alone or in a class, by every diagnosis from one on to the last.
struct Since {
  std::string effect;  ///< its key
  std::size_t first;   ///< by its place among the outcomes
};

/// In the order of their beginnings. A diagnosis that failed neither begins nor ends anything.
/// \param outcomes  in the order of time
std::vector<Since> since_when(const std::vector<Outcome>& outcomes);

}  // namespace plumbline::campaign
