#pragma once
/// \file
/// Effects: those of the catalogue and some that are in no catalogue; where they can sit, how large they
/// are, and how they change the rig.

#include <string>
#include <string_view>
#include <utility>

#include "simulator/physics.hpp"
#include "simulator/random.hpp"

namespace plumbline::simulator {

/// The experiment as the lab expects it to go: what an effect must be compared with.
struct Scene {
  const Plan& plan;
  std::vector<double> deflection;  ///< the largest of each joint
  double force = 0;                ///< the largest
  double duration = 0, pause = 0;  ///< of the longest run; the shortest time between readings
};

using Values = std::vector<double>;  ///< parameters, in the order of their names

struct Kind {
  std::string_view id;           ///< as a report says it; "unknown" outside the catalogue
  std::string_view description;  ///< outside the catalogue
  bool at_joint;
  std::vector<std::string_view> names;  ///< of the parameters
  std::vector<bool> amplitude;          ///< which of them scale with the strength
  bool inverse;                         ///< whether the effect vanishes as its amplitude grows
  double reach;                         ///< how far beyond the first size the amplitude may go, as a factor
  bool (*possible)(const Scene&, std::size_t joint);
  Values (*draw)(const Scene&, std::size_t joint, Random&);  ///< of a size that labs meet
  void (*add)(Physics&, const Plan&, std::size_t joint, const Values&);
};

const std::vector<Kind>& catalogue();
const std::vector<Kind>& outside();

/// One effect as it acts.
struct Effect {
  const Kind* kind;
  std::size_t joint;  ///< from 0
  Values values;

  [[nodiscard]] Effect scaled(double factor) const;
};

/// A kind at a joint where it is possible in this scene, of a size that labs meet; kind is null where the
/// kind is impossible here.
Effect draw_effect(const Kind& kind, const Scene& scene, Random& random);

Physics physics_with(const Plan& plan, const std::vector<Effect>& effects);

}  // namespace plumbline::simulator
