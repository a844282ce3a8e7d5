#pragma once
/// \file
/// The walk of a rig along one run, from reading to reading, with its variations beside it.

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "diagnose/rig/history.hpp"
#include "diagnose/rig/joint_states.hpp"

namespace plumbline::diagnose {

/// \tparam Statics  how rigs come to rest, and what is read there: PlanarStatics or SpatialStatics
template <class Statics>
class Walk {
 public:
  Walk(const Experiment& experiment, const Run& run, Statics& statics)
      : run_(run), measured_(run.measured()), before_(run.before_first()), statics_(statics) {
    for (const JointLaw& law : statics.joints(0).on().joint) turning_.push_back({law.rest, 0});
    if (!run.readings.empty()) approach(experiment, run.readings.front());
  }

  /// Fills the rows of the run; `beside` holds the difference of each varied rig from the rig.
  /// \returns false where the rig cannot follow
  bool walk(Trace& trace, const std::vector<Trace*>& beside) {
    if (before_) {
      if (!go_to({*before_})) return false;
      last_ = &*before_;
    }
    Eigen::ArrayXd own = Eigen::ArrayXd::Constant(trace.cols(), std::numeric_limits<double>::quiet_NaN()),
                   other = own;
    for (std::size_t r = 0; r < run_.readings.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      if (!statics_.is_commanded(run_.readings[r])) {
        trace.row(row) = std::numeric_limits<double>::quiet_NaN();
        for (Trace* one : beside) one->row(row) = 0;
        continue;
      }
      if (!move_to(r)) return false;
      if (!write(0, r, own)) return false;
      trace.row(row) = own.transpose();
      for (std::size_t p = 0; p < beside.size(); ++p) {
        write(1 + p, r, other);
        beside[p]->row(row) = (other - own).transpose();
      }
      statics_.remember();
    }
    return true;
  }

 private:
  /// The last angle of a joint that differed by more than JointLaw::turning from the one before, and the
  /// direction of that turn, 1 or -1; 0 until the joint has left rest.
  struct Turning {
    double place, way;
  };

  /// Sets the direction of motion of a run that does not start at the unloaded rig.
  void approach(const Experiment& experiment, const Reading& first) {
    if (!run_.holds_end_point()) return head(run_.command(first), 0);
    commanded_ = unloaded_end(experiment, run_.rest);
    head(run_.imposed_at(first) - commanded_, 1e-4 * reach(experiment.link_length).largest);
  }

  /// Moves to a reading in steps; where the rig cannot follow one of them, in a single step.
  bool move_to(std::size_t r) {
    const Reading& reading = run_.readings[r];
    if (last_) head(run_.command(reading) - run_.command(*last_), 0);
    const std::size_t count = last_ ? statics_.parts()[r] : 1;
    for (std::size_t part = 1; part < count; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(count);
      const Reading here = between(*last_, reading, share);
      if (!go_to({here, last_number_, r, share})) break;
    }
    if (!arrive({reading, last_number_, r})) return false;
    notice_turns();
    last_ = &reading;
    last_number_ = r;
    return true;
  }

  bool go_to(const Stop& stop) {
    if (!arrive(stop)) return false;
    statics_.remember();
    return true;
  }

  bool arrive(const Stop& stop) {
    const Reading& reading = stop.reading;
    const Vector2 command = run_.command(reading);
    const double way = way_to(reading, command);
    const double dt = moved_ ? reading.t - last_time_ : 0, share = last_way_ > 0 ? way / last_way_ : 0;
    if (!statics_.arrive(stop, {!moved_, dt, share})) return false;
    last_way_ = way;
    commanded_ = command;
    last_rest_ = reading.rest;
    last_time_ = reading.t;
    moved_ = true;
    return true;
  }

  /// How far what is commanded goes in a step: the end, the joints, or either with loads beside it.
  [[nodiscard]] double way_to(const Reading& reading, const Vector2& command) const {
    if (reading.rest.empty() || !run_.loads.empty()) return (command - commanded_).norm();
    double square = 0;
    for (std::size_t i = 0; i < last_rest_.size(); ++i)
      square += std::pow(reading.rest[i] - last_rest_[i], 2);
    return std::sqrt(square);
  }

  /// Records the direction of the command.
  /// \param still  largest change that counts as standing still
  void head(const Vector2& way, double still) {
    for (const Eigen::Index axis : {0, 1})
      if (std::abs(way(axis)) > still) direction_(axis) = way(axis) > 0 ? 1 : -1;
  }

  void notice_turns() {
    for (std::size_t i = 0; i < turning_.size(); ++i) {
      const double q = statics_.joint_angle(i), turn = q - turning_[i].place;
      if (std::abs(turn) > JointLaw::turning) turning_[i] = {q, turn > 0 ? 1.0 : -1.0};
    }
  }

  /// The channels of a reading, with the user's corrections.
  /// \returns whether these are numbers
  bool write(std::size_t beside, std::size_t r, Eigen::ArrayXd& row) {
    statics_.write(beside, r, direction_.x(), row);
    const RunRig& on = statics_.joints(beside).on();
    if (on.rig.stated_corrections.empty()) return true;
    const TimeStep& now = statics_.joints(beside).interval();
    Eigen::ArrayXd added = Eigen::ArrayXd::Zero(row.size());
    for (const StatedCorrection& one : on.rig.stated_corrections) {
      for (const Channel& channel : measured_) {
        if (!one.applies_to(channel)) continue;
        const Moment moment{now.end, run_.number, direction_of(channel), on.joint[channel.joint].rest,
                            now.covariates};
        added(channel.column) += one.value(reading_values(row, moment, channel));
      }
    }
    row += added;
    return added.isFinite().all();
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
  std::optional<Reading> before_;
  Statics& statics_;
  double last_way_ = 0;                     ///< length of the last step of the command
  Vector2 commanded_ = Vector2::Zero();     ///< last
  std::vector<double> last_rest_;           ///< joint angles that it commanded
  const Reading* last_ = nullptr;           ///< with a known command
  std::optional<std::size_t> last_number_;  ///< of it; none before the first
  double last_time_ = 0;
  Vector2 direction_ = Vector2::Zero();  ///< of the command along x and y; 0 until it has moved
  std::vector<Turning> turning_;         ///< of each joint
  bool moved_ = false;
};

}  // namespace plumbline::diagnose
