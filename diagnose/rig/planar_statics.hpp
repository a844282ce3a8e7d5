#pragma once
/// \file
/// A planar rig and its variations in one run: how they come to rest at a stop, and what is read there.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "diagnose/rig/history.hpp"
#include "diagnose/rig/rig_solver.hpp"
#include "diagnose/rig/substeps.hpp"
#include "diagnose/rig/traveller.hpp"

namespace plumbline::diagnose {

/// Serves Walk.
/// \tparam Bandwidth  of the layout
template <int Bandwidth>
class PlanarStatics {
 public:
  PlanarStatics(const Experiment& experiment, const Run& run, const Layout& layout, const Rig& rig,
                const std::vector<Rig>& variations)
      : run_(run),
        layout_(layout),
        parts_(substeps(run, layout.sliders, rig)),
        solver_(layout, std::accumulate(parts_.begin(), parts_.end(), std::size_t{0})),
        main_(experiment, rig, run) {
    beside_.reserve(variations.size());
    for (const Rig& other : variations) beside_.emplace_back(experiment, other, run);
    start();
  }

  [[nodiscard]] bool snapped() const { return snapped_; }

  /// Number of steps to each reading.
  [[nodiscard]] const std::vector<std::size_t>& parts() const { return parts_; }

  [[nodiscard]] bool is_commanded(const Reading& reading) const {
    return run_.imposed_at(reading).allFinite();
  }

  /// \param beside  number of a variation, from 1; 0 for the rig
  [[nodiscard]] const JointStates& joints(std::size_t beside) const { return traveller(beside).joints; }

  [[nodiscard]] double joint_angle(std::size_t joint) const {
    return layout_.joint_angle(main_.posture.angle, joint);
  }

  /// \returns false where the rig cannot follow
  bool arrive(const Stop& stop, const Passage& passage) {
    const double size = run_.imposed_at(stop.reading).norm();
    if (size != last_size_) growing_ = size > last_size_ ? 1 : -1;
    last_size_ = size;
    const Imposed& target = main_.impose(run_, main_.joints.head_for(stop, passage), growing_);
    const RigStep step = main_.joints.step();
    extrapolate(target, passage);
    last_posture_ = main_.posture;
    const bool arrives = solver_.follow(step, at_, target, guess_, main_.posture);
    const bool crosses =
        stop.to && stop.share == 1 && run_.branch && crosses_over(step, target, *stop.to, arrives);
    if (!arrives && !crosses) return false;
    snapped_ = snapped_ || (!crosses && solver_.snapped());
    if (!beside_.empty()) solver_.prepare(step, target, main_.posture);
    for (Traveller& other : beside_) {
      const Imposed& its = other.impose(run_, other.joints.head_for(stop, passage), growing_);
      solver_.neighbour(other.joints.step(), its, main_.posture, other.posture);
    }
    last_step_ = target.value - at_.value;
    at_ = target;
    return true;
  }

  void remember() {
    for (Traveller& other : beside_) other.remember(layout_);
    main_.remember(layout_);
  }

  /// The channels of a reading, as a row of a trace.
  /// \param direction  of the command along x
  void write(std::size_t beside, std::size_t reading_number, double direction,
             Eigen::Ref<Eigen::ArrayXd> row) {
    const Traveller& rig = traveller(beside);
    const Reading& reading = run_.readings[reading_number];
    Vector2 end(reading[column_x], reading[column_y]), force(reading[column_Fx], reading[column_Fy]);
    if (run_.holds_end_point()) {
      force = rig.felt_force(reading.t, direction);
    } else {
      const Rig& own = rig.joints.rig();
      Vector3<double> place = -own.frame_at(reading.t);
      place.head<2>() += solver_.end_point(rig.joints.on(), rig.imposed.loads, rig.posture);
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
  }

 private:
  [[nodiscard]] const Traveller& traveller(std::size_t beside) const {
    return beside == 0 ? main_ : beside_[beside - 1];
  }

  void start() {
    double theta = 0;
    main_.posture.contact.assign(layout_.links * layout_.sliders, Contact::sticks);
    main_.posture.angle.resize(static_cast<Eigen::Index>(layout_.nodes()));
    for (std::size_t j = 0; j < layout_.links; ++j) point(j, theta += main_.joints.on().joint[j].rest);
    at_ = {run_.control, Vector2(0, 0)};
    if (!run_.readings.empty() && run_.holds_end_point())
      at_.value = solver_.end_point(main_.joints.on(), {}, main_.posture);
  }

  /// Lets a link point in a direction, unbent.
  void point(std::size_t link, double theta) {
    main_.posture.angle
        .segment(static_cast<Eigen::Index>(layout_.first(link)),
                 static_cast<Eigen::Index>(layout_.nodes_per_link()))
        .setConstant(theta);
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
      along += (joint_angle(i) - (there + other) / 2) * way;
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
    for (std::size_t j = 0; j < layout_.links; ++j)
      point(j, theta += run_.branch->angles(row, static_cast<Eigen::Index>(j)));
    main_.posture.force = {run_.branch->force(row, 0), run_.branch->force(row, 1)};
    guess_ = main_.posture;
    if (solver_.follow(step, target, target, guess_, main_.posture) && !is_on_other_branch(apart))
      return true;
    main_.posture = stays;
    return false;
  }

  /// Extrapolates the last step as a first guess, where the command keeps its direction.
  void extrapolate(const Imposed& target, const Passage& passage) {
    guess_ = main_.posture;
    const Vector2 step = target.value - at_.value;
    if (passage.first || step.dot(last_step_) <= 0.5 * step.norm() * last_step_.norm()) return;
    const double share = step.norm() / last_step_.norm();
    guess_.angle += share * (guess_.angle - last_posture_.angle);
    guess_.force.x += share * (guess_.force.x - last_posture_.force.x);
    guess_.force.y += share * (guess_.force.y - last_posture_.force.y);
  }

  const Run& run_;
  Layout layout_;
  std::vector<std::size_t> parts_;
  RigSolver<Bandwidth> solver_;
  Traveller main_;
  std::vector<Traveller> beside_;
  Posture last_posture_, guess_;
  Vector2 last_step_ = Vector2::Zero();
  Imposed at_{Control::end_point, Vector2::Zero()};
  double last_size_ = 0, growing_ = 1;  ///< of the imposed force: its size, and whether it grows (1, -1)
  bool snapped_ = false;
};

}  // namespace plumbline::diagnose
