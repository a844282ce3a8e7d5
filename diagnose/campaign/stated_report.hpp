#pragma once
/// \file
/// A report of a diagnosis as comparisons and scores read it.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/files/json_file.hpp"

namespace plumbline::campaign {

/// What is read of a report in the format "gap-diagnosis/2" (docs/schemas/gap-diagnosis.schema.json).
struct StatedReport {
  struct Bounds {
    double low, high;
    double value = 0;       ///< the estimate itself
    std::string unit = {};  ///< "ratio" for one
  };
  struct Ranked {
    std::vector<std::string> effects;
    double probability;
  };

  std::string verdict;                               ///< none, identified, ambiguous, partial, unknown
  std::vector<std::string> effects;                  ///< the best explanation
  std::vector<std::vector<std::string>> equivalent;  ///< the others of its class
  std::map<std::string, Bounds> bounds;              ///< by parameter_key
  std::vector<Ranked> ranking;
  std::optional<std::size_t> joint;  ///< with the largest share
  std::string channel;               ///< with the largest share
  std::optional<double> shrunk;      ///< held-out residual after, over the noise floor
  std::string sense = {};            ///< of a change: added, removed, either; else empty
};

/// \throws Error that names the source and what is missing
StatedReport report_from(const nlohmann::json& json, const std::string& source);

/// An effect as reports and labels name it.
struct EffectName {
  std::string id;
  std::size_t joint = 0;  ///< from 1; 0 where it is not at one joint
  /// "id" or "id(joint)"
  [[nodiscard]] std::string key() const;
};
/// From an object with "id" and "joint".
/// \throws Error at the place of anything else
EffectName effect_name(const files::JsonValue& effect);

/// The keys of a list of effects, or of one alone; each is a text, or an object with "id" and "joint".
/// \throws Error at the place of anything else
std::vector<std::string> effect_keys(const files::JsonValue& effects);

/// "effect key/parameter"
std::string parameter_key(const std::string& effect, const std::string& name);

}  // namespace plumbline::campaign
