#pragma once
/// \file
/// An arm in one run: its posture, and the memory of its joints.

#include <plumbline/arm/arm_equilibrium.hpp>
#include <vector>

#include "diagnose/rig/arm_rig.hpp"
#include "diagnose/rig/delayed.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

class ArmTraveller {
 public:
  /// \param own      the rig in this run
  /// \param sliders  of each joint: as many as any rig beside it has
  ArmTraveller(const Experiment& experiment, const Rig& own, const Run& run, std::size_t sliders);

  /// Commands the joints and loads the arm as a stop says, as late as the drives follow it.
  void head_for(const Stop& stop);
  /// Comes to rest there: Newton's method, with contacts of the joints that settle on the way.
  /// \returns false where there is no rest near the command
  bool settle();
  /// Prepares settle_beside() of others.
  void prepare();
  /// The same beside an arm that differs little and has come to rest: its contacts hold, and a chord step by
  /// its tangent leads there.
  bool settle_beside(const ArmTraveller& other);
  /// Keeps the joints in mind as they are.
  void remember();
  /// The channels of the reading, as a row of a trace.
  void write(Eigen::Ref<Eigen::ArrayXd> row) const;

 private:
  /// Lets what has slid out bend by its length, which Rig::flexibility makes yield in an arm.
  void extend(const std::vector<double>& command);
  /// The compliance of all freedoms, of the arm as it is.
  void soften();
  /// Lengthens the arm by the temperature of a reading.
  void expand(const Reading& reading);
  /// A place on a link at that temperature.
  [[nodiscard]] OnLink<double> expanded(OnLink<double> at) const;
  [[nodiscard]] Vector3<double> turn_of_tool(const ArmPosture<double>& posture) const;
  [[nodiscard]] Pose<double> of(const OnLink<double>& point, const ArmPosture<double>& posture,
                                const Vector3<double>& tool_turn) const;
  void hold_weight();
  /// Loads at a posture: of gravity, wrenches and balances, less what the servos hold.
  [[nodiscard]] ArmLoads<double> loads(const ArmPosture<double>& posture) const;
  /// Residual of all freedoms in their coordinates, and its derivatives.
  void balance(const ArmLoads<double>& at, Vector<double>& residual, Matrix<double>& slope) const;
  void couple(Vector<double>& residual, Matrix<double>& slope) const;
  /// \returns the length of the longest step
  double newton_step();
  /// The same for an arm on a mount that yields.
  void yield_at_base();
  bool come_to_rest(bool contacts_hold);
  bool come_to_rest_on_mount(bool contacts_hold);
  bool change_contacts(bool all);
  void start();
  [[nodiscard]] RigStep step() const { return {on_, interval_, memory_}; }
  [[nodiscard]] const Contact* contacts_of(std::size_t joint) const {
    return contact_.data() + joint * sliders_;
  }
  /// Whether the run measures a channel.
  [[nodiscard]] bool reads(const Channel& channel) const;
  [[nodiscard]] double torque_of_drive(std::size_t joint, double load) const;

  const Experiment* experiment_;
  const Run* run_;
  std::vector<Channel> measured_;
  LedCommand command_;
  RunRig on_;
  SerialArm<double> arm_;            ///< at its temperature, on its mount as it yields
  double growth_ = 1;                ///< of its lengths
  std::vector<Eigen::Index> joint_;  ///< their freedoms
  Matrix<double> compliance_;        ///< of all freedoms; zero for joints with a law
  std::size_t sliders_;              ///< of each joint
  std::vector<Contact> contact_;
  std::vector<JointMemory> memory_;
  TimeStep interval_;
  Vector<double> target_;  ///< coordinates of the arm that does not yield
  Vector<double> coordinate_;
  Vector<double> held_;  ///< generalised forces that the servos hold
  std::vector<ArmWrench<double>> wrenches_;
  Vector<double> residual_;  ///< of the last step, with its derivatives
  Matrix<double> slope_;
  Eigen::PartialPivLU<Matrix<double>> tangent_;
  std::vector<double> rest_;        ///< where the joints stood if nothing yielded
  std::vector<double> way_;         ///< of their commands: 1 or -1, 0 before the first motion
  double time_ = 0, last_way_ = 0;  ///< of the last reading; length of the last step of the commands
  bool moved_ = false;
};

}  // namespace plumbline::diagnose
