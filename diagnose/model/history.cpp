#include "diagnose/model/history.hpp"

#include <cmath>
#include <limits>

#include "diagnose/model/rig_solver.hpp"

namespace plumbline::diagnose {
namespace {

Vector2 turned(const Vector2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// One rig on its way through one run: posture and memory.
struct Traveller {
  Traveller(const Rig& rig, const Run& run) : on(rig, run.rest), memory(run.rest.size()) {}

  /// Commanded to true: the end point (position offset, rail) or the force (load cell, rail).
  [[nodiscard]] Imposed imposed(const Run& run, const Reading& reading) const {
    const Rig& rig = on.rig;
    const Reading& first = run.readings.front();
    if (run.control == ControlMode::displacement) {
      const Vector2 start(first.x, first.y);
      return {run.control,
              start + turned(Vector2(reading.x, reading.y) - start, rig.misalignment) + rig.position_offset};
    }
    const Vector2 read = Vector2(reading.Fx, reading.Fy) - rig.force_bias - rig.force_drift * reading.t;
    return {run.control, turned(read / (1 + rig.force_gain), rig.misalignment)};
  }

  /// True to measured force, in the axes of the rail.
  [[nodiscard]] Vector2 measured_force(double t, double direction) const {
    const Rig& rig = on.rig;
    Vector2 read = (1 + rig.force_gain) * turned(posture.force, -rig.misalignment) + rig.force_bias +
                   rig.force_drift * t;
    read.x() += rig.guide_friction * direction;
    return read;
  }

  [[nodiscard]] TimeStep interval(double dt) const {
    TimeStep result;
    result.relaxed = false;
    if (on.rig.arm_ratio != 0 && dt > 0) {
      const double ratio = dt / on.rig.relaxation;
      result.decay = std::exp(-ratio);
      result.gain = -std::expm1(-ratio) / ratio;
    }
    return result;
  }

  void remember(const Layout& layout, const TimeStep& during) {
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const double q = layout.joint_angle(posture, i);
      const JointMemory last = memory[i];
      memory[i].angle = q;
      if (during.relaxed) continue;
      memory[i].friction = on.joint[i].dry(q, last, posture.contact[i]).value;
      memory[i].arm = on.joint[i].viscous(q, last, during.decay, during.gain).value;
    }
  }

  RunRig on;
  Posture posture;
  std::vector<JointMemory> memory;
};

/// A run of the rig and, beside it, of the rigs whose parameters differ by a small step each.
class RunWalk {
 public:
  RunWalk(const Experiment& experiment, const Run& run, const Layout& layout, const Rig& rig,
          const std::vector<RigVariation>& variations)
      : run_(run),
        nominal_length_(experiment.link_length),
        layout_(layout),
        solver_(layout),
        main_(rig, run) {
    for (const RigVariation& other : variations) beside_.emplace_back(other.rig, run);
    start();
  }

  [[nodiscard]] bool snapped() const { return snapped_; }

  /// Fills the rows of the run; `sensitivity` holds, per varied rig, its difference from the rig.
  bool walk(Trace& trace, std::vector<Trace*>& sensitivity) {
    for (std::size_t r = 0; r < run_.readings.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      if (!imposed_is_known(run_.readings[r])) {
        trace.row(row) = std::numeric_limits<double>::quiet_NaN();
        for (Trace* other : sensitivity) other->row(row) = 0;
        continue;
      }
      if (!move_to(r)) return false;
      write(main_, r, trace);
      for (std::size_t p = 0; p < beside_.size(); ++p) {
        write(beside_[p], r, *sensitivity[p]);
        sensitivity[p]->row(row) -= trace.row(row);
      }
    }
    return true;
  }

 private:
  [[nodiscard]] bool imposed_is_known(const Reading& reading) const {
    return run_.control == ControlMode::displacement ? std::isfinite(reading.x) && std::isfinite(reading.y)
                                                     : std::isfinite(reading.Fx) && std::isfinite(reading.Fy);
  }

  void start() {
    double theta = 0;
    main_.posture.contact.assign(layout_.links, Contact::sticks);
    for (std::size_t j = 0; j < layout_.links; ++j) {
      theta += main_.on.joint[j].rest;
      main_.posture.angle.insert(main_.posture.angle.end(), layout_.nodes_per_link(), theta);
    }
    at_ = {run_.control, Vector2(0, 0)};
    if (run_.control == ControlMode::force || run_.readings.empty()) return;
    at_.value = solver_.end_point(main_.on, main_.posture, main_.memory);
    approach();
  }

  /// A run whose first line is not at the unloaded end point was brought there: the guide has moved already.
  void approach() {
    double theta = 0, unloaded = 0, reach = 0;
    for (std::size_t j = 0; j < layout_.links; ++j) {
      theta += run_.rest[j];
      unloaded += nominal_length_[j] * std::cos(theta);
      reach += nominal_length_[j];
    }
    const double way = run_.readings.front().x - unloaded;
    if (std::abs(way) > 1e-4 * reach) direction_ = way > 0 ? 1 : -1;
  }

  /// The posture that goes on as the last step went, if the load does.
  [[nodiscard]] Posture extrapolated(const Imposed& target) const {
    const Vector2 step = target.value - at_.value;
    Posture guess = main_.posture;
    if (!moved_ || step.dot(last_step_) <= 0.5 * step.norm() * last_step_.norm()) return guess;
    const double share = step.norm() / last_step_.norm();
    for (std::size_t i = 0; i < guess.angle.size(); ++i)
      guess.angle[i] += share * (guess.angle[i] - last_posture_.angle[i]);
    guess.force += share * (guess.force - last_posture_.force);
    return guess;
  }

  bool move_to(std::size_t r) {
    const Reading& reading = run_.readings[r];
    const double dt = moved_ ? reading.t - last_time_ : 0;
    if (moved_ && reading.x != last_x_) direction_ = reading.x > last_x_ ? 1 : -1;
    const auto during = [&](const Traveller& rig) { return moved_ ? rig.interval(dt) : TimeStep{}; };
    const Imposed target = main_.imposed(run_, reading);
    const Posture guess = extrapolated(target);
    last_posture_ = main_.posture;
    if (!solver_.follow(main_.on, at_, target, during(main_), main_.memory, guess, main_.posture))
      return false;
    snapped_ = snapped_ || solver_.snapped();
    if (!beside_.empty()) solver_.settle(main_.on, target, during(main_), main_.memory, main_.posture);
    for (Traveller& other : beside_) {
      other.posture = solver_.neighbour(other.on, other.imposed(run_, reading), during(other), other.memory,
                                        main_.posture);
      other.remember(layout_, during(other));
    }
    main_.remember(layout_, during(main_));
    last_step_ = target.value - at_.value;
    at_ = target;
    last_time_ = reading.t;
    last_x_ = reading.x;
    moved_ = true;
    return true;
  }

  void write(const Traveller& rig, std::size_t r, Trace& trace) {
    const Reading& reading = run_.readings[r];
    auto row = trace.row(static_cast<Eigen::Index>(r));
    Vector2 end(reading.x, reading.y), force(reading.Fx, reading.Fy);
    if (run_.control == ControlMode::displacement) {
      force = rig.measured_force(reading.t, direction_);
    } else {
      end = solver_.end_point(rig.on, rig.posture, rig.memory) - rig.on.rig.position_offset;
      end.x() += rig.on.rig.train_compliance * rig.posture.force.x();
    }
    row(column_x) = end.x();
    row(column_y) = end.y();
    row(column_Fx) = force.x();
    row(column_Fy) = force.y();
    for (std::size_t i = 0; i < layout_.links; ++i)
      row(column_q + static_cast<Eigen::Index>(i)) = layout_.joint_angle(rig.posture, i);
  }

  const Run& run_;
  const std::vector<double>& nominal_length_;
  Layout layout_;
  RigSolver solver_;
  Traveller main_;
  std::vector<Traveller> beside_;
  Posture last_posture_;
  Vector2 last_step_ = Vector2::Zero();
  Imposed at_{ControlMode::displacement, Vector2::Zero()};
  double last_time_ = 0, last_x_ = 0;
  double direction_ = 0;  ///< of the drive along x; 0 until it has moved
  bool moved_ = false, snapped_ = false;
};

}  // namespace

Prediction simulate(const Experiment& experiment, const Rig& rig,
                    const std::vector<RigVariation>& variations) {
  const std::size_t n = experiment.link_length.size();
  Layout layout{n, rig.flexibility > 0, rig.coupling != 0, rig.friction > 0};
  for (const RigVariation& other : variations) {
    layout.coupled = layout.coupled || other.rig.coupling != 0;
    layout.dry = layout.dry || other.rig.friction > 0;
  }
  Prediction result;
  for (const Run& run : experiment.runs) {
    const auto rows = static_cast<Eigen::Index>(run.readings.size());
    const auto columns = column_q + static_cast<Eigen::Index>(n);
    result.runs.push_back(Trace::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN()));
  }
  result.sensitivity.assign(variations.size(), result.runs);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    std::vector<Trace*> beside;
    for (auto& traces : result.sensitivity) beside.push_back(&traces[r]);
    RunWalk walk(experiment, experiment.runs[r], layout, rig, variations);
    if (!walk.walk(result.runs[r], beside)) {
      result.reached = false;
      return result;
    }
    result.snapped = result.snapped || walk.snapped();
    for (std::size_t p = 0; p < variations.size(); ++p) *beside[p] /= variations[p].step;
  }
  return result;
}

}  // namespace plumbline::diagnose
