#pragma once
/// \file
/// What is withheld from the diagnosis: the true effects of an experiment.

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/files/json_file.hpp"

namespace plumbline::trial {

struct TrueEffect {
  std::string id;         ///< of the effect catalogue; "unknown" where it is in no catalogue
  std::size_t joint = 0;  ///< counted from 1; 0 where it is not at one joint
  std::vector<std::pair<std::string, double>> parameters;
  double strength = 0;  ///< of this effect alone, as in Label
};

struct Label {
  std::string name;
  std::vector<TrueEffect> effects;                   ///< empty: nothing but noise
  std::vector<std::vector<std::string>> equivalent;  ///< what this experiment cannot tell from them
  double strength = 0;       ///< rms over all measured values of the gap over its sigma
  std::string noise;         ///< declared, misdeclared, outliers, ar1
  double noise_scale = 1;    ///< true sigma over declared
  std::string description;   ///< of an effect outside the catalogue
  std::string family = {};   ///< of experiments: what results are counted by first; or none
  std::string channel = {};  ///< "Fx" or "Fx, Fy": where such an effect shows most
};

/// "id" or "id(joint)".
std::string effect_key(const std::string& id, std::size_t joint);
/// The key of an effect in JSON, where it is its key or an object with "id" and "joint"; the keys of a list
/// of them, or of one alone. \throws Error at the place of anything else
std::string effect_key(const files::JsonValue& effect);
std::vector<std::string> effect_keys(const files::JsonValue& effects);

/// Whether the one effect is in no catalogue.
bool outside_catalogue(const Label& label);

/// The effects that a diagnosis can name: "id", and "id(j)" where it sits at one joint.
using Catalogue = std::set<std::string>;

/// The label as a diagnosis with this catalogue can know it: where it lacks one of the effects, the cause is
/// unknown, and described by what it lacks.
Label in_terms_of(const Catalogue& catalogue, Label label);

nlohmann::ordered_json as_json(const Label& label);
/// \param source  named in errors
/// \throws Error when the JSON is not a label
Label label_from(const nlohmann::json& json, const std::string& source);

}  // namespace plumbline::trial
