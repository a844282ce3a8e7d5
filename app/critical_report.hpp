#pragma once
/// \file
/// Critical forces and shapes of a chain, as text for a person, CSV and JSON.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <plumbline/structure/structure.hpp>

#include "proofs/exact/critical_modes.hpp"
#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_space.hpp"
#include "statement/beam.hpp"

namespace plumbline::app {

struct CriticalModes {
  std::string chain;  ///< name
  Structure<Rational> data;
  std::vector<proofs::CriticalMode> modes;    ///< ascending by force
  std::size_t all = 0;                        ///< modes that there are
  std::optional<statement::Beam> beam;        ///< that the chain stands for
  std::optional<proofs::StabilityLoss> loss;  ///< instead of modes, where a load follows the chain
};

/// Modes of a straight chain in space.
struct SpaceModes {
  std::string chain, words;
  std::size_t links, all;
  std::vector<proofs::SpaceMode> modes;
};
std::string as_text(const SpaceModes& result);
std::string as_csv(const SpaceModes& result);
nlohmann::ordered_json as_json(const SpaceModes& result, int digits);

/// The critical torque of a straight chain in space.
struct SpaceTorque {
  std::string chain, words;
  std::size_t links;
  std::string torque;
  bool conservative;
};
std::string as_text(const SpaceTorque& result);
std::string as_csv(const SpaceTorque& result);
nlohmann::ordered_json as_json(const SpaceTorque& result, int digits);

/// Everything about one chain, in 80 columns where its size permits.
std::string as_text(const CriticalModes& result);
/// One line a mode, for a table of chains.
std::string as_text(const std::vector<CriticalModes>& results);
/// `chain,mode,force`, a row a mode.
std::string as_csv(const std::vector<CriticalModes>& results);
nlohmann::ordered_json as_json(const std::vector<CriticalModes>& results,
                               const std::vector<std::string>& errors, int digits);

}  // namespace plumbline::app
