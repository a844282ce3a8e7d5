#include "diagnose/inference/summed_out.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "diagnose/inference/calibration.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {
namespace {

/// What the tolerances of a calibrated study do to its readings, declared sigmas.
struct ToleranceColumns {
  MatrixXd columns;  ///< by standard deviations, over that of the noise
  VectorXd mean;     ///< what their means add

  explicit ToleranceColumns(const Study& study) {
    const Calibration& known = *study.experiment().arm_bench.calibration;
    Candidate all;
    std::vector<double> means, deviations;
    for (const Tolerance& one : known.tolerances) {
      all.effects.push_back(one.at);
      means.insert(means.end(), one.mean.begin(), one.mean.end());
      deviations.insert(deviations.end(), one.deviation.begin(), one.deviation.end());
    }
    const Prediction here = predict(study, all, std::vector<double>(means.size(), 0), true);
    const auto values = static_cast<Eigen::Index>(study.measurements().size());
    mean = VectorXd::Zero(values);
    columns = MatrixXd::Zero(values, static_cast<Eigen::Index>(means.size()));
    for (std::size_t p = 0; p < means.size() && here.reached; ++p) {
      const VectorXd slope = study.measurements().in_sigmas(here.sensitivity[p]);
      columns.col(static_cast<Eigen::Index>(p)) = deviations[p] / known.noise * slope;
      mean += means[p] * slope;
    }
  }
};

/// A rig whose tracker, points and sensors are moved, or whose focal lengths are longer.
Rig with_frame_moved(Rig rig, std::size_t unknown, double step) {
  const Vector3<double> along = step * Vector3<double>::Unit(static_cast<Eigen::Index>(unknown % 3));
  const std::size_t frame = unknown / 6, points = rig.arm->points.size(), sensors = rig.arm->sensors.size();
  const bool turns = unknown % 6 >= 3;
  if (frame == 0) {
    (turns ? rig.place_turn : rig.position_offset) += turns ? Vector3<double>(-along) : along;
  } else if (frame <= points + sensors) {
    Pose<double>& at =
        frame <= points ? rig.arm->points[frame - 1].frame : rig.arm->sensors[frame - points - 1].at;
    if (turns)
      at.linear() *= rotation_by<double>(along);
    else
      at.translation() += frame <= points ? along : Vector3<double>(at.linear() * along);
  } else {
    rig.arm->sensors[unknown - 6 * (1 + points + sensors)].focal_length *= 1 + step;
  }
  return rig;
}

/// Whether a motion of a frame, or a focal length, is unknown and changes some reading. That of the tracker
/// is told by its own readings alone: sensors stand where they stand without one.
bool is_sought(const Study& study, std::size_t unknown) {
  using Name = Channel::Name;
  const ArmBench& bench = study.experiment().arm_bench;
  const std::size_t frame = unknown / 6, points = bench.points.size(), sensors = bench.sensors.size();
  if (frame == 0) return study.scales().measures(Name::place) || study.scales().measures(Name::turn);
  if (frame <= points) return true;
  if (frame > points + sensors)
    return !bench.sensors[unknown - 6 * (1 + points + sensors)].knows_focal_length;
  return bench.sensors[frame - points - 1].kind->sees_own.at(unknown % 6);
}

}  // namespace

Whitening::Whitening(const MatrixXd& unknown, const MatrixXd& random) {
  const LeastSquares factors(unknown);
  unknown_ = unknown.cols() > 0 ? MatrixXd(factors.orthonormal().leftCols(factors.rank()))
                                : MatrixXd(random.rows(), 0);
  const MatrixXd left = random - unknown_ * (unknown_.transpose() * random);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(left.transpose() * left));
  std::vector<Eigen::Index> axes;
  for (Eigen::Index i = 0; i < left.cols(); ++i)
    if (constexpr double negligible = 1e-6; eigen.eigenvalues()(i) > negligible) axes.push_back(i);
  const VectorXd variance = eigen.eigenvalues()(axes);
  random_ = left * eigen.eigenvectors()(Eigen::all, axes) * variance.cwiseSqrt().cwiseInverse().asDiagonal();
  taken_ = 1 - (1 + variance.array()).rsqrt();
}

VectorXd Whitening::operator()(VectorXd values) const {
  if (unknown_.cols() > 0) values -= unknown_ * (unknown_.transpose() * values);
  if (random_.cols() > 0) values -= random_ * taken_.cwiseProduct(random_.transpose() * values);
  return values;
}

SummedOut::SummedOut(const Study& study) {
  const ToleranceColumns tolerances(study);
  whitening_ = Whitening(frame_columns(study), tolerances.columns);
  without_ = tolerances.mean;
}

VectorXd SummedOut::of_residual(const VectorXd& residual) const {
  return without_.size() == 0 ? residual : whitening_(residual + without_);
}

VectorXd SummedOut::of_slope(const VectorXd& slope) const {
  VectorXd left = whitening_(slope);
  constexpr double rounding = 1e-5;  // of difference quotients
  if (without_.size() > 0 && left.norm() < rounding * slope.norm()) left.setZero();
  return left;
}

MatrixXd frame_columns(const Study& study) {
  const ArmBench& bench = study.experiment().arm_bench;
  const auto values = static_cast<Eigen::Index>(study.measurements().size());
  if (bench.frames == ArmBench::Frames::known) return {values, 0};
  constexpr double step = 1e-6;  // m, rad, and of a focal length its share
  const std::size_t unknowns = 6 * (1 + bench.points.size() + bench.sensors.size()) + bench.sensors.size();
  std::vector<Eigen::Index> sought;
  std::vector<RigVariation> variations;
  for (std::size_t i = 0; i < unknowns; ++i)
    if (is_sought(study, i)) {
      sought.push_back(static_cast<Eigen::Index>(i));
      variations.push_back({with_frame_moved(study.nominal_rig(), i, step), step});
    }
  const Prediction here = simulate(study.experiment(), study.nominal_rig(), variations);
  MatrixXd all = MatrixXd::Zero(values, static_cast<Eigen::Index>(unknowns));
  for (std::size_t i = 0; i < sought.size(); ++i)
    all.col(sought[i]) = study.measurements().in_sigmas(here.sensitivity[i]);
  return all;
}

NominalEffect nominal_effect(const Study& study, const Tolerance& of) {
  NominalEffect one{std::string(of.at.effect->id), of.at.joint, {}};
  const std::vector<ParameterRange> ranges = study.ranges(of.at);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    one.parameters[std::string(ranges[p].name)] =
        catalogue_value(ranges[p].coordinate, std::clamp(of.mean[p], ranges[p].low, ranges[p].high));
  return one;
}

Experiment beside(const Study& study, const Instance& cause) {
  Experiment all = study.experiment();
  const Prediction predicted = predict(study, cause.candidate, cause.parameters);
  if (!all.arm_bench.calibration || !predicted.reached) return all;
  const Calibration& known = *all.arm_bench.calibration;
  const ToleranceColumns tolerances(study);
  const Whitening whitening(frame_columns(study), tolerances.columns);
  // The posterior mean of z ~ N(0, 1) where readings leave r = Z z + noise, over that of the noise:
  // Z' (1 + Z Z')^{-1} r.
  const VectorXd found = tolerances.columns.transpose() *
                         whitening(whitening(study.measurements().residual(predicted) + tolerances.mean)) /
                         known.noise;
  Eigen::Index next = 0;
  for (const Tolerance& one : known.tolerances) {
    Tolerance now = one;
    for (std::size_t p = 0; p < one.mean.size(); ++p) now.mean[p] = one.deviation[p] * found(next++);
    std::erase(all.effects, nominal_effect(study, one));
    all.effects.push_back(nominal_effect(study, now));
  }
  return all;
}

}  // namespace plumbline::diagnose
