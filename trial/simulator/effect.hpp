#pragma once
/// \file
/// Effects of the simulator: those of the catalogue and some outside it.

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "trial/simulator/scene.hpp"

namespace plumbline::simulator {

struct Kind {
  std::string_view id;           ///< as in reports; "unknown" outside the catalogue
  std::string_view description;  ///< outside the catalogue
  bool at_joint;
  std::vector<std::string_view> names;  ///< of the parameters
  std::vector<bool> amplitude;          ///< which parameters, and which of `each`, scale with the strength
  bool inverse;                         ///< the effect vanishes as its amplitude grows
  double reach;                         ///< largest factor on the first amplitude
  bool (*possible)(const Scene&, Place);
  Values (*draw)(const Scene&, Place, Random&);  ///< at a typical size
  void (*add)(Physics&, const Plan&, Place, const Values&);
  std::vector<std::string_view> each = {};  ///< parameters with one value a joint: a_1, a_2, …
  std::string_view family = "one effect";   ///< by which results are counted
  bool by_run = false;                      ///< one value a joint and run: a_1_1, a_1_2, …

  /// Name of a parameter, and whether it scales with the strength.
  [[nodiscard]] std::string name(const Plan& plan, std::size_t parameter) const;
  [[nodiscard]] bool scales(std::size_t parameter) const;
};

/// The family of effects with one value a joint.
constexpr std::string_view one_at_each_joint = "a value of its own at each joint";

/// Every effect that a diagnosis can name.
const std::vector<Kind>& catalogue();
/// Its parts.
std::vector<Kind> common_to_all_joints();
std::vector<Kind> joint_laws();
std::vector<Kind> sensors();
std::vector<Kind> masses();

/// Effects outside the catalogue, for which `unknown` is right.
const std::vector<Kind>& outside();

/// The effects of both kinds with which the first trial began: its seeds mean the same experiments in every
/// version.
std::span<const Kind> first_catalogue();
std::span<const Kind> first_outside();

/// \throws Error for an id that is not in the catalogue
const Kind& kind(std::string_view id, bool at_joint);

/// One effect as it acts.
struct Effect {
  const Kind* kind;
  Place joint;
  Values values;

  [[nodiscard]] Effect scaled(double factor) const;
};

/// A kind at a possible joint of this scene, at a typical size; kind is null where it is impossible.
Effect draw_effect(const Kind& kind, const Scene& scene, Random& random);

Physics physics_with(const Plan& plan, const std::vector<Effect>& effects);

}  // namespace plumbline::simulator
