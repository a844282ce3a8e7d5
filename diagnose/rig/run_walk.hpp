#pragma once
/// \file
/// The walk of a planar rig along one run, from reading to reading, with its variations beside it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "diagnose/rig/history.hpp"
#include "diagnose/rig/load_cell.hpp"
#include "diagnose/rig/rig_solver.hpp"
#include "diagnose/rig/substeps.hpp"
#include "diagnose/rig/traveller.hpp"

namespace plumbline::diagnose {

/// The last angle of a joint that differed by more than JointLaw::turning from the one before, and the
/// direction of that turn, 1 or -1; 0 until the joint has left rest.
struct Turning {
  double place, way;
};

/// One run of a rig and of its variations.
template <int Bandwidth>
class RunWalk {
 public:
  RunWalk(const Experiment& experiment, const Run& run, const Layout& layout, const Rig& rig,
          const std::vector<Rig>& variations)
      : run_(run),
        measured_(run.measured()),
        experiment_(experiment),
        before_(run.before_first()),
        layout_(layout),
        parts_(substeps(run, layout.sliders, rig)),
        solver_(layout, std::accumulate(parts_.begin(), parts_.end(), std::size_t{0})),
        main_(experiment, rig, run) {
    beside_.reserve(variations.size());
    for (const Rig& other : variations) beside_.emplace_back(experiment, other, run);
    start();
  }

  [[nodiscard]] bool snapped() const { return snapped_; }

  /// Fills the rows of the run; `sensitivity` holds the difference of each varied rig from the rig.
  bool walk(Trace& trace, const std::vector<Trace*>& sensitivity) {
    if (before_ && !go_to({*before_})) return false;
    if (before_) last_ = &*before_;
    for (std::size_t r = 0; r < run_.readings.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      if (!imposed_is_known(run_.readings[r])) {
        trace.row(row) = std::numeric_limits<double>::quiet_NaN();
        for (Trace* other : sensitivity) other->row(row) = 0;
        continue;
      }
      if (!move_to(r)) return false;
      write(main_, r, trace);
      if (!main_.on.rig.stated_corrections.empty() && !trace.row(row).isFinite().all()) return false;
      for (std::size_t p = 0; p < beside_.size(); ++p) {
        write(beside_[p], r, *sensitivity[p]);
        sensitivity[p]->row(row) -= trace.row(row);
      }
    }
    return true;
  }

 private:
  [[nodiscard]] bool imposed_is_known(const Reading& reading) const {
    return run_.imposed_at(reading).allFinite();
  }

  void start() {
    double theta = 0;
    main_.posture.contact.assign(layout_.links * layout_.sliders, Contact::sticks);
    main_.posture.angle.resize(static_cast<Eigen::Index>(layout_.nodes()));
    for (std::size_t j = 0; j < layout_.links; ++j) {
      theta += main_.on.joint[j].rest;
      turning_.push_back({main_.on.joint[j].rest, 0});
      const auto nodes = static_cast<Eigen::Index>(layout_.nodes_per_link());
      main_.posture.angle.segment(static_cast<Eigen::Index>(layout_.first(j)), nodes).setConstant(theta);
    }
    at_ = {run_.control, Vector2(0, 0)};
    if (run_.readings.empty()) return;
    if (run_.holds_end_point()) at_.value = solver_.end_point(main_.on, {}, main_.posture);
    approach();
  }

  /// Sets the direction of motion of a run that does not start at the unloaded chain.
  void approach() {
    if (run_.holds_end_point()) {
      head(run_.imposed_at(run_.readings.front()) - unloaded_end(experiment_, run_.rest),
           1e-4 * reach(experiment_.link_length).largest);
    } else {
      head(run_.command(run_.readings.front()), 0);
    }
  }

  /// Whether the chain is on the branch that was not observed: at least a tenth of the distance from the
  /// middle between the branches. A chain that friction holds in between is on neither.
  [[nodiscard]] bool is_on_other_branch(std::size_t r) const {
    constexpr double clearly = 0.1;
    const auto row = static_cast<Eigen::Index>(r);
    double along = 0, whole = 0;
    for (std::size_t i = 0; i < layout_.links; ++i) {
      const auto joint = static_cast<Eigen::Index>(i);
      const double there = run_.branch->angles(row, joint), other = run_.branch->other_angles(row, joint);
      const double way = (other - there) / 2;
      along += (layout_.joint_angle(main_.posture.angle, i) - (there + other) / 2) * way;
      whole += way * way;
    }
    return along > clearly * whole;
  }

  /// Moves the chain to the observed branch where it arrived on the other one or nowhere: a softer chain
  /// bifurcates before the branches of the nominal model differ.
  /// \returns whether it is on the observed branch; if not, the posture is unchanged
  bool crosses_over(const RigStep& step, const Imposed& target, std::size_t r, bool arrived) {
    if (arrived && !(run_.branch->differs[r] && is_on_other_branch(r))) return false;
    const Posture stays = main_.posture;
    main_.posture = last_posture_;
    const std::size_t apart = std::max(r, run_.branch->first());
    const auto row = static_cast<Eigen::Index>(apart);
    double theta = 0;
    for (std::size_t j = 0; j < layout_.links; ++j) {
      theta += run_.branch->angles(row, static_cast<Eigen::Index>(j));
      const auto nodes = static_cast<Eigen::Index>(layout_.nodes_per_link());
      main_.posture.angle.segment(static_cast<Eigen::Index>(layout_.first(j)), nodes).setConstant(theta);
    }
    main_.posture.force = {run_.branch->force(row, 0), run_.branch->force(row, 1)};
    guess_ = main_.posture;
    if (solver_.follow(step, target, target, guess_, main_.posture) && !is_on_other_branch(apart))
      return true;
    main_.posture = stays;
    return false;
  }

  /// Extrapolates the last step as a first guess, where the command keeps its direction.
  void extrapolate(const Imposed& target) {
    guess_ = main_.posture;
    const Vector2 step = target.value - at_.value;
    if (!moved_ || step.dot(last_step_) <= 0.5 * step.norm() * last_step_.norm()) return;
    const double share = step.norm() / last_step_.norm();
    guess_.angle += share * (guess_.angle - last_posture_.angle);
    guess_.force.x += share * (guess_.force.x - last_posture_.force.x);
    guess_.force.y += share * (guess_.force.y - last_posture_.force.y);
  }

  /// Moves to a reading in substeps; where the rig cannot follow one of them, in a single step.
  bool move_to(std::size_t r) {
    const Reading& reading = run_.readings[r];
    if (last_) head(run_.command(reading) - run_.command(*last_), 0);
    const std::size_t count = last_ ? parts_[r] : 1;
    for (std::size_t part = 1; part < count; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(count);
      if (!go_to({between(*last_, reading, share), last_number_, r, share})) break;
    }
    if (!go_to({reading, last_number_, r})) return false;
    notice_turns();
    last_ = &reading;
    last_number_ = r;
    return true;
  }

  /// Records the direction of the command.
  /// \param still  largest change that counts as standing still
  void head(const Vector2& way, double still) {
    for (const Eigen::Index axis : {0, 1})
      if (std::abs(way(axis)) > still) direction_(axis) = way(axis) > 0 ? 1 : -1;
  }

  void notice_turns() {
    for (std::size_t i = 0; i < turning_.size(); ++i) {
      const double q = layout_.joint_angle(main_.posture.angle, i), turn = q - turning_[i].place;
      if (std::abs(turn) > JointLaw::turning) turning_[i] = {q, turn > 0 ? 1.0 : -1.0};
    }
  }

  bool go_to(const Stop& stop) {
    const Reading& reading = stop.reading;
    const double dt = moved_ ? reading.t - last_time_ : 0;
    const double size = run_.imposed_at(reading).norm();
    if (size != last_size_) growing_ = size > last_size_ ? 1 : -1;
    last_size_ = size;
    const Reading& led = main_.command.at(stop);
    const Imposed& target = main_.impose(run_, led, growing_);
    const Vector2 command = run_.command(reading);
    const double way = way_to(reading, target, command), share = last_way_ > 0 ? way / last_way_ : 0;
    const auto step_of = [&](Traveller& rig, const Reading& its) {
      if (!its.rest.empty()) rig.turn_to(its.rest);
      rig.expect(share, dt);
      RigStep step{rig.on, moved_ ? time_step(rig.on, dt) : TimeStep{}, rig.memory};
      step.interval.end = reading.t;
      step.interval.covariates = its.covariates;
      return step;
    };
    const RigStep step = step_of(main_, led);
    extrapolate(target);
    last_posture_ = main_.posture;
    const bool arrives = solver_.follow(step, at_, target, guess_, main_.posture);
    const bool crosses =
        stop.to && stop.share == 1 && run_.branch && crosses_over(step, target, *stop.to, arrives);
    if (!arrives && !crosses) return false;
    snapped_ = snapped_ || (!crosses && solver_.snapped());
    if (!beside_.empty()) solver_.prepare(step, target, main_.posture);
    for (Traveller& other : beside_) {
      const Reading& its_own = other.command.at(stop);
      const RigStep its = step_of(other, its_own);
      solver_.neighbour(its, other.impose(run_, its_own, growing_), main_.posture, other.posture);
      other.remember(layout_, its.interval);
    }
    main_.remember(layout_, step.interval);
    last_step_ = target.value - at_.value;
    last_way_ = way;
    at_ = target;
    commanded_ = command;
    last_rest_ = reading.rest;
    last_time_ = reading.t;
    moved_ = true;
    return true;
  }

  /// How far what is commanded goes in a step: the end, the joints, or either with loads beside it.
  [[nodiscard]] double way_to(const Reading& reading, const Imposed& target, const Vector2& command) const {
    if (!run_.loads.empty()) return (command - commanded_).norm();
    if (reading.rest.empty()) return (target.value - at_.value).norm();
    if (last_rest_.empty()) return 0;
    const auto joints = static_cast<Eigen::Index>(reading.rest.size());
    return (Eigen::Map<const Eigen::VectorXd>(reading.rest.data(), joints) -
            Eigen::Map<const Eigen::VectorXd>(last_rest_.data(), joints))
        .norm();
  }

  void write(Traveller& rig, std::size_t r, Trace& trace) {
    const Reading& reading = run_.readings[r];
    auto row = trace.row(static_cast<Eigen::Index>(r));
    Vector2 end(reading[column_x], reading[column_y]), force(reading[column_Fx], reading[column_Fy]);
    if (run_.holds_end_point()) {
      force = rig.felt_force(reading.t, direction_.x());
    } else {
      const Rig& own = rig.on.rig;
      Vector3<double> place = -own.frame_at(reading.t);
      place.head<2>() += solver_.end_point(rig.on, rig.imposed.loads, rig.posture);
      end = own.seen(Eigen::AngleAxisd(own.place_turn.z(), Vector3<double>::UnitZ()) * place).head<2>();
    }
    row(column_x) = end.x();
    row(column_y) = end.y();
    row(column_Fx) = force.x();
    row(column_Fy) = force.y();
    const Vector2 second = rig.load_on_second(run_);
    row(column_Fx_2) = second.x();
    row(column_Fy_2) = second.y();
    double tilt = 0;
    for (std::size_t i = 0; i < layout_.links; ++i) {
      const double q = layout_.joint_angle(rig.posture.angle, i);
      row(Channel(Channel::Name::q, i).column) = q;
      row(Channel(Channel::Name::tilt, i, layout_.links).column) = tilt += q;
    }
    correct(rig.on, rig.command.at({reading, std::nullopt, r}), row);
  }

  /// Adds the user's corrections to the measured channels.
  template <class Row>
  void correct(const RunRig& on, const Reading& reading, Row& row) const {
    if (on.rig.stated_corrections.empty()) return;
    Eigen::ArrayXd added = Eigen::ArrayXd::Zero(row.size());
    for (const StatedCorrection& one : on.rig.stated_corrections) {
      for (const Channel& channel : measured_) {
        if (!one.applies_to(channel)) continue;
        const Moment moment{reading.t, run_.number, direction_of(channel), on.joint[channel.joint].rest,
                            reading.covariates};
        added(channel.column) += one.value(reading_values(row.transpose(), moment, channel));
      }
    }
    row += added.transpose();
  }

  /// Direction of motion for a channel, 1 or -1; 1 before the first motion. Varied rigs share it, for a
  /// reversal at another reading would turn a jump into a slope.
  [[nodiscard]] double direction_of(const Channel& channel) const {
    const bool along_y = channel.kind().along_y;
    const double way =
        channel.name == Channel::Name::q ? turning_[channel.joint].way : direction_(along_y ? 1 : 0);
    return way < 0 ? -1 : 1;
  }

  const Run& run_;
  std::vector<Channel> measured_;
  const Experiment& experiment_;
  std::optional<Reading> before_;
  Layout layout_;
  std::vector<std::size_t> parts_;  ///< number of substeps to each reading
  RigSolver<Bandwidth> solver_;
  Traveller main_;
  std::vector<Traveller> beside_;
  Posture last_posture_, guess_;
  Vector2 last_step_ = Vector2::Zero(), commanded_ = Vector2::Zero();
  double last_way_ = 0;            ///< length of the last step of the command
  std::vector<double> last_rest_;  ///< joint angles that it commanded
  Imposed at_{Control::end_point, Vector2::Zero()};
  const Reading* last_ = nullptr;           ///< with a known command
  std::optional<std::size_t> last_number_;  ///< of it; none before the first
  double last_time_ = 0;
  double last_size_ = 0, growing_ = 1;   ///< of the imposed force: its size, and whether it grows (1, -1)
  Vector2 direction_ = Vector2::Zero();  ///< of the command along x and y; 0 until it has moved
  std::vector<Turning> turning_;         ///< of each joint
  bool moved_ = false, snapped_ = false;
};

}  // namespace plumbline::diagnose
