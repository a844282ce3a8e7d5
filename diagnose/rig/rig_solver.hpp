#pragma once
/// \file
/// Follows the chain from one reading to the next: Newton's method while the equilibrium stays stable and
/// near, damped motion to the next stable equilibrium where it does not (a snap).

#include <plumbline/loaded/loaded_system.hpp>

#include "diagnose/rig/rig_model.hpp"

namespace plumbline::diagnose {

/// \tparam Bandwidth  that of the layout
template <int Bandwidth>
class RigSolver {
 public:
  /// \param readings  number of readings: it limits the Newton steps, so that a rig that snaps at every
  /// reading
  ///                  is abandoned
  RigSolver(const Layout& layout, std::size_t readings);
  RigSolver(const RigSolver&) = delete;
  RigSolver& operator=(const RigSolver&) = delete;

  /// Moves `posture` from an equilibrium under `before` to the one under `imposed`.
  /// \param guess  a posture near the result, tried first
  /// \returns false where no equilibrium is reached; `posture` is then meaningless
  bool follow(const RigStep& step, const Imposed& before, const Imposed& imposed, const Posture& guess,
              Posture& posture);

  /// Prepares neighbour() at the posture of the last follow().
  void prepare(const RigStep& step, const Imposed& imposed, const Posture& posture);

  /// The posture of a rig that differs little from the one followed, by one chord step with the factors of
  /// the last follow(). The rounding residual at the posture itself is subtracted, so that a rig that does
  /// not differ in this run has the same posture to the last bit.
  void neighbour(const RigStep& step, const Imposed& imposed, const Posture& posture, Posture& result);

  /// The end point of a posture under loads along the chain, at the drive.
  Vector2 end_point(const RunRig& run, const ChainLoads& loads, const Posture& posture);

  /// Whether the last follow() went through a snap.
  [[nodiscard]] bool snapped() const { return snapped_; }

 private:
  /// Careful: stops where the steps do not shrink as they do along one branch.
  enum class Pace { careful, free };
  bool newton(const RigStep& step, const Imposed& imposed, Pace pace, Posture& posture);
  bool descend(const RigStep& step, const Imposed& imposed, Posture& posture);
  /// The chord step that cancels the residual at a posture.
  void balance(const RigStep& step, const Imposed& imposed, const Posture& posture);
  /// Makes the states of the dry contacts consistent with the posture. \returns whether one changed
  bool settle(const RigStep& step, bool all, Posture& posture) const;

  RigModel<Bandwidth> model_;
  LoadedSystem<RigModel<Bandwidth>> system_;
  Posture trial_;
  std::vector<JointMemory> nothing_remembered_;
  Vector<double> prepared_turn_;  ///< the rounding residual where follow() ended
  Point<double> prepared_push_{0, 0};
  long steps_left_;  ///< Newton and flow steps before the rig is abandoned
  bool snapped_ = false;
};

extern template class RigSolver<1>;
extern template class RigSolver<2>;
extern template class RigSolver<4>;

}  // namespace plumbline::diagnose
