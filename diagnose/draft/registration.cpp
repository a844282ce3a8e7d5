#include "diagnose/draft/registration.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace plumbline::diagnose {
namespace {

using Points = Eigen::Matrix3Xd;

struct Pairs {
  Points nominal, read;
};

Pairs pairs_of(const std::vector<ArmRun>& runs, const NominalArm& arm) {
  std::vector<Eigen::Vector3d> nominal, read;
  const OnLink<double> tip{arm.arm.size() - 1, arm.arm.tip};
  for (const ArmRun& run : runs)
    for (std::size_t i = 0; i < run.places.size(); ++i) {
      const Eigen::Vector3d place = run.places[i];
      const Eigen::Vector3d at = nominal_pose(arm.arm, tip, run.commands[i]).translation();
      if (!at.allFinite() || place.array().isNaN().count() > 1) continue;
      nominal.push_back(at), read.push_back(place);
    }
  Pairs pairs{Points(3, nominal.size()), Points(3, nominal.size())};
  for (std::size_t i = 0; i < nominal.size(); ++i)
    pairs.nominal.col(static_cast<Eigen::Index>(i)) = nominal[i],
    pairs.read.col(static_cast<Eigen::Index>(i)) = read[i];
  return pairs;
}

/// Root mean square distance from the mean; a coordinate that was not read counts nowhere.
double spread(const Points& points, const Points& read) {
  double sum = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd row = points.row(axis).array();
    if (!read.row(axis).allFinite()) continue;
    sum += (row - row.mean()).square().mean();
  }
  return std::sqrt(sum);
}

double rms(const Points& difference) {
  const auto squares = difference.array().isNaN().select(0, difference.array().square());
  return std::sqrt(squares.sum() / static_cast<double>(difference.cols()));
}

}  // namespace

Registration registered(const std::vector<ArmRun>& runs, const NominalArm& arm) {
  Registration result{"m", false, Pose<double>::Identity(), 0, 0};
  const Pairs pairs = pairs_of(runs, arm);
  if (pairs.read.cols() == 0) return result;
  for (const ArmRun& run : runs)
    if (!run.unit_of_place.empty()) result.unit = run.unit_of_place, result.said = true;
  if (!result.said) {
    const double ratio = spread(pairs.nominal, pairs.read) / spread(pairs.read, pairs.read);
    double nearest = std::numeric_limits<double>::infinity();
    for (const char* unit : {"m", "mm", "cm", "in"})
      if (const double off = std::abs(std::log(ratio / parse_unit(unit, quantity::length, "").in_si()));
          off < nearest)
        nearest = off, result.unit = unit;
  }
  const Points read = pairs.read * parse_unit(result.unit, quantity::length, "").in_si();
  result.as_read = result.as_registered = rms(read - pairs.nominal);
  constexpr Eigen::Index least = 4;
  if (!read.allFinite() || read.cols() < least) return result;
  const Eigen::Matrix4d moved = Eigen::umeyama(pairs.nominal, read, false);
  result.frame.matrix() = moved;
  const Points at =
      (moved.topLeftCorner<3, 3>() * pairs.nominal).colwise() + moved.topRightCorner<3, 1>().eval();
  result.as_registered = rms(read - at);
  // A frame that is a little off is a cause, which the diagnosis is to find; another frame is a fact.
  constexpr double far = 0.02, clearly = 5;
  result.takes_frame =
      result.as_read > far * spread(pairs.nominal, read) && result.as_read > clearly * result.as_registered;
  if (!result.takes_frame) result.frame = Pose<double>::Identity();
  return result;
}

}  // namespace plumbline::diagnose
