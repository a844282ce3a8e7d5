#include "diagnose/bench/registration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

Vector3<double> read(const Reading& reading, Channel::Name name, std::size_t point, std::size_t joints) {
  Vector3<double> value;
  for (std::size_t axis = 0; axis < 3; ++axis)
    value(static_cast<Eigen::Index>(axis)) = Channel(name, 3 * point + axis, joints).of(reading);
  return value;
}

void write(Reading& reading, Channel::Name name, std::size_t point, std::size_t joints,
           const Vector3<double>& value) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    Channel(name, 3 * point + axis, joints).in(reading) = value(static_cast<Eigen::Index>(axis));
}

/// Calls `visit(run, reading)` for every reading.
template <class Visit>
void for_each_reading(Experiment& experiment, Visit visit) {
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) visit(run, reading);
}

/// What an orientation is told from.
Eigen::Matrix3d told(const Experiment& experiment, std::size_t point, const Run& run,
                     const Reading& reading) {
  return nominal_pose(experiment.arm->arm, experiment.arm_bench.points[point].at, run.rest_at(reading))
      .linear();
}

std::vector<Sight> sights_of(const Experiment& experiment) {
  const std::size_t joints = experiment.arm->arm.size();
  std::vector<Sight> all;
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings)
      for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p) {
        const Vector3<double> place = read(reading, Channel::Name::place, p, joints);
        if (!place.allFinite()) continue;
        const std::size_t link = experiment.arm_bench.points[p].at.link;
        all.push_back({p, nominal_pose(experiment.arm->arm, {link}, run.rest_at(reading)), place});
      }
  return all;
}

/// The tracker's frame and the places of the points on their links.
struct Frames {
  Pose<double> tracker;
  std::vector<Vector3<double>> point;

  [[nodiscard]] Vector3<double> seen(const Sight& one) const {
    return tracker * (one.link * point[one.point]);
  }
  [[nodiscard]] double squares(const std::vector<Sight>& sights) const {
    double sum = 0;
    for (const Sight& one : sights) sum += (seen(one) - one.place).squaredNorm();
    return sum;
  }
  /// Root mean square distance, over that of the places from their mean.
  [[nodiscard]] double misfit(const std::vector<Sight>& sights) const {
    Vector3<double> mean = Vector3<double>::Zero();
    for (const Sight& one : sights) mean += one.place / static_cast<double>(sights.size());
    double spread = 0;
    for (const Sight& one : sights) spread += (one.place - mean).squaredNorm();
    return spread > 0 ? std::sqrt(squares(sights) / spread) : 0;
  }
};

Eigen::Matrix3d cross_matrix(const Vector3<double>& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// A damped step of Gauss and Newton's method: turn and shift of the tracker, then the points.
Frames stepped(const Frames& at, const std::vector<Sight>& sights, double damping) {
  const auto unknowns = static_cast<Eigen::Index>(6 + 3 * at.point.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(3, unknowns);
  for (const Sight& one : sights) {
    const Vector3<double> seen = at.seen(one);
    slope.setZero();
    slope.leftCols<3>() = -cross_matrix(seen - at.tracker.translation());
    slope.middleCols<3>(3).setIdentity();
    slope.middleCols<3>(6 + 3 * static_cast<Eigen::Index>(one.point)) =
        at.tracker.linear() * one.link.linear();
    normal.noalias() += slope.transpose() * slope;
    right.noalias() += slope.transpose() * (one.place - seen);
  }
  normal.diagonal().array() += damping * normal.diagonal().maxCoeff();
  const Eigen::VectorXd step = normal.ldlt().solve(right);
  Frames next = at;
  next.tracker.linear() = rotation_by<double>(step.head<3>()) * at.tracker.linear();
  next.tracker.translation() += step.segment<3>(3);
  for (std::size_t p = 0; p < at.point.size(); ++p)
    next.point[p] += step.segment<3>(6 + 3 * static_cast<Eigen::Index>(p));
  return next;
}

Frames descended(Frames at, const std::vector<Sight>& sights, int iterations) {
  double squares = at.squares(sights), damping = 1e-6;
  for (int i = 0; i < iterations && damping < 1e3; ++i) {
    Frames next = stepped(at, sights, damping);
    const double found = next.squares(sights);
    if (!(found < squares)) {
      damping *= 30;
      continue;
    }
    const bool done = squares - found <= 1e-12 * squares;
    at = std::move(next), squares = found, damping = std::max(1e-10, damping / 10);
    if (done) break;
  }
  return at;
}

/// The rotation that is nearest to all of some.
Eigen::Matrix3d mean_rotation(const Eigen::Matrix3d& sum) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

/// With the tracker where the points as they are fit best: W. Kabsch, Acta Cryst. A32 (1976).
Frames placed(Frames frames, const std::vector<Sight>& sights) {
  const auto count = static_cast<double>(sights.size());
  frames.tracker.setIdentity();
  Vector3<double> seen = Vector3<double>::Zero(), place = seen;
  for (const Sight& one : sights) seen += frames.seen(one) / count, place += one.place / count;
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  for (const Sight& one : sights) product += (one.place - place) * (frames.seen(one) - seen).transpose();
  frames.tracker.linear() = mean_rotation(product);
  frames.tracker.translation() = place - frames.tracker.linear() * seen;
  return frames;
}

Frames best_of_starts(const Frames& nominal, const std::vector<Sight>& sights) {
  constexpr std::size_t enough = 100;
  std::vector<Sight> few;
  const std::size_t stride = (sights.size() + enough - 1) / enough;
  for (std::size_t i = 0; i < sights.size(); i += stride) few.push_back(sights[i]);
  Frames best = descended(placed(nominal, few), few, 60);
  double least = best.squares(few);
  for (const Eigen::Matrix3d& turn : turns_of_axes()) {
    Frames start = nominal;
    start.tracker.linear() = turn;
    start.tracker.translation().setZero();
    Vector3<double> mean = Vector3<double>::Zero();
    for (const Sight& one : few) mean += one.place - start.seen(one);
    start.tracker.translation() = mean / static_cast<double>(few.size());
    start = descended(std::move(start), few, 60);
    if (const double squares = start.squares(few); squares < least) least = squares, best = start;
  }
  return descended(std::move(best), sights, 100);
}

/// Turns a point's frame to the mean of what was seen of it.
void turn_to_mean(Experiment& experiment, std::size_t point) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for_each_reading(experiment, [&](const Run&, const Reading& reading) {
    const Vector3<double> turn = read(reading, Channel::Name::turn, point, experiment.arm->arm.size());
    if (turn.allFinite()) sum += rotation_by<double>(turn);
  });
  if (sum.isZero(0)) return;
  Pose<double> by = Pose<double>::Identity();
  by.linear() = mean_rotation(sum);
  move_point(experiment, point, by);
}

}  // namespace

std::vector<Eigen::Matrix3d> turns_of_axes() {
  std::vector<Eigen::Matrix3d> all;
  for (Eigen::Index x = 0; x < 3; ++x)
    for (Eigen::Index y = 0; y < 3; ++y)
      for (const double sign_x : {1.0, -1.0})
        for (const double sign_y : {1.0, -1.0}) {
          if (x == y) continue;
          Eigen::Matrix3d turn;
          turn.col(0) = sign_x * Vector3<double>::Unit(x);
          turn.col(1) = sign_y * Vector3<double>::Unit(y);
          turn.col(2) = turn.col(0).cross(turn.col(1));
          all.push_back(turn);
        }
  return all;
}

void move_tracker(Experiment& experiment, const Pose<double>& frame) {
  const Pose<double> back = frame.inverse();
  const std::size_t joints = experiment.arm->arm.size();
  for_each_reading(experiment, [&](const Run& run, Reading& reading) {
    for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p) {
      const Vector3<double> place = read(reading, Channel::Name::place, p, joints),
                            turn = read(reading, Channel::Name::turn, p, joints);
      if (place.allFinite()) write(reading, Channel::Name::place, p, joints, back * place);
      if (!turn.allFinite()) continue;
      const Eigen::Matrix3d from = told(experiment, p, run, reading);
      write(reading, Channel::Name::turn, p, joints,
            rotation_vector<double>(from.transpose() * back.linear() * from * rotation_by<double>(turn)));
    }
  });
  for (ArmSensor& sensor : experiment.arm_bench.sensors) sensor.at = back * sensor.at;
}

void move_point(Experiment& experiment, std::size_t point, const Pose<double>& by) {
  Pose<double>& frame = experiment.arm_bench.points[point].at.frame;
  frame = frame * by;
  const std::size_t joints = experiment.arm->arm.size();
  for_each_reading(experiment, [&](const Run&, Reading& reading) {
    const Vector3<double> turn = read(reading, Channel::Name::turn, point, joints);
    if (turn.allFinite())
      write(reading, Channel::Name::turn, point, joints,
            rotation_vector<double>(by.linear().transpose() * rotation_by<double>(turn)));
  });
}

double misfit_as_told(const std::vector<Sight>& sights, const std::vector<Vector3<double>>& points) {
  return Frames{Pose<double>::Identity(), points}.misfit(sights);
}

double misfit_in_any_frame(const std::vector<Sight>& sights, std::vector<Vector3<double>> points) {
  const Frames start{Pose<double>::Identity(), std::move(points)};
  return descended(placed(start, sights), sights, 30).misfit(sights);
}

Pose<double> register_frames(Experiment& experiment) {
  const std::vector<Sight> sights = sights_of(experiment);
  Frames frames{Pose<double>::Identity(), {}};
  for (const MeasuredPoint& point : experiment.arm_bench.points)
    frames.point.push_back(point.at.frame.translation());
  if (sights.size() < 2 + frames.point.size()) return frames.tracker;
  frames = best_of_starts(frames, sights);
  move_tracker(experiment, frames.tracker);
  for (std::size_t p = 0; p < frames.point.size(); ++p) {
    const Pose<double>& at = experiment.arm_bench.points[p].at.frame;
    Pose<double> by = Pose<double>::Identity();
    by.translation() = at.linear().transpose() * (frames.point[p] - at.translation());
    move_point(experiment, p, by);
    turn_to_mean(experiment, p);
  }
  return frames.tracker;
}

}  // namespace plumbline::diagnose
