#include "diagnose/rig/arm_traveller.hpp"

#include <algorithm>
#include <cmath>

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

void put(const Vector<double>& values, const std::vector<Eigen::Index>& places, Vector<double>& to) {
  for (std::size_t i = 0; i < places.size(); ++i) to(places[i]) = values(static_cast<Eigen::Index>(i));
}

bool yields_by_law(const Rig& rig, std::size_t joint) {
  return rig.stiffness[joint] > 0;
}

}  // namespace

ArmTraveller::ArmTraveller(const Experiment& experiment, const Rig& own, const Run& run, std::size_t sliders)
    : experiment_(&experiment),
      run_(&run),
      measured_(run.measured()),
      joints_(own, run),
      arm_(rig().arm->at(growth_, run.rest, own.flexibility)),
      sliders_(sliders),
      contact_(arm_.size() * sliders_, Contact::sticks),
      way_(arm_.size(), 0.0) {
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    joint_.push_back(next);
    next += yields(arm_.links[i]) ? 7 : 1;
  }
  soften();
}

void ArmTraveller::soften() {
  compliance_ = compliance(arm_);
  for (std::size_t i = 0; i < joint_.size(); ++i)
    if (yields_by_law(rig(), i)) compliance_(joint_[i], joint_[i]) = 0;
}

void ArmTraveller::head_for(const Stop& stop, const Passage& passage) {
  const std::vector<double> before = joints_.on().command;
  const Reading& reading = joints_.head_for(stop, passage);
  const std::vector<double>& command = joints_.on().command;
  for (std::size_t i = 0; i < way_.size(); ++i)
    if (!passage.first && command[i] != before[i]) way_[i] = command[i] > before[i] ? 1 : -1;
  grow(reading);
  Vector<double> rest(static_cast<Eigen::Index>(way_.size()));
  for (std::size_t i = 0; i < way_.size(); ++i) rest(static_cast<Eigen::Index>(i)) = law(i).rest;
  target_ = commanded(arm_, rest);
  load(reading);
  hold_weight();
}

void ArmTraveller::load(const Reading& reading) {
  wrenches_.clear();
  load_.setZero();
  if (reading.wrench.empty()) return;
  const Eigen::Map<const Vector6<double>> read(reading.wrench.data());
  const Vector3<double> zero = rig().force_bias + rig().force_drift * reading.t;
  const double gain = 1 + rig().force_gain;
  load_ = (read.head<3>() - zero) / gain;
  wrenches_.push_back({expanded(rig().arm->load), load_, read.tail<3>() / gain});
}

void ArmTraveller::grow(const Reading& reading) {
  const ArmRig& own = *rig().arm;
  if (own.expansion != 0) {
    const double first = experiment_->runs.front().readings.front().covariates.front();
    growth_ = 1 + own.expansion * (reading.covariates.front() - first);
  }
  if (own.expansion == 0 && rig().flexibility == 0) return;
  arm_ = own.at(growth_, joints_.on().command, rig().flexibility);
  soften();
}

OnLink<double> ArmTraveller::expanded(OnLink<double> at) const {
  at.frame.translation() *= growth_;
  return at;
}

/// The servos know the nominal weight of the arm as it is commanded.
void ArmTraveller::hold_weight() {
  held_.setZero(target_.size());
  const double share = rig().compensated;
  if (share == 0) return;
  const SerialArm<double>& nominal = experiment_->arm->arm;
  const Vector<double> weight =
      arm_forces(nominal, ArmPosture<double>(nominal, commanded(nominal, column(joints_.on().command))), {});
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    held_(joint_[i]) = share * weight(next);
    next += yields(nominal.links[i]) ? 7 : 1;
  }
}

void ArmTraveller::stand_at(Vector<double> coordinates) {
  at_ = std::move(coordinates);
  posture_.emplace(arm_, at_);
}

Torque ArmTraveller::balance(std::size_t joint, double coordinate) const {
  const Eigen::Vector2d& amount = rig().balance[joint];
  if (amount.isZero(0)) return {};
  const double c = std::cos(coordinate), s = std::sin(coordinate);
  return {amount.dot(Eigen::Vector2d(c, s)), amount.dot(Eigen::Vector2d(-s, c))};
}

Vector<double> ArmTraveller::forces(const ArmPosture<double>& posture,
                                    const Vector<double>& coordinates) const {
  Vector<double> all = arm_forces(arm_, posture, wrenches_) - held_;
  for (std::size_t i = 0; i < joint_.size(); ++i) all(joint_[i]) += balance(i, coordinates(joint_[i])).value;
  return all;
}

Vector<double> ArmTraveller::residual(const Vector<double>& force) const {
  Vector<double> all = at_ - target_ - compliance_ * force;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    if (!yields_by_law(rig(), i)) continue;
    all(joint_[i]) = (own_torque(i).value - force(joint_[i]) - from_neighbours(i)) / rig().stiffness[i];
  }
  return all;
}

Torque ArmTraveller::own_torque(std::size_t joint) const {
  const double q = at_(joint_[joint]);
  return law(joint).elastic(q, joints_.memory()[joint]) += torque_beside_spring(joint, q);
}

Torque ArmTraveller::torque_beside_spring(std::size_t joint, double q) const {
  const RigStep step = joints_.step();
  Torque torque = history_torque(step, joint, q, contacts_of(joint));
  if (law(joint).stated.empty()) return torque;
  const Torque motion = direction_of_motion(step, joint, q, contacts_of(joint));
  const StatedTorque::Place place = stated_place(step, joint, q, load_);
  for (const StatedTorque& one : law(joint).stated)
    torque += {one.value(place, motion.value), one.slope(place, motion)};
  return torque;
}

double ArmTraveller::from_neighbours(std::size_t joint) const {
  double deflections = 0;
  for (const std::size_t i : {joint - 1, joint + 1})  // before the first one there is none, either
    if (rig().coupling != 0 && i < joint_.size()) deflections += at_(joint_[i]) - law(i).rest;
  return rig().coupling * deflections;
}

Matrix<double> ArmTraveller::tangent(const Matrix<double>& stiffness) const {
  Matrix<double> slope(stiffness.rows(), stiffness.cols());
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const Eigen::Index k = joint_[i];
    slope.row(k) = -compliance_(k, k) * stiffness.row(k);
    if (yields(arm_.links[i]))
      slope.middleRows<6>(k + 1).noalias() =
          -compliance_.block<6, 6>(k + 1, k + 1) * stiffness.middleRows<6>(k + 1);
  }
  slope.diagonal().array() += 1;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    if (!yields_by_law(rig(), i)) continue;
    const Eigen::Index k = joint_[i];
    slope.row(k) = -stiffness.row(k) / rig().stiffness[i];
    slope(k, k) = std::max(slope(k, k) + own_torque(i).slope / rig().stiffness[i], smallest_slope);
    for (const std::size_t beside : {i - 1, i + 1})
      if (beside < joint_.size()) slope(k, joint_[beside]) -= rig().coupling / rig().stiffness[i];
  }
  return slope;
}

double ArmTraveller::newton_step() {
  stand_at(coordinate_);
  ArmLoads<double> loads = arm_loads(arm_, *posture_, wrenches_);
  loads.force -= held_;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const Torque by_springs = balance(i, at_(joint_[i]));
    loads.force(joint_[i]) += by_springs.value;
    loads.stiffness(joint_[i], joint_[i]) += by_springs.slope;
  }
  residual_ = residual(loads.force);
  tangent_.compute(tangent(loads.stiffness));
  Vector<double> by = tangent_.solve(residual_);
  const double length = by.lpNorm<Eigen::Infinity>();
  if (length > longest_step) by *= longest_step / length;
  coordinate_ -= by;
  return length;
}

bool ArmTraveller::change_contacts(bool all) {
  const auto angle = [&](std::size_t joint) { return coordinate_(joint_[joint]); };
  return settle_contacts(joints_.step(), sliders_, all, angle, contact_);
}

/// Joints with play start on the side to which their load pulls them; without load they stay until they are
/// led.
void ArmTraveller::start() {
  coordinate_ = target_;
  const std::vector<double>& play = rig().backlash;
  if (std::all_of(play.begin(), play.end(), [](double b) { return b == 0; })) return;
  const Vector<double> force = forces(ArmPosture<double>(arm_, coordinate_), coordinate_);
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    if (!yields_by_law(rig(), i)) continue;
    double& q = coordinate_(joint_[i]);
    if (const double load = force(joint_[i]); load != 0)
      q += std::copysign(play[i], load) + load / rig().stiffness[i];
    else
      q = std::clamp(joints_.memory()[i].angle, law(i).rest - play[i], law(i).rest + play[i]);
  }
}

bool ArmTraveller::come_to_rest(bool contacts_hold) {
  double last = longest_step;
  for (int i = 0; i < newton_limit; ++i) {
    const double length = newton_step();
    if (!std::isfinite(length)) return false;
    const bool settled = contacts_hold || !change_contacts(i < joint_changes);
    const bool rounding = length < 1e-11 && length >= last;
    const double left = length * std::min(1.0, length / last);  // as steps shrink, or faster
    if (settled && (rounding || left <= accuracy * (1 + coordinate_.lpNorm<Eigen::Infinity>()))) return true;
    last = length;
  }
  return false;
}

void ArmTraveller::yield_at_base() {
  const Eigen::Vector2d& soft = rig().arm->mount_compliance;
  const Pose<double>& still = rig().arm->arm.base;
  const Vector3<double> moment = still.linear().transpose() * moment_on_base(arm_, *posture_, wrenches_);
  arm_.base = still * rotation_by(Vector3<double>(soft.x() * moment.x(), soft.y() * moment.y(), 0));
}

bool ArmTraveller::come_to_rest_on_mount(bool contacts_hold) {
  if (!come_to_rest(contacts_hold)) return false;
  // The turn of the mount changes the moment on it by its own size, which is small, and that squared is left.
  for (int i = 0; i < 2 && !rig().arm->mount_compliance.isZero(0); ++i) {
    yield_at_base();
    if (!come_to_rest(contacts_hold)) return false;
  }
  return true;
}

bool ArmTraveller::settle() {
  arm_.base = rig().arm->arm.base;
  start();
  return come_to_rest_on_mount(false);
}

std::vector<Eigen::Index> ArmTraveller::shared_with(const ArmTraveller& other) const {
  std::vector<Eigen::Index> shared;
  for (std::size_t i = 0; i < joint_.size(); ++i)
    for (Eigen::Index k = 0; k < (yields(arm_.links[i]) && yields(other.arm_.links[i]) ? 7 : 1); ++k)
      shared.push_back(joint_[i] + k);
  return shared;
}

bool ArmTraveller::settle_beside(const ArmTraveller& other) {
  arm_.base = rig().arm->arm.base;
  contact_ = other.contact_;
  const std::vector<Eigen::Index> shared = shared_with(other);
  if (shared.size() < static_cast<std::size_t>(other.target_.size()) ||
      !rig().arm->mount_compliance.isZero(0)) {
    coordinate_ = target_;
    for (std::size_t i = 0; i < joint_.size(); ++i)
      coordinate_(joint_[i]) += other.coordinate_(other.joint_[i]) - other.target_(other.joint_[i]);
    return come_to_rest_on_mount(true);
  }
  const Vector<double> led = target_(shared) - other.target_;
  if (led.isZero(0) && arm_ == other.arm_) {
    at_ = other.at_, posture_ = other.posture_;
  } else {
    Vector<double> at = target_;
    put(other.at_ + led, shared, at);
    stand_at(at);
  }
  if (target_.size() > other.target_.size()) {  // what yields here alone bends under the loads of the other
    Vector<double> at = at_ - residual(forces(*posture_, at_));
    put(at_(shared), shared, at);
    stand_at(at);
  }
  const Vector<double> left = residual(forces(*posture_, at_));
  coordinate_ = at_ - left;
  // In this order, less what rounding leaves, an arm that does not differ is the same to the last bit.
  put(other.coordinate_ + led - other.tangent_.solve(left(shared) - other.residual_), shared, coordinate_);
  return coordinate_.allFinite();
}

void ArmTraveller::remember() {
  joints_.remember([&](std::size_t i) { return joint_angle(i); },
                   [&](std::size_t i) { return contacts_of(i); });
}

/// What a drive has to give, beyond the friction of its joint.
double ArmTraveller::torque_of_drive(std::size_t joint, double load) const {
  if (!yields_by_law(rig(), joint)) return rig().friction[joint] * way_[joint] - load;
  return torque_beside_spring(joint, joint_angle(joint)).value - load;
}

Pose<double> ArmTraveller::moved(Pose<double> frame, std::size_t movers) const {
  Vector3<double> shift = Vector3<double>::Zero(), turn = shift;
  for (std::size_t k = 0; k < movers; ++k) {
    const ArmFreedom<double>& freedom = posture_->freedoms()[k];
    const double by = coordinate_(static_cast<Eigen::Index>(k)) - at_(static_cast<Eigen::Index>(k));
    shift += by * freedom.velocity(frame.translation());
    turn += by * freedom.turning();
  }
  frame.translation() += shift;
  frame.linear() = rotation_by(turn) * frame.linear();
  return frame;
}

/// The tool's weight is that of the last link, at the tip. The tip's own motion changes the moment by its
/// small size, and that is left.
Vector3<double> ArmTraveller::turn_of_tool() const {
  const ArmRig& own = *rig().arm;
  if (own.tool_compliance == 0 && own.tool_play == 0 && own.tool_hinge.isZero(0))
    return Vector3<double>::Zero();
  const std::size_t last = arm_.size() - 1, movers = posture_->moved_by(last);
  const Pose<double> frame = moved(posture_->frame(last), movers - (yields(arm_.links[last]) ? 6 : 0));
  constexpr double unweighed = 1e-3;  // kg: a tool whose model has no mass still hangs by its weight
  const double mass = std::max(own.arm.links[last].mass, unweighed);
  Vector3<double> moment = (frame.linear() * arm_.tip.translation()).cross(mass * arm_.gravity);
  for (const ArmWrench<double>& one : wrenches_)
    if (one.at.link == last)
      moment += one.moment +
                (moved(posture_->of(one.at), movers).translation() - frame.translation()).cross(one.force);
  return own.tool_turn(frame.linear().transpose() * moment);
}

/// Where a point of the bench is.
Pose<double> ArmTraveller::of(const OnLink<double>& point, const Vector3<double>& tool_turn) const {
  OnLink<double> at = expanded(point);
  if (at.link + 1 == arm_.size()) at.frame = Pose<double>(rotation_by(tool_turn)) * at.frame;
  return moved(posture_->of(at), posture_->moved_by(at.link));
}

bool ArmTraveller::reads(const Channel& channel) const {
  return std::find(measured_.begin(), measured_.end(), channel) != measured_.end();
}

void ArmTraveller::write(Eigen::Ref<Eigen::ArrayXd> row, const std::vector<Eigen::Matrix3d>& told) const {
  const ArmRig& own = *rig().arm;
  const Vector3<double> tipped = turn_of_tool();
  Pose<double> camera = Pose<double>::Identity();
  camera.linear() = rotation_by(rig().place_turn);
  camera.translation() = -camera.linear() * rig().frame_at(joints_.interval().end);
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    row(Channel(Channel::Name::q, i).column) =
        coordinate_(joint_[i]) - rig().encoder[i].off(joints_.on().command[i]);
  }
  row(column_Fx) = load_.x();
  row(column_Fy) = load_.y();
  std::vector<Pose<double>> seen;
  for (std::size_t p = 0; p < own.points.size(); ++p) {
    seen.push_back(camera * of(own.points[p], tipped));
    row.segment<3>(Channel(Channel::Name::place, 3 * p, arm_.size()).column) =
        rig().seen(seen[p].translation()).array();
    if (const Channel turn(Channel::Name::turn, 3 * p, arm_.size()); reads(turn))
      row.segment<3>(turn.column) = rotation_vector<double>(told[p].transpose() * seen[p].linear()).array();
  }
  own.read_sensors(seen, row);
  if (!reads(Channel(Channel::Name::drive, 0, arm_.size()))) return;
  const Vector<double> force = forces(ArmPosture<double>(arm_, coordinate_), coordinate_);
  for (std::size_t i = 0; i < joint_.size(); ++i)
    row(Channel(Channel::Name::drive, i, arm_.size()).column) = torque_of_drive(i, force(joint_[i]));
}

}  // namespace plumbline::diagnose
