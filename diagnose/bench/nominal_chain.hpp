#pragma once
/// \file
/// The nominal model: the chain and the effects that the simulator already contains.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/free_law.hpp"
#include "diagnose/bench/nominal_arm.hpp"

namespace plumbline::diagnose {

struct Effect;

/// An effect of the nominal model, of the catalogue or of the user, with its parameter values.
struct NominalEffect {
  std::string id;
  std::size_t joint = 0;  ///< from 1; 0 where the effect is not at one joint
  std::map<std::string, double> parameters;
  friend bool operator==(const NominalEffect&, const NominalEffect&) = default;

  /// "backlash(2)"
  [[nodiscard]] std::string label() const { return joint > 0 ? id + "(" + std::to_string(joint) + ")" : id; }
};

/// SI units, radians; lists are by link or joint. Of a joint alone the link counts as one of length 1, whose
/// end point and force stand for the joint's angle and torque.
struct NominalChain {
  std::vector<double> link_length, joint_stiffness, link_mass;
  std::array<double, 2> gravity{0, 0};  ///< the in-plane acceleration that it includes
  std::vector<double> rest;             ///< angles of the unloaded joints where a run names none; or empty
  std::vector<NominalEffect> effects;
  std::vector<FreeLaw> laws = {};  ///< what its joints carry besides, where no effect says why
  std::shared_ptr<const std::vector<Effect>> stated = nullptr;  ///< rows of the user's own, or none
  Device device = Device::chain;
  /// The arm in space whose joints and links these are; null for a chain in the plane. Lengths are then
  /// distances along its links, and a stiffness of zero is that of a rigid joint.
  std::shared_ptr<const NominalArm> arm = nullptr;

  [[nodiscard]] const EndKind& end() const { return end_kind(device); }
  /// Whether a joint, from 0, slides; else it turns.
  [[nodiscard]] bool slides(std::size_t joint) const;
  /// "joint 2", or the name that its file gives it.
  [[nodiscard]] std::string joint_name(std::size_t joint) const;
  /// Of a joint's coordinate, "rad" or "m", and of its torque, "N m" or "N".
  [[nodiscard]] const char* joint_unit(std::size_t joint) const { return slides(joint) ? "m" : "rad"; }
  [[nodiscard]] const char* torque_unit(std::size_t joint) const { return slides(joint) ? "N" : "N m"; }
  /// A joint alone has none.
  [[nodiscard]] bool has_links() const { return end().has_links; }
  [[nodiscard]] bool visits_poses() const { return end().visits_poses; }
  /// Names that its file gives the joints; none where it numbers them.
  [[nodiscard]] std::vector<std::string> joint_names() const;
  /// Whether it is a chain in a plane, whose end point may be put or loaded.
  [[nodiscard]] bool is_planar() const { return end().axes == 2; }
  /// Whether it has springs and weights alone.
  [[nodiscard]] bool plain() const { return effects.empty() && laws.empty(); }
};

}  // namespace plumbline::diagnose
