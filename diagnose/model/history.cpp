#include "diagnose/model/history.hpp"

#include <cmath>
#include <limits>
#include <plumbline/chain/kinematics.hpp>

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
    if (run.holds_end_point()) {
      const Vector2 start = run.command(first);
      return {run.control,
              start + turned(run.command(reading) - start, rig.misalignment) + rig.position_offset};
    }
    const Vector2 read = run.command(reading) - rig.force_bias - rig.force_drift * reading.t;
    return {run.control, turned(read / (1 + rig.force_gain), rig.misalignment)};
  }

  /// True to measured force, in the axes of the rail.
  [[nodiscard]] Vector2 measured_force(double t, double direction) const {
    const Rig& rig = on.rig;
    const Vector2 force(posture.force.x, posture.force.y);
    Vector2 read =
        (1 + rig.force_gain) * turned(force, -rig.misalignment) + rig.force_bias + rig.force_drift * t;
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
      const double q = layout.joint_angle(posture.angle, i);
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
template <int Bandwidth>
class RunWalk {
 public:
  RunWalk(const Experiment& experiment, const Run& run, const Layout& layout, const Rig& rig,
          const std::vector<RigVariation>& variations)
      : run_(run), experiment_(experiment), layout_(layout), solver_(layout), main_(rig, run) {
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
    return run_.command(reading).allFinite();
  }

  void start() {
    double theta = 0;
    main_.posture.contact.assign(layout_.links, Contact::sticks);
    main_.posture.angle.resize(static_cast<Eigen::Index>(layout_.nodes()));
    for (std::size_t j = 0; j < layout_.links; ++j) {
      theta += main_.on.joint[j].rest;
      const auto nodes = static_cast<Eigen::Index>(layout_.nodes_per_link());
      main_.posture.angle.segment(static_cast<Eigen::Index>(layout_.first(j)), nodes).setConstant(theta);
    }
    at_ = {run_.control, Vector2(0, 0)};
    if (!run_.holds_end_point() || run_.readings.empty()) return;
    at_.value = solver_.end_point(main_.on, main_.posture);
    approach();
  }

  /// A run whose first line is not at the unloaded end point was brought there: the guide has moved already.
  void approach() {
    const double way = run_.readings.front().x - unloaded_end(experiment_, run_.rest).x();
    if (std::abs(way) > 1e-4 * reach(experiment_.link_length).largest) direction_ = way > 0 ? 1 : -1;
  }

  /// Looks first where the last step leads if it goes on as it went, if the load does.
  void extrapolate(const Imposed& target) {
    guess_ = main_.posture;
    const Vector2 step = target.value - at_.value;
    if (!moved_ || step.dot(last_step_) <= 0.5 * step.norm() * last_step_.norm()) return;
    const double share = step.norm() / last_step_.norm();
    guess_.angle += share * (guess_.angle - last_posture_.angle);
    guess_.force.x += share * (guess_.force.x - last_posture_.force.x);
    guess_.force.y += share * (guess_.force.y - last_posture_.force.y);
  }

  bool move_to(std::size_t r) {
    const Reading& reading = run_.readings[r];
    const double dt = moved_ ? reading.t - last_time_ : 0;
    if (moved_ && reading.x != last_x_) direction_ = reading.x > last_x_ ? 1 : -1;
    const auto step_of = [&](const Traveller& rig) {
      return RigStep{rig.on, moved_ ? rig.interval(dt) : TimeStep{}, rig.memory};
    };
    const RigStep step = step_of(main_);
    const Imposed target = main_.imposed(run_, reading);
    extrapolate(target);
    last_posture_ = main_.posture;
    if (!solver_.follow(step, at_, target, guess_, main_.posture)) return false;
    snapped_ = snapped_ || solver_.snapped();
    if (!beside_.empty()) solver_.prepare(step, target, main_.posture);
    for (Traveller& other : beside_) {
      const RigStep its = step_of(other);
      solver_.neighbour(its, other.imposed(run_, reading), main_.posture, other.posture);
      other.remember(layout_, its.interval);
    }
    main_.remember(layout_, step.interval);
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
    if (run_.holds_end_point()) {
      force = rig.measured_force(reading.t, direction_);
    } else {
      end = solver_.end_point(rig.on, rig.posture) - rig.on.rig.position_offset;
    }
    row(column_x) = end.x();
    row(column_y) = end.y();
    row(column_Fx) = force.x();
    row(column_Fy) = force.y();
    for (std::size_t i = 0; i < layout_.links; ++i)
      row(column_q + static_cast<Eigen::Index>(i)) = layout_.joint_angle(rig.posture.angle, i);
  }

  const Run& run_;
  const Experiment& experiment_;
  Layout layout_;
  RigSolver<Bandwidth> solver_;
  Traveller main_;
  std::vector<Traveller> beside_;
  Posture last_posture_, guess_;
  Vector2 last_step_ = Vector2::Zero();
  Imposed at_{Control::end_point, Vector2::Zero()};
  double last_time_ = 0, last_x_ = 0;
  double direction_ = 0;  ///< of the drive along x; 0 until it has moved
  bool moved_ = false, snapped_ = false;
};

bool walk(const Experiment& experiment, const Run& run, const Layout& layout, const Rig& rig,
          const std::vector<RigVariation>& variations, Trace& trace, std::vector<Trace*>& sensitivity,
          bool& snapped) {
  const auto with = [&]<int Bandwidth>() {
    RunWalk<Bandwidth> one(experiment, run, layout, rig, variations);
    const bool reached = one.walk(trace, sensitivity);
    snapped = snapped || (reached && one.snapped());
    return reached;
  };
  switch (layout.bandwidth()) {
    case 1:
      return with.template operator()<1>();
    case 2:
      return with.template operator()<2>();
    default:
      return with.template operator()<4>();
  }
}

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
    if (!walk(experiment, experiment.runs[r], layout, rig, variations, result.runs[r], beside,
              result.snapped)) {
      result.reached = false;
      return result;
    }
    for (std::size_t p = 0; p < variations.size(); ++p) *beside[p] /= variations[p].step;
  }
  return result;
}

}  // namespace plumbline::diagnose
