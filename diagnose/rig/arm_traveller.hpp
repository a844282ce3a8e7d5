#pragma once
/// \file
/// An arm in one run: its posture, and the memory of its joints.

#include <optional>
#include <plumbline/arm/arm_equilibrium.hpp>
#include <vector>

#include "diagnose/rig/arm_rig.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/rig/joint_states.hpp"

namespace plumbline::diagnose {

class ArmTraveller {
 public:
  /// \param own      the rig in this run
  /// \param sliders  of each joint: as many as any rig beside it has
  ArmTraveller(const Experiment& experiment, const Rig& own, const Run& run, std::size_t sliders);

  /// Commands the joints and loads the arm as a stop says, as late as the drives follow it.
  void head_for(const Stop& stop, const Passage& passage);
  /// Comes to rest there: Newton's method, with contacts of the joints that settle on the way.
  /// \returns false where there is no rest near the command
  bool settle();
  /// The same beside an arm that differs little and has come to rest: its contacts hold, and a chord step by
  /// its tangent leads there, to first order.
  bool settle_beside(const ArmTraveller& other);
  /// Keeps the joints in mind as they are.
  void remember();
  /// The channels of the reading, as a row of a trace.
  /// \param told  orientations of the points on the nominal arm, by which theirs are told
  void write(Eigen::Ref<Eigen::ArrayXd> row, const std::vector<Eigen::Matrix3d>& told) const;

  [[nodiscard]] const JointStates& joints() const { return joints_; }
  [[nodiscard]] double joint_angle(std::size_t joint) const { return coordinate_(joint_[joint]); }

 private:
  /// Numbers of the freedoms that another arm has too, in its order.
  [[nodiscard]] std::vector<Eigen::Index> shared_with(const ArmTraveller& other) const;
  /// The compliance of all freedoms, of the arm as it is.
  void soften();
  /// Brings the arm to the temperature and the command of a reading, where either changes it.
  void grow(const Reading& reading);
  /// A place on a link at that temperature.
  [[nodiscard]] OnLink<double> expanded(OnLink<double> at) const;
  /// A frame of the posture, moved to first order to where the arm stands.
  /// \param movers  number of freedoms that move it
  [[nodiscard]] Pose<double> moved(Pose<double> frame, std::size_t movers) const;
  [[nodiscard]] Vector3<double> turn_of_tool() const;
  [[nodiscard]] Pose<double> of(const OnLink<double>& point, const Vector3<double>& tool_turn) const;
  /// Loads the arm with the wrench of a reading, as the load cell's errors leave it.
  void load(const Reading& reading);
  void hold_weight();
  /// Begins a step of Newton's method at coordinates.
  void stand_at(Vector<double> coordinates);
  /// What springs in the structure add to the load of a joint.
  [[nodiscard]] Torque balance(std::size_t joint, double coordinate) const;
  /// Generalised forces of gravity, wrenches and balances, less what the servos hold.
  [[nodiscard]] Vector<double> forces(const ArmPosture<double>& posture,
                                      const Vector<double>& coordinates) const;
  /// Residual of all freedoms at the posture, in their coordinates.
  [[nodiscard]] Vector<double> residual(const Vector<double>& force) const;
  /// Its derivatives, by those of the forces.
  [[nodiscard]] Matrix<double> tangent(const Matrix<double>& stiffness) const;
  /// The torque of a joint's own law where the arm stands: of its spring, and of what acts beside it.
  [[nodiscard]] Torque own_torque(std::size_t joint) const;
  /// Of that, what acts in parallel with the spring: the history, and user effects.
  [[nodiscard]] Torque torque_beside_spring(std::size_t joint, double q) const;
  /// The torque on a joint of the springs that couple it to its neighbours.
  [[nodiscard]] double from_neighbours(std::size_t joint) const;
  /// \returns the length of the longest step
  double newton_step();
  /// The same for an arm on a mount that yields.
  void yield_at_base();
  bool come_to_rest(bool contacts_hold);
  bool come_to_rest_on_mount(bool contacts_hold);
  bool change_contacts(bool all);
  void start();
  [[nodiscard]] const Rig& rig() const { return joints_.rig(); }
  [[nodiscard]] const JointLaw& law(std::size_t joint) const { return joints_.on().joint[joint]; }
  [[nodiscard]] const Contact* contacts_of(std::size_t joint) const {
    return contact_.data() + joint * sliders_;
  }
  /// Whether the run measures a channel.
  [[nodiscard]] bool reads(const Channel& channel) const;
  [[nodiscard]] double torque_of_drive(std::size_t joint, double load) const;

  const Experiment* experiment_;
  const Run* run_;
  std::vector<Channel> measured_;
  JointStates joints_;
  double growth_ = 1;                ///< of the arm's lengths, by its temperature
  SerialArm<double> arm_;            ///< so long, see ArmRig::at(), on its mount as it yields
  std::vector<Eigen::Index> joint_;  ///< their freedoms
  Matrix<double> compliance_;        ///< of all freedoms; zero for joints with a law
  std::size_t sliders_;              ///< of each joint
  std::vector<Contact> contact_;
  Vector<double> target_;  ///< coordinates of the arm that does not yield
  Vector<double> coordinate_;
  std::optional<ArmPosture<double>> posture_;  ///< where the last step of Newton's method began
  Vector<double> at_;                          ///< its coordinates
  Vector<double> held_;                        ///< generalised forces that the servos hold
  std::vector<ArmWrench<double>> wrenches_;
  Vector<double> residual_;  ///< at the posture, with its derivatives
  Eigen::PartialPivLU<Matrix<double>> tangent_;
  Vector3<double> load_ = Vector3<double>::Zero();  ///< force of the wrench, for user effects
  std::vector<double> way_;  ///< of the joints' commands: 1 or -1, 0 before the first motion
};

}  // namespace plumbline::diagnose
