#pragma once
/// \file
/// Follows the chain from one reading to the next along the branch that the rig follows: Newton's iteration
/// while the equilibrium stays stable and near, damped motion to the next stable one where it does not.

#include <Eigen/LU>
#include <vector>

#include "diagnose/model/statics.hpp"

namespace plumbline::diagnose {

class RigSolver {
 public:
  explicit RigSolver(const Layout& layout);

  /// Moves `posture` to the equilibrium under `imposed`, coming from where it is, which is an equilibrium
  /// under `before`.
  /// \param guess  where that may be; looked at first
  /// \returns false where there is none within reach; `posture` is then without meaning
  bool follow(const RunRig& run, const Imposed& before, const Imposed& imposed, const TimeStep& interval,
              const std::vector<JointMemory>& memory, const Posture& guess, Posture& posture);

  /// Prepares neighbour() at the posture that follow() reached.
  void settle(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
              const std::vector<JointMemory>& memory, const Posture& posture);

  /// One chord step with the factors of the last follow(): the posture of a rig that differs little from the
  /// one followed. What rounding leaves out of balance at the posture itself does not enter: a rig that does
  /// not differ in this run has the same posture, to the bit.
  Posture neighbour(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
                    const std::vector<JointMemory>& memory, const Posture& posture);

  /// The end point of a posture.
  Vector2 end_point(const RunRig& run, const Posture& posture, const std::vector<JointMemory>& memory);

  /// Whether the last follow() went through a snap.
  [[nodiscard]] bool snapped() const { return snapped_; }

 private:
  /// Careful: gives up where the steps do not shrink as they do along one branch.
  enum class Pace { careful, free };
  bool newton(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
              const std::vector<JointMemory>& memory, Pace pace, Posture& posture);
  bool descend(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
               const std::vector<JointMemory>& memory, Posture& posture);
  /// Factorises with `damping` times the joints' damping matrix added. \returns whether the tangent is that
  /// of a minimum on the constraint
  bool factorise(const RunRig& run, ControlMode control, double damping);
  /// Solves for the step that cancels residual and constraint. \returns its largest angle
  double solve(const RunRig& run, const Imposed& imposed, const Posture& posture);
  void apply(double share, Posture& posture) const;
  /// Brings the dry contacts in line with the posture, all of them or the first that is not. All at once
  /// is fast but can go in circles, one at a time does not (Murty's rule). \returns whether one changed
  bool settle_contacts(const RunRig& run, const TimeStep& interval, const std::vector<JointMemory>& memory,
                       bool all, Posture& posture) const;

  Equations equations_;
  std::vector<double> step_, column_x_, column_y_;
  Vector2 force_step_ = Vector2::Zero();
  std::vector<double> settled_step_;  ///< that rounding still asks for where follow() ended
  Vector2 settled_force_step_ = Vector2::Zero();
  Eigen::Matrix2d flexibility_ = Eigen::Matrix2d::Identity();
  bool snapped_ = false;
};

}  // namespace plumbline::diagnose
