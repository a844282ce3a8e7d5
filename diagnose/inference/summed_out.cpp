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

/// A rig whose tracker and points are moved.
Rig with_frame_moved(Rig rig, std::size_t unknown, double step) {
  const Vector3<double> along = step * Vector3<double>::Unit(static_cast<Eigen::Index>(unknown % 3));
  const std::size_t frame = unknown / 6;
  const bool turns = unknown % 6 >= 3;
  if (frame == 0) {
    (turns ? rig.place_turn : rig.position_offset) += turns ? Vector3<double>(-along) : along;
    return rig;
  }
  Pose<double>& point = rig.arm->points[frame - 1].frame;
  if (turns)
    point.linear() *= rotation_by<double>(along);
  else
    point.translation() += along;
  return rig;
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
  constexpr double step = 1e-6;  // m and rad
  std::vector<RigVariation> variations;
  for (std::size_t i = 0; i < 6 + 6 * bench.points.size(); ++i)
    variations.push_back({with_frame_moved(study.nominal_rig(), i, step), step});
  const Prediction here = simulate(study.experiment(), study.nominal_rig(), variations);
  MatrixXd all(values, static_cast<Eigen::Index>(variations.size()));
  for (std::size_t i = 0; i < variations.size(); ++i)
    all.col(static_cast<Eigen::Index>(i)) = study.measurements().in_sigmas(here.sensitivity[i]);
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
