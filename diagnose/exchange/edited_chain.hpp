#pragma once
/// \file
/// What a correction changes in a simulator's model, whatever its format: in the places and directions of the
/// model in its reference configuration.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/planar_chain.hpp"
#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

class EditedChain {
 public:
  /// \param model  corrected; its nominal chain is the one that was read
  /// \throws Error as planar_chain() does
  EditedChain(const Model& model, ReadModel read, Format format, const Means& means);

  [[nodiscard]] std::size_t size() const { return chain_.joints.size(); }
  [[nodiscard]] const Plane& plane() const { return chain_.plane; }
  [[nodiscard]] const ReadModel& read() const { return read_; }
  /// Where the model names the end point.
  [[nodiscard]] const ReadPoint& end() const { return *chain_.end; }
  /// What became of each effect.
  [[nodiscard]] const std::vector<Carried>& effects() const { return effects_; }
  [[nodiscard]] const Tree& after() const { return after_; }

  // Of joint j, from 0.
  [[nodiscard]] const ReadJoint& joint(std::size_t j) const { return read_.joints[chain_.joints[j].number]; }
  [[nodiscard]] std::size_t number(std::size_t j) const { return chain_.joints[j].number; }
  [[nodiscard]] double sense(std::size_t j) const { return chain_.joints[j].sense; }
  [[nodiscard]] const Hinge& before(std::size_t j) const;
  [[nodiscard]] const Hinge& after(std::size_t j) const;
  /// How far the angle at which its spring is at ease moves, in the model's coordinate.
  [[nodiscard]] double ease_moves(std::size_t j) const;

  // Of link j: its direction, and across it, counter-clockwise in the plane.
  [[nodiscard]] const Eigen::Vector3d& along(std::size_t j) const { return along_[j]; }
  [[nodiscard]] Eigen::Vector3d across(std::size_t j) const { return plane().normal().cross(along_[j]); }

  /// How far the base moves; how far joint j, or the end point, moves by the lengths of the links before it.
  [[nodiscard]] Eigen::Vector3d base_moves() const;
  [[nodiscard]] const Eigen::Vector3d& moves(std::size_t j) const { return moves_[j]; }

  /// A joint that is added in the chain.
  struct Added {
    const Body* body;
    std::size_t before;           ///< the joint that it stands before; size() after the last
    Eigen::Vector3d axis, place;  ///< where it is then, but for what the base moves
  };
  [[nodiscard]] std::vector<Added> in_series() const;
  /// Bodies that stand beside the chain, each with the joint that it is at.
  [[nodiscard]] std::vector<std::pair<const Body*, std::size_t>> beside() const;

  /// A name of ours as the model's own: "q2_play" as "elbow_play".
  [[nodiscard]] std::string own_name(const std::string& name) const;

  /// A mass that is added so that all weighs as it is to.
  struct Weight {
    std::string name;
    std::size_t link;  ///< that carries it; size() for the end point
    double mass;
    Eigen::Vector3d place;  ///< before anything moves but by the length of the link itself
  };
  struct Weights {
    Eigen::Vector3d gravity;
    std::vector<Weight> added;
  };
  /// Where something weighs otherwise than it did.
  [[nodiscard]] std::optional<Weights> weights() const;

 private:
  void measure_links();
  [[nodiscard]] double own_mass(std::size_t j) const;
  [[nodiscard]] const Body* payload() const;
  [[nodiscard]] bool weighs_otherwise() const;
  [[nodiscard]] double gravity() const;

  ReadModel read_;
  PlanarChain chain_;
  std::vector<Carried> effects_;
  Tree before_, after_;
  std::vector<Eigen::Vector3d> along_, moves_;
  std::vector<double> length_;
};

}  // namespace plumbline::exchange
