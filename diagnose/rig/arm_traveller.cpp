#include "diagnose/rig/arm_traveller.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/rig/tube.hpp"

namespace plumbline::diagnose {
namespace {

constexpr int newton_limit = 40;
constexpr int joint_changes = 8;         // iterations that may change all contacts at once
constexpr double longest_step = 0.3;     // rad or m
constexpr double accuracy = 4e-15;       // of coordinates of order one: the next step would be rounding
constexpr double smallest_slope = 1e-6;  // of a joint that its load holds within its play, over its stiffness

Vector<double> column(const std::vector<double>& values) {
  return Eigen::Map<const Vector<double>>(values.data(), static_cast<Eigen::Index>(values.size()));
}

bool yields_by_law(const Rig& rig, std::size_t joint) {
  return rig.stiffness[joint] > 0;
}

}  // namespace

ArmTraveller::ArmTraveller(const Experiment& experiment, const Rig& own, const Run& run, std::size_t sliders)
    : experiment_(&experiment),
      run_(&run),
      measured_(run.measured()),
      command_(run, own.command_delay),
      on_(own, run.rest),
      arm_(on_.rig.arm->arm),
      sliders_(sliders),
      contact_(arm_.size() * sliders_, Contact::sticks),
      memory_(arm_.size()),
      rest_(arm_.size()),
      way_(arm_.size(), 0.0) {
  extend(run.rest);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    joint_.push_back(next);
    next += yields(arm_.links[i]) ? 7 : 1;
  }
  soften();
}

/// What has slid out of the link before bends up to the joint.
void ArmTraveller::extend(const std::vector<double>& command) {
  const SerialArm<double>& still = on_.rig.arm->arm;
  for (std::size_t i = 0; i < arm_.size() && on_.rig.flexibility > 0; ++i) {
    if (arm_.links[i].kind != JointKind::prismatic) continue;
    constexpr double shortest = 1e-6;  // m: as many freedoms wherever it stands
    const double length = std::max(std::abs(command[i]), shortest);
    arm_.links[i].compliance =
        still.links[i].compliance +
        carried_on(
            tube_compliance(std::copysign(length, command[i]) * still.links[i].axis, on_.rig.flexibility),
            still.far_end(i).translation());
  }
}

void ArmTraveller::soften() {
  compliance_ = compliance(arm_);
  for (std::size_t i = 0; i < joint_.size(); ++i)
    if (yields_by_law(on_.rig, i)) compliance_(joint_[i], joint_[i]) = 0;
}

void ArmTraveller::head_for(const Stop& stop) {
  const Reading& reading = command_.at(stop);
  const ArmRig& rig = *on_.rig.arm;
  const double dt = moved_ ? reading.t - time_ : 0;
  interval_ = moved_ ? time_step(on_, dt) : TimeStep{};
  interval_.end = reading.t;
  time_ = reading.t;
  const std::vector<double> before = on_.command;
  on_.turn_to(reading.rest);
  const double way = moved_ ? (column(on_.command) - column(before)).norm() : 0,
               share = last_way_ > 0 ? way / last_way_ : 0;
  last_way_ = way;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (moved_ && on_.command[i] != before[i]) way_[i] = on_.command[i] > before[i] ? 1 : -1;
    const double rest = on_.joint[i].rest;
    if (moved_)
      memory_[i].led = rest - rest_[i];
    else
      memory_[i].angle = rest;
    memory_[i].speed =
        dt > 0 ? share * memory_[i].turn / dt : 0;  // that of the last step, as the command goes on
    rest_[i] = rest;
  }
  expand(reading);
  if (on_.rig.flexibility > 0) extend(on_.command), soften();
  target_ = commanded(arm_, column(rest_));
  wrenches_.clear();
  if (!reading.wrench.empty()) {
    const Eigen::Map<const Vector6<double>> read(reading.wrench.data());
    const Vector3<double> zero = on_.rig.force_bias + on_.rig.force_drift * reading.t;
    const double gain = 1 + on_.rig.force_gain;
    wrenches_.push_back({expanded(rig.load), (read.head<3>() - zero) / gain, read.tail<3>() / gain});
  }
  hold_weight();
}

void ArmTraveller::expand(const Reading& reading) {
  const double rate = on_.rig.arm->expansion;
  if (rate == 0) return;
  const double first = experiment_->runs.front().readings.front().covariates.front();
  growth_ = 1 + rate * (reading.covariates.front() - first);
  const SerialArm<double>& cold = on_.rig.arm->arm;
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    arm_.links[i].frame.translation() = growth_ * cold.links[i].frame.translation();
    arm_.links[i].centre = growth_ * cold.links[i].centre;
  }
  arm_.tip.translation() = growth_ * cold.tip.translation();
}

OnLink<double> ArmTraveller::expanded(OnLink<double> at) const {
  at.frame.translation() *= growth_;
  return at;
}

/// The servos know the nominal weight of the arm as it is commanded.
void ArmTraveller::hold_weight() {
  held_.setZero(target_.size());
  const double share = on_.rig.compensated;
  if (share == 0) return;
  const SerialArm<double>& nominal = experiment_->arm->arm;
  const ArmLoads<double> weight =
      arm_loads(nominal, ArmPosture<double>(nominal, commanded(nominal, column(on_.command))), {});
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    held_(joint_[i]) = share * weight.force(next);
    next += yields(nominal.links[i]) ? 7 : 1;
  }
}

ArmLoads<double> ArmTraveller::loads(const ArmPosture<double>& posture) const {
  ArmLoads<double> all = arm_loads(arm_, posture, wrenches_);
  all.force -= held_;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const Eigen::Vector2d& amount = on_.rig.balance[i];
    if (amount.isZero(0)) continue;
    const Eigen::Index k = joint_[i];
    const double c = std::cos(coordinate_(k)), s = std::sin(coordinate_(k));
    all.force(k) += amount.dot(Eigen::Vector2d(c, s));
    all.stiffness(k, k) += amount.dot(Eigen::Vector2d(-s, c));
  }
  return all;
}

void ArmTraveller::balance(const ArmLoads<double>& at, Vector<double>& residual,
                           Matrix<double>& slope) const {
  residual = coordinate_ - target_ - compliance_ * at.force;
  slope = -compliance_ * at.stiffness;
  slope.diagonal().array() += 1;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const double stiffness = on_.rig.stiffness[i];
    if (!yields_by_law(on_.rig, i)) continue;
    const Eigen::Index k = joint_[i];
    const double q = coordinate_(k);
    Torque torque = on_.joint[i].elastic(q, memory_[i]);
    torque += history_torque(step(), i, q, contacts_of(i));
    residual(k) = (torque.value - at.force(k)) / stiffness;
    slope.row(k) = -at.stiffness.row(k) / stiffness;
    slope(k, k) = std::max(slope(k, k) + torque.slope / stiffness, smallest_slope);
  }
  if (on_.rig.coupling != 0) couple(residual, slope);
}

/// A joint that yields feels the deflections of those beside it.
void ArmTraveller::couple(Vector<double>& residual, Matrix<double>& slope) const {
  const auto feels = [&](std::size_t own, std::size_t beside) {
    if (!yields_by_law(on_.rig, own)) return;
    const double share = on_.rig.coupling / on_.rig.stiffness[own];
    residual(joint_[own]) -= share * (coordinate_(joint_[beside]) - on_.joint[beside].rest);
    slope(joint_[own], joint_[beside]) -= share;
  };
  for (std::size_t i = 0; i + 1 < joint_.size(); ++i) feels(i, i + 1), feels(i + 1, i);
}

double ArmTraveller::newton_step() {
  balance(loads(ArmPosture<double>(arm_, coordinate_)), residual_, slope_);
  tangent_.compute(slope_);
  Vector<double> by = tangent_.solve(residual_);
  const double length = by.lpNorm<Eigen::Infinity>();
  if (length > longest_step) by *= longest_step / length;
  coordinate_ -= by;
  return length;
}

bool ArmTraveller::change_contacts(bool all) {
  const auto angle = [&](std::size_t joint) { return coordinate_(joint_[joint]); };
  return settle_contacts(step(), sliders_, all, angle, contact_);
}

/// Joints with play start on the side to which their load pulls them; without load they stay until they are
/// led.
void ArmTraveller::start() {
  coordinate_ = target_;
  const std::vector<double>& play = on_.rig.backlash;
  if (std::all_of(play.begin(), play.end(), [](double b) { return b == 0; })) return;
  const ArmLoads<double> at = loads(ArmPosture<double>(arm_, coordinate_));
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    if (!yields_by_law(on_.rig, i)) continue;
    double& q = coordinate_(joint_[i]);
    if (const double load = at.force(joint_[i]); load != 0)
      q += std::copysign(play[i], load) + load / on_.rig.stiffness[i];
    else
      q = std::clamp(memory_[i].angle, rest_[i] - play[i], rest_[i] + play[i]);
  }
}

bool ArmTraveller::come_to_rest(bool contacts_hold) {
  double last = longest_step;
  for (int i = 0; i < newton_limit; ++i) {
    const double length = newton_step();
    if (!std::isfinite(length)) return false;
    const bool settled = contacts_hold || !change_contacts(i < joint_changes);
    const bool rounding = length < 1e-11 && length >= last;
    if (settled && (rounding || length <= accuracy * (1 + coordinate_.lpNorm<Eigen::Infinity>())))
      return true;
    last = length;
    if (settled && length < 1e-7 && contacts_hold) return newton_step(), true;  // its square is rounding
  }
  return false;
}

void ArmTraveller::yield_at_base() {
  const Eigen::Vector2d& soft = on_.rig.arm->mount_compliance;
  const Pose<double>& still = on_.rig.arm->arm.base;
  const Vector3<double> moment =
      still.linear().transpose() * moment_on_base(arm_, ArmPosture<double>(arm_, coordinate_), wrenches_);
  arm_.base = still * rotation_by(Vector3<double>(soft.x() * moment.x(), soft.y() * moment.y(), 0));
}

bool ArmTraveller::come_to_rest_on_mount(bool contacts_hold) {
  if (!come_to_rest(contacts_hold)) return false;
  // The turn of the mount changes the moment on it by its own size, which is small, and that squared is left.
  for (int i = 0; i < 2 && !on_.rig.arm->mount_compliance.isZero(0); ++i) {
    yield_at_base();
    if (!come_to_rest(contacts_hold)) return false;
  }
  return true;
}

bool ArmTraveller::settle() {
  arm_.base = on_.rig.arm->arm.base;
  start();
  return come_to_rest_on_mount(false);
}

void ArmTraveller::prepare() {
  balance(loads(ArmPosture<double>(arm_, coordinate_)), residual_, slope_);
  tangent_.compute(slope_);
}

bool ArmTraveller::settle_beside(const ArmTraveller& other) {
  arm_.base = on_.rig.arm->arm.base;
  contact_ = other.contact_;
  if (target_.size() != other.target_.size() || !on_.rig.arm->mount_compliance.isZero(0)) {
    coordinate_ = target_;
    for (std::size_t i = 0; i < joint_.size(); ++i)
      coordinate_(joint_[i]) += other.coordinate_(other.joint_[i]) - other.target_(other.joint_[i]);
    return come_to_rest_on_mount(true);
  }
  // In this order, and less what rounding leaves there, an arm that does not differ is the same to the last
  // bit.
  coordinate_ = other.coordinate_ + (target_ - other.target_);
  balance(loads(ArmPosture<double>(arm_, coordinate_)), residual_, slope_);
  coordinate_ -= other.tangent_.solve(residual_ - other.residual_);
  return coordinate_.allFinite();
}

void ArmTraveller::remember() {
  for (std::size_t i = 0; i < joint_.size(); ++i)
    diagnose::remember(on_, interval_, i, coordinate_(joint_[i]), contacts_of(i), memory_[i]);
  moved_ = true;
}

/// What a drive has to give, beyond the friction of its joint.
double ArmTraveller::torque_of_drive(std::size_t joint, double load) const {
  if (!yields_by_law(on_.rig, joint)) return on_.rig.friction[joint] * way_[joint] - load;
  const RigStep now = step();
  return history_torque(now, joint, coordinate_(joint_[joint]), contacts_of(joint)).value - load;
}

/// The tool's weight is that of the last link, at the tip. The tip's own motion changes the moment by its
/// small size, and that is left.
Vector3<double> ArmTraveller::turn_of_tool(const ArmPosture<double>& posture) const {
  const ArmRig& rig = *on_.rig.arm;
  const std::size_t last = arm_.size() - 1;
  const Pose<double>& frame = posture.frame(last);
  constexpr double unweighed = 1e-3;  // kg: a tool whose model has no mass still hangs by its weight
  const double mass = std::max(arm_.links[last].mass, unweighed);
  Vector3<double> moment = (frame.linear() * arm_.tip.translation()).cross(mass * arm_.gravity);
  for (const ArmWrench<double>& one : wrenches_)
    if (one.at.link == last)
      moment += one.moment + (posture.of(one.at).translation() - frame.translation()).cross(one.force);
  return rig.tool_turn(frame.linear().transpose() * moment);
}

/// Where a point of the bench is.
Pose<double> ArmTraveller::of(const OnLink<double>& point, const ArmPosture<double>& posture,
                              const Vector3<double>& tool_turn) const {
  OnLink<double> at = expanded(point);
  if (at.link + 1 == arm_.size()) at.frame = Pose<double>(rotation_by(tool_turn)) * at.frame;
  return posture.of(at);
}

bool ArmTraveller::reads(const Channel& channel) const {
  return std::find(measured_.begin(), measured_.end(), channel) != measured_.end();
}

void ArmTraveller::write(Eigen::Ref<Eigen::ArrayXd> row) const {
  const ArmRig& rig = *on_.rig.arm;
  const ArmPosture<double> posture(arm_, coordinate_);
  const Vector3<double> tipped = turn_of_tool(posture);
  Pose<double> camera = Pose<double>::Identity();
  camera.linear() = rotation_by(on_.rig.place_turn);
  camera.translation() = -camera.linear() * on_.rig.position_offset;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const double q = coordinate_(joint_[i]) - on_.rig.encoder[i].off(on_.command[i]);
    row(Channel(Channel::Name::q, i).column) = on_.rig.angle_read[i].shown(q);
  }
  for (std::size_t p = 0; p < rig.points.size(); ++p) {
    const Pose<double> seen = camera * of(rig.points[p], posture, tipped);
    const Vector3<double> place = (1 + on_.rig.place_scale) * seen.translation();
    for (std::size_t axis = 0; axis < 3; ++axis)
      row(Channel(Channel::Name::place, 3 * p + axis, arm_.size()).column) =
          place(static_cast<Eigen::Index>(axis));
    if (!reads(Channel(Channel::Name::turn, 3 * p, arm_.size()))) continue;
    const Pose<double> told =
        nominal_pose(experiment_->arm->arm, experiment_->arm_bench.points[p].at, on_.command);
    const Vector3<double> turn = rotation_vector<double>(told.linear().transpose() * seen.linear());
    for (std::size_t axis = 0; axis < 3; ++axis)
      row(Channel(Channel::Name::turn, 3 * p + axis, arm_.size()).column) =
          turn(static_cast<Eigen::Index>(axis));
  }
  if (!reads(Channel(Channel::Name::drive, 0, arm_.size()))) return;
  const ArmLoads<double> at = loads(posture);
  for (std::size_t i = 0; i < joint_.size(); ++i)
    row(Channel(Channel::Name::drive, i, arm_.size()).column) =
        on_.rig.torque_read[i].shown(torque_of_drive(i, at.force(joint_[i])));
}

}  // namespace plumbline::diagnose
