#include "diagnose/bench/sensor_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnose/bench/registration.hpp"

namespace plumbline::diagnose {
namespace {

/// Numbers that a sensor read, and the link that carries the point, on the nominal arm.
struct SensorSight {
  Pose<double> link;
  Eigen::Vector2d numbers;
};

/// Three shifts and three turns of the sensor, the same of the point, and the logarithm of the focal length.
constexpr Eigen::Index motions = 13;
using Motion = Eigen::Matrix<double, motions, 1>;

Pose<double> motion_of(const Eigen::Matrix<double, 6, 1>& by) {
  Pose<double> pose = Pose<double>::Identity();
  pose.translation() = by.head<3>();
  pose.linear() = rotation_by<double>(by.tail<3>());
  return pose;
}

/// A sensor and the point that it reads.
struct Sighting {
  ArmSensor sensor;
  Pose<double> point;  ///< on its link

  [[nodiscard]] Sighting moved(const Motion& by) const {
    Sighting next = *this;
    next.sensor.at = sensor.at * motion_of(by.head<6>());
    next.point = point * motion_of(by.segment<6>(6));
    next.sensor.focal_length *= std::exp(by(12));
    return next;
  }
  /// By two numbers a sight.
  [[nodiscard]] Eigen::VectorXd residual(const std::vector<SensorSight>& sights) const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(2 * sights.size()));
    for (std::size_t i = 0; i < sights.size(); ++i)
      all.segment<2>(static_cast<Eigen::Index>(2 * i)) =
          sights[i].numbers - sensor.of(sights[i].link * point);
    return all;
  }
};

/// \param free  numbers of the motions that are sought
Sighting fitted(Sighting at, const std::vector<SensorSight>& sights, const std::vector<Eigen::Index>& free,
                int iterations) {
  constexpr double step = 1e-6;
  Eigen::VectorXd left = at.residual(sights);
  double damping = 1e-3;
  for (int i = 0; i < iterations && damping < 1e6; ++i) {
    Eigen::MatrixXd slope(left.size(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
      slope.col(static_cast<Eigen::Index>(k)) =
          (left - at.moved(step * Motion::Unit(free[k])).residual(sights)) / step;
    Eigen::MatrixXd normal = slope.transpose() * slope;
    normal.diagonal() *= 1 + damping;
    normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
    const Eigen::VectorXd by = normal.ldlt().solve(slope.transpose() * left);
    Motion motion = Motion::Zero();
    for (std::size_t k = 0; k < free.size(); ++k) motion(free[k]) = by(static_cast<Eigen::Index>(k));
    const Sighting next = at.moved(motion);
    const Eigen::VectorXd found = next.residual(sights);
    if (!(found.squaredNorm() < left.squaredNorm())) {
      damping *= 10;
      continue;
    }
    const bool done = left.squaredNorm() - found.squaredNorm() <= 1e-12 * left.squaredNorm();
    at = next, left = found, damping = std::max(1e-9, damping / 10);
    if (done) break;
  }
  return at;
}

double spread(const std::vector<Eigen::Vector3d>& all) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& one : all) mean += one / static_cast<double>(all.size());
  double squares = 0;
  for (const Eigen::Vector3d& one : all) squares += (one - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(all.size()));
}

/// Starts of the search: as said, and one an orientation, so far from the points as the numbers tell.
std::vector<Sighting> starts(const Sighting& said, const std::vector<SensorSight>& sights) {
  std::vector<Eigen::Vector3d> places, numbers;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double largest = 0, sum = 0;
  for (const SensorSight& one : sights) {
    places.emplace_back((one.link * said.point).translation());
    middle += places.back() / static_cast<double>(sights.size());
    numbers.emplace_back(one.numbers.x(), one.numbers.y(), 0);
    largest = std::max(largest, one.numbers.norm());
    sum += one.numbers.x();
  }
  std::vector<Sighting> all{said};
  for (const Eigen::Matrix3d& turn : turns_of_axes()) {
    Sighting start = said;
    ArmSensor& sensor = start.sensor;
    const std::array<bool, 6>& sees = sensor.kind->sees_own;
    double far = sum / static_cast<double>(sights.size());
    if (sensor.kind->has_focal_length) {
      constexpr double usual = 2;  // times the half width of a picture
      if (!sensor.knows_focal_length) sensor.focal_length = usual * largest;
      far = sensor.focal_length * spread(places) / spread(numbers);
    }
    if (sensor.kind->sees_turns)
      start.point.linear() = turn;
    else
      sensor.at.translation() = middle - far * turn.col(2);
    if (sees[3] && !sensor.kind->sees_turns) sensor.at.linear() = turn;
    all.push_back(std::move(start));
  }
  return all;
}

class SensorRegistration {
 public:
  explicit SensorRegistration(Experiment& experiment)
      : experiment_(experiment), joints_(experiment.arm->arm.size()) {}

  void place(std::size_t number) {
    const std::vector<SensorSight> sights = sights_of(number);
    const Sighting said{sensor(number), point(number).at.frame};
    const std::vector<Eigen::Index> free = unknowns(number);
    if (sights.size() * said.sensor.kind->numbers < free.size()) return;
    constexpr std::size_t enough = 60;
    std::vector<SensorSight> few;
    const std::size_t stride = (sights.size() + enough - 1) / enough;
    for (std::size_t i = 0; i < sights.size(); i += stride) few.push_back(sights[i]);
    Sighting best = said;
    double least = INFINITY;
    // A vertical that is turned over with its point reads the same: it stays as said until the point is
    // found.
    std::vector<Eigen::Index> first = free;
    if (said.sensor.kind->sees_turns && !is_placed(number))
      std::erase_if(first, [](Eigen::Index motion) { return motion < 6; });
    for (const Sighting& start : starts(said, few)) {
      const Sighting found = fitted(start, few, first, 30);
      if (const double squares = found.residual(few).squaredNorm(); squares < least)
        least = squares, best = found;
    }
    best = fitted(std::move(best), sights, free, 60);
    experiment_.arm_bench.sensors[number] = best.sensor;
    move_point(experiment_, said.sensor.point, said.point.inverse() * best.point);
  }

 private:
  [[nodiscard]] const ArmSensor& sensor(std::size_t number) const {
    return experiment_.arm_bench.sensors[number];
  }
  [[nodiscard]] const MeasuredPoint& point(std::size_t number) const {
    return experiment_.arm_bench.points[sensor(number).point];
  }

  [[nodiscard]] std::vector<SensorSight> sights_of(std::size_t number) const {
    std::vector<SensorSight> all;
    for (const Run& run : experiment_.runs)
      for (const Reading& reading : run.readings) {
        Eigen::Vector2d numbers = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < sensor(number).kind->numbers; ++i)
          numbers(static_cast<Eigen::Index>(i)) =
              sensor(number).channel(number, i, joints_, experiment_.arm_bench.points.size()).of(reading);
        if (numbers.allFinite())
          all.push_back(
              {nominal_pose(experiment_.arm->arm, {point(number).at.link}, run.rest_at(reading)), numbers});
      }
    return all;
  }

  /// Whether the tracker, or a sensor before this one, has placed or turned the point.
  [[nodiscard]] bool is_placed(std::size_t number) const {
    const bool turns = sensor(number).kind->sees_turns;
    for (std::size_t s = 0; s < number; ++s)
      if (sensor(s).point == sensor(number).point && sensor(s).kind->sees_turns == turns) return true;
    const Channel channel(turns ? Channel::Name::turn : Channel::Name::place, 3 * sensor(number).point,
                          joints_);
    return std::ranges::any_of(experiment_.runs, [&](const Run& run) {
      return std::ranges::any_of(run.readings,
                                 [&](const Reading& one) { return std::isfinite(channel.of(one)); });
    });
  }

  [[nodiscard]] std::vector<Eigen::Index> unknowns(std::size_t number) const {
    const ArmSensorKind& kind = *sensor(number).kind;
    std::vector<Eigen::Index> free;
    for (std::size_t m = 0; m < kind.sees_own.size(); ++m)
      if (kind.sees_own[m]) free.push_back(static_cast<Eigen::Index>(m));
    const Eigen::Index first = kind.sees_turns ? 9 : 6;
    if (!is_placed(number)) free.insert(free.end(), {first, first + 1, first + 2});
    if (!sensor(number).knows_focal_length) free.push_back(12);
    return free;
  }

  Experiment& experiment_;
  std::size_t joints_;
};

}  // namespace

void register_sensors(Experiment& experiment) {
  for (std::size_t s = 0; s < experiment.arm_bench.sensors.size(); ++s)
    SensorRegistration(experiment).place(s);
}

}  // namespace plumbline::diagnose
