#pragma once
/// \file
/// An arm in space and its variations in one run: how they come to rest at a stop, and what is read there.

#include <vector>

#include "diagnose/rig/arm_traveller.hpp"

namespace plumbline::diagnose {

/// Serves Walk. Between poses in space the way of an arm is that of a planner that nobody tells: it goes
/// there in one step. In a plane it goes as a chain does.
/// \pre the experiment and the rigs have an arm
class SpatialStatics {
 public:
  SpatialStatics(const Experiment& experiment, const Run& run, const Rig& rig,
                 const std::vector<Rig>& variations);

  /// Number of steps to each reading.
  [[nodiscard]] const std::vector<std::size_t>& parts() const { return parts_; }
  [[nodiscard]] static bool is_commanded(const Reading&) { return true; }
  /// \param beside  number of a variation, from 1; 0 for the rig
  [[nodiscard]] const JointStates& joints(std::size_t beside) const { return all_[beside].joints(); }
  [[nodiscard]] double joint_angle(std::size_t joint) const { return all_.front().joint_angle(joint); }

  /// \returns false where there is no rest near the command
  bool arrive(const Stop& stop, const Passage& passage);
  void remember();
  /// The channels of a reading, as a row of a trace. An arm has no use for the direction of the command.
  void write(std::size_t beside, std::size_t reading, double direction, Eigen::Ref<Eigen::ArrayXd> row) const;

 private:
  std::vector<ArmTraveller> all_;   ///< the rig, and its variations
  std::vector<std::size_t> parts_;  ///< see parts()
  /// By reading and point: its orientation on the nominal arm, by which that of a reading is told; none where
  /// orientations are not read.
  std::vector<std::vector<Eigen::Matrix3d>> told_;
};

}  // namespace plumbline::diagnose
