#include "diagnose/motion/motion_log.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plumbline::motion {

InitialState initial_state(const MotionLog& log, std::size_t reading) {
  constexpr std::size_t to_either_side = 3;
  const std::size_t first = reading > to_either_side ? reading - to_either_side : 0;
  const std::size_t end = std::min(log.time.size(), reading + to_either_side + 1);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = first; k < end; ++k) {
    const double t = log.time[k] - log.time[reading];
    const Eigen::Vector3d row(1, t, t * t);
    normal += row * row.transpose();
    right += row * log.position[k];
  }
  const Eigen::Vector3d found = normal.ldlt().solve(right);
  return {found(0), found(1), 2 * found(2)};
}

std::vector<Segment> segments_of(const std::vector<MotionLog>& logs, double duration) {
  constexpr std::size_t fewest = 12;       // readings of a segment
  constexpr double unknown_command = 0.1;  // s
  std::vector<Segment> all;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::vector<double>& time = logs[i].time;
    const auto reading_at = [&](double t) {
      return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
    };
    const double begin = time.front() + std::min(unknown_command, (time.back() - time.front()) / 10),
                 whole = time.back() - begin;
    const double parts = std::max(1.0, std::round(whole / duration));
    std::size_t first = reading_at(begin);
    for (double part = 1; part <= parts; ++part) {
      const std::size_t end = part == parts ? time.size() : reading_at(begin + whole * part / parts);
      if (end >= first + fewest) all.push_back({i, first, end});
      first = end;
    }
  }
  return all;
}

}  // namespace plumbline::motion
