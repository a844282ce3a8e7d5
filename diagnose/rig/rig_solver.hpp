#pragma once
/// \file
/// Follows the chain from one reading to the next along the branch that the rig follows: Newton's iteration
/// while the equilibrium stays stable and near, damped motion to the next stable one where it does not.

#include <plumbline/loaded/loaded_system.hpp>

#include "diagnose/rig/rig_model.hpp"

namespace plumbline::diagnose {

/// \tparam Bandwidth  that of the layout
template <int Bandwidth>
class RigSolver {
 public:
  /// \param readings  that it is to follow: a chain that takes far more of Newton's steps for them than any
  /// bench does, snapping at every reading, is given up
  RigSolver(const Layout& layout, std::size_t readings);
  RigSolver(const RigSolver&) = delete;
  RigSolver& operator=(const RigSolver&) = delete;

  /// Moves `posture` to the equilibrium under `imposed`, coming from where it is, which is an equilibrium
  /// under `before`.
  /// \param guess  where that may be; looked at first
  /// \returns false where there is none within reach; `posture` is then without meaning
  bool follow(const RigStep& step, const Imposed& before, const Imposed& imposed, const Posture& guess,
              Posture& posture);

  /// Prepares neighbour() at the posture that follow() reached.
  void prepare(const RigStep& step, const Imposed& imposed, const Posture& posture);

  /// One chord step with the factors of the last follow(): the posture of a rig that differs little from the
  /// one followed. What rounding leaves out of balance at the posture itself does not enter: a rig that does
  /// not differ in this run has the same posture, to the bit.
  void neighbour(const RigStep& step, const Imposed& imposed, const Posture& posture, Posture& result);

  /// The end point of a posture: the place of the drive.
  Vector2 end_point(const RunRig& run, const Posture& posture);

  /// Whether the last follow() went through a snap.
  [[nodiscard]] bool snapped() const { return snapped_; }

 private:
  /// Careful: gives up where the steps do not shrink as they do along one branch.
  enum class Pace { careful, free };
  bool newton(const RigStep& step, const Imposed& imposed, Pace pace, Posture& posture);
  bool descend(const RigStep& step, const Imposed& imposed, Posture& posture);
  /// The chord step that cancels what is out of balance at a posture.
  void balance(const RigStep& step, const Imposed& imposed, const Posture& posture);
  /// Brings the dry contacts in line with the posture, all of them or the first that is not. All at once
  /// is fast but can go in circles, one at a time does not (Murty's rule). \returns whether one changed
  bool settle_contacts(const RigStep& step, bool all, Posture& posture) const;

  RigModel<Bandwidth> model_;
  LoadedSystem<RigModel<Bandwidth>> system_;
  Posture trial_;
  std::vector<JointMemory> nothing_remembered_;
  Vector<double> prepared_turn_;  ///< that rounding still asks for where follow() ended
  Point<double> prepared_push_{0, 0};
  long steps_left_;  ///< of Newton's method and of the flow, before it is given up
  bool snapped_ = false;
};

extern template class RigSolver<1>;
extern template class RigSolver<2>;
extern template class RigSolver<4>;

}  // namespace plumbline::diagnose
