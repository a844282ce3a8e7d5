#pragma once
/// \file
/// The label of an experiment: its true effects, withheld from the diagnosis.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/files/json_file.hpp"

namespace plumbline::trial {

struct TrueEffect {
  std::string id;         ///< of the catalogue; "unknown" for a cause outside it
  std::size_t joint = 0;  ///< from 1; 0 where it is not at one joint
  std::vector<std::pair<std::string, double>> parameters;
  double strength = 0;  ///< of this effect alone, as in Label
};

struct Label {
  std::string name;
  std::vector<TrueEffect> effects;                   ///< empty for noise alone
  std::vector<std::vector<std::string>> equivalent;  ///< aliases in this experiment
  double strength = 0;                               ///< rms change of the measured values, in sigmas
  std::string noise;                                 ///< declared, misdeclared, outliers, ar1
  double noise_scale = 1;                            ///< true over declared sigma
  std::string description;                           ///< of an effect outside the catalogue
  std::string family = {};   ///< a group of experiments, by which results are counted first; or empty
  std::string channel = {};  ///< "Fx" or "Fx, Fy": the channels where an unknown cause shows most
};

/// "id" or "id(joint)".
std::string effect_key(const std::string& id, std::size_t joint);

/// Whether the effect is outside the catalogue.
bool outside_catalogue(const Label& label);

/// The effects that a diagnosis can name: "id", and "id(j)" for one at a joint.
using Catalogue = std::map<std::string, std::string>;

/// The label for a diagnosis with this catalogue: an effect that it lacks becomes an unknown cause with its
/// description.
Label in_terms_of(const Catalogue& catalogue, Label label);

nlohmann::ordered_json as_json(const Label& label);
/// \param source  named in errors
/// \throws Error when the JSON is not a label
Label label_from(const nlohmann::json& json, const std::string& source);

}  // namespace plumbline::trial
