#pragma once
/// \file
/// From the bodies and joints of a simulator's model to a planar serial chain.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/exchange/read_joint.hpp"

namespace plumbline::exchange {

/// Whether a site, frame or link of this name is an end point: one of its words is end, tip, tool, tcp or the
/// like.
bool names_an_end(const std::string& name);

/// The plane of a chain: x and y such that angles count about x × y. In a vertical plane y is upward.
struct Plane {
  Eigen::Vector3d x{1, 0, 0}, y{0, 1, 0}, origin{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d normal() const;
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& vector) const {
    return {x.dot(vector), y.dot(vector)};
  }
};

/// A joint of the model that became one of the chain.
struct TakenJoint {
  std::size_t number;  ///< among those of the model
  double sense;        ///< -1 where it turns the other way
  double straight;     ///< the chain's angle where that of the model is 0, rad
};

struct PlanarChain {
  diagnose::NominalChain chain;
  std::vector<std::string> notes;  ///< which joints were taken, what was assumed, what was left out
  Plane plane = {};
  std::vector<TakenJoint> joints = {};  ///< from the base on
  std::vector<std::string> names = {};  ///< of the joints, likewise
  bool weighs = false;                  ///< whether the model has gravity at all
  std::optional<ReadPoint> end = {};    ///< where the model names the end point
};

/// \param source  named in errors
/// \param kept    the joints that make the chain; the others are held as the reference configuration has
///                them. Empty: all
/// \throws Error, one line, that says what is not planar, not serial, or no hinge
PlanarChain planar_chain(const ReadModel& model, const std::string& source,
                         const std::vector<std::string>& kept = {});

}  // namespace plumbline::exchange
