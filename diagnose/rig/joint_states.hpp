#pragma once
/// \file
/// The joints of a rig under way in one run: what leads them, their laws, and what they remember.

#include <vector>

#include "diagnose/rig/delayed.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// A step of the walk, beside the one before.
struct Passage {
  bool first = true;  ///< the approach to where the run begins
  double dt = 0;      ///< s
  double share = 0;   ///< length of the command's step over that of the last one
};

class JointStates {
 public:
  /// \param own  the rig in this run
  JointStates(const Rig& own, const Run& run);

  /// Leads the joints to a stop, as late as their drives follow it; they go on as fast as the command does.
  /// \returns the command as the drives make it; it lasts until the next one
  const Reading& head_for(const Stop& stop, const Passage& passage);

  /// Keeps in mind where the joints have arrived.
  /// \param angle     of a joint, by its number
  /// \param contacts  of a joint: the states of its sliders
  template <class Angle, class Contacts>
  void remember(Angle angle, Contacts contacts) {
    for (std::size_t i = 0; i < memory_.size(); ++i) {
      diagnose::remember(on_, interval_, i, angle(i), contacts(i), memory_[i]);
      rest_then_[i] = on_.joint[i].rest;
    }
  }

  [[nodiscard]] const RunRig& on() const { return on_; }
  [[nodiscard]] const Rig& rig() const { return on_.rig; }
  [[nodiscard]] const std::vector<JointMemory>& memory() const { return memory_; }
  /// Of the last step.
  [[nodiscard]] const TimeStep& interval() const { return interval_; }
  [[nodiscard]] RigStep step() const { return {on_, interval_, memory_}; }

 private:
  RunRig on_;
  LedCommand command_;
  TimeStep interval_;
  std::vector<JointMemory> memory_;
  std::vector<double> rest_then_;  ///< of each joint, where it was remembered last
};

}  // namespace plumbline::diagnose
