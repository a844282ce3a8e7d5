#pragma once
/// \file
/// Effects: those of the catalogue and some that are in no catalogue; where they can sit, how large they
/// are, and how they change the rig.

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "trial/simulator/scene.hpp"

namespace plumbline::simulator {

struct Kind {
  std::string_view id;           ///< as a report says it; "unknown" outside the catalogue
  std::string_view description;  ///< outside the catalogue
  bool at_joint;
  std::vector<std::string_view> names;  ///< of the parameters
  std::vector<bool> amplitude;          ///< which of them, and of `each`, scale with the strength
  bool inverse;                         ///< whether the effect vanishes as its amplitude grows
  double reach;                         ///< how far beyond the first size the amplitude may go, as a factor
  bool (*possible)(const Scene&, Place);
  Values (*draw)(const Scene&, Place, Random&);  ///< of a size that labs meet
  void (*add)(Physics&, const Plan&, Place, const Values&);
  std::vector<std::string_view> each = {};  ///< parameters that follow any number of times: a_1, a_2, …
  std::string_view family = "one effect";   ///< under which results are counted
  bool by_run = false;  ///< those that follow are one a joint in each run: a_1_1, a_1_2, …

  /// Name of a parameter, and whether it scales with the strength.
  [[nodiscard]] std::string name(const Plan& plan, std::size_t parameter) const;
  [[nodiscard]] bool scales(std::size_t parameter) const;
};

/// The family of those with a value of its own at each joint.
constexpr std::string_view one_at_each_joint = "a value of its own at each joint";

/// Every effect that a diagnosis can name.
const std::vector<Kind>& catalogue();
/// Its parts.
std::vector<Kind> common_to_all_joints();
std::vector<Kind> joint_laws();
std::vector<Kind> sensors();
std::vector<Kind> masses();

/// Effects that are in no catalogue: what a diagnosis must call unknown.
const std::vector<Kind>& outside();

/// Those of both with which the first trial began. It keeps to them, so that a seed of it means the same
/// experiments in every version of the program.
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

/// A kind at a joint where it is possible in this scene, of a size that labs meet; kind is null where the
/// kind is impossible here.
Effect draw_effect(const Kind& kind, const Scene& scene, Random& random);

Physics physics_with(const Plan& plan, const std::vector<Effect>& effects);

}  // namespace plumbline::simulator
