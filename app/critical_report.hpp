#pragma once
/// \file
/// Critical forces and shapes of a chain, as text for a person, CSV and JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proofs/exact/critical_modes.hpp"

namespace plumbline::app {

struct CriticalModes {
  std::string chain;  ///< name
  Chain<Rational> data;
  std::vector<proofs::CriticalMode> modes;  ///< ascending by force
};

/// Everything about one chain, in 80 columns where its size permits.
std::string as_text(const CriticalModes& result);
/// One line a mode, for a table of chains.
std::string as_text(const std::vector<CriticalModes>& results);
/// `chain,mode,force`, a row a mode.
std::string as_csv(const std::vector<CriticalModes>& results);
nlohmann::ordered_json as_json(const std::vector<CriticalModes>& results,
                               const std::vector<std::string>& errors, int digits);

}  // namespace plumbline::app
