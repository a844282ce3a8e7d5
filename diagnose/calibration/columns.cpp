#include "diagnose/calibration/columns.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnose/calibration/registration.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double frame_step = 1e-6;  // m and rad

NominalEffect effect_of(const EffectAt& at) {
  return {std::string(at.effect->id), at.joint, {}};
}

/// Adds an effect's columns, each times the typical size of its parameter.
void append(EffectColumns& to, const Study& study, const EffectAt& at, const std::vector<VectorXd>& slopes) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  Eigen::Index next = to.columns.cols();
  to.columns.conservativeResize(static_cast<Eigen::Index>(study.measurements().size()),
                                next + static_cast<Eigen::Index>(ranges.size()));
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    to.columns.col(next++) = ranges[p].scale * slopes[p];
    to.parameters.push_back({at, ranges[p]});
  }
}

/// Derivatives of the readings by the parameters of a candidate at nothing.
std::vector<VectorXd> slopes_at_nothing(const Study& study, const Candidate& candidate) {
  const Prediction here =
      predict(study, candidate, std::vector<double>(study.ranges(candidate).size(), 0), true);
  std::vector<VectorXd> slopes;
  if (!here.reached) return slopes;
  for (const std::vector<Trace>& one : here.sensitivity)
    slopes.push_back(study.measurements().in_sigmas(one));
  return slopes;
}

/// Whether an effect is nothing at zero, so that a small amount of it shows what a larger one does.
bool grows_from_nothing(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  return !at.effect->perturbation.large_step && at.effect->perturbation.growing.empty() &&
         std::all_of(ranges.begin(), ranges.end(),
                     [](const ParameterRange& one) { return one.may_be_nothing() && one.tolerance == 0; });
}

/// A rig whose tracker and points are moved.
Rig with_frames_moved(Rig rig, Eigen::Index unknown, double step) {
  const Vector3<double> along = step * Vector3<double>::Unit(unknown % 3);
  const Eigen::Index frame = unknown / 6;
  const bool turns = unknown % 6 >= 3;
  if (frame == 0) {
    if (turns)
      rig.place_turn -= along;
    else
      rig.position_offset += along;
  } else {
    Pose<double>& point = rig.arm->points[static_cast<std::size_t>(frame - 1)].frame;
    if (turns)
      point.linear() *= rotation_by<double>(along);
    else
      point.translation() += along;
  }
  return rig;
}

}  // namespace

VectorXd EffectColumns::clamped(VectorXd coefficients) const {
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const ParameterRange& range = parameters[p].range;
    double& one = coefficients(static_cast<Eigen::Index>(p));
    one = std::clamp(one * range.scale, range.low, range.high) / range.scale;
  }
  return coefficients;
}

std::vector<NominalEffect> EffectColumns::at(const VectorXd& coefficients) const {
  std::vector<NominalEffect> all;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const auto& [at, range] = parameters[p];
    if (p == 0 || !(parameters[p - 1].at == at)) all.push_back(effect_of(at));
    all.back().parameters[std::string(range.name)] =
        catalogue_value(range.coordinate, coefficients(static_cast<Eigen::Index>(p)) * range.scale);
  }
  return all;
}

NominalEffect EffectColumns::effect(std::size_t group, const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(columns.cols());
  all.segment(groups[group].first, groups[group].count) = coefficients;
  std::size_t place = 0;
  for (Eigen::Index p = 1; p <= groups[group].first; ++p)
    place += !(parameters[static_cast<std::size_t>(p)].at == parameters[static_cast<std::size_t>(p - 1)].at);
  return at(clamped(all))[place];
}

LearnedSize EffectColumns::size_of(std::size_t group, double size) const {
  const Parameter& first = parameters[static_cast<std::size_t>(groups[group].first)];
  return {first.at, size * first.range.scale, first.range.unit};
}

std::vector<EffectAt> EffectColumns::within(const Eigen::MatrixXd& others) const {
  std::vector<EffectAt> all;
  if (others.cols() == 0) return all;
  const LeastSquares factors(others);
  const MatrixXd span = factors.orthonormal().leftCols(factors.rank());
  const MatrixXd left = columns - span * (span.transpose() * columns);
  constexpr double rounding = 1e-5;  // of difference quotients
  for (const ColumnGroup& one : groups)
    if (left.middleCols(one.first, one.count).norm() <=
        rounding * columns.middleCols(one.first, one.count).norm())
      all.push_back(parameters[static_cast<std::size_t>(one.first)].at);
  return all;
}

EffectColumns random_columns(const Study& study) {
  Candidate everywhere;
  for (const EffectAt& at : possible_effects(study))
    if (at.effect->everywhere) everywhere.effects.push_back(at);
  const std::vector<VectorXd> slopes = slopes_at_nothing(study, everywhere);
  EffectColumns all;
  all.columns.resize(static_cast<Eigen::Index>(study.measurements().size()), 0);
  auto next = slopes.begin();
  const Effect* last = nullptr;
  for (const EffectAt& at : everywhere.effects) {
    if (next == slopes.end()) break;
    const auto count = static_cast<std::ptrdiff_t>(study.ranges(at).size());
    if (at.effect != last) all.groups.push_back({all.columns.cols(), 0});
    append(all, study, at, {next, next + count});
    all.groups.back().count += count;
    last = at.effect, next += count;
  }
  return all;
}

EffectColumns columns_of_causes(const Study& study) {
  EffectColumns all;
  all.columns.resize(static_cast<Eigen::Index>(study.measurements().size()), 0);
  for (const EffectAt& at : possible_effects(study)) {
    if (!grows_from_nothing(study, at)) continue;
    const std::vector<VectorXd> slopes = slopes_at_nothing(study, {{at}});
    if (slopes.empty() ||
        std::any_of(slopes.begin(), slopes.end(), [](const VectorXd& one) { return !one.allFinite(); }))
      continue;
    all.groups.push_back({all.columns.cols(), static_cast<Eigen::Index>(slopes.size())});
    append(all, study, at, slopes);
  }
  return all;
}

MatrixXd columns_of_frames(const Study& study) {
  const std::size_t unknowns = 6 + 6 * study.experiment().arm_bench.points.size();
  std::vector<RigVariation> variations;
  for (std::size_t i = 0; i < unknowns; ++i)
    variations.push_back(
        {with_frames_moved(study.nominal_rig(), static_cast<Eigen::Index>(i), frame_step), frame_step});
  const Prediction here = simulate(study.experiment(), study.nominal_rig(), variations);
  MatrixXd all(static_cast<Eigen::Index>(study.measurements().size()), static_cast<Eigen::Index>(unknowns));
  for (std::size_t i = 0; i < unknowns; ++i)
    all.col(static_cast<Eigen::Index>(i)) = study.measurements().in_sigmas(here.sensitivity[i]);
  return all;
}

Pose<double> move_frames(Experiment& experiment, const VectorXd& coefficients) {
  const auto motion = [&](Eigen::Index frame) {
    Pose<double> by = Pose<double>::Identity();
    by.translation() = coefficients.segment<3>(6 * frame);
    by.linear() = rotation_by<double>(coefficients.segment<3>(6 * frame + 3));
    return by;
  };
  // The columns are those of a tracker that moves by this: what it tells moves back.
  const Pose<double> moved = motion(0).inverse();
  move_tracker(experiment, moved);
  for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p) {
    Pose<double> by = motion(static_cast<Eigen::Index>(p) + 1);
    const Eigen::Matrix3d& axes = experiment.arm_bench.points[p].at.frame.linear();
    by.translation() = axes.transpose() * by.translation();
    move_point(experiment, p, by);
  }
  return moved;
}

std::vector<SolvedFrame> solved(const Experiment& experiment, const Pose<double>& tracker,
                                const MatrixXd& frames, const MatrixXd& random, const VectorXd& size,
                                double noise) {
  MatrixXd columns(frames.rows(), frames.cols() + random.cols());
  columns << frames, random * size.asDiagonal();
  MatrixXd precision = columns.transpose() * columns / (noise * noise);
  precision.diagonal().tail(random.cols()).array() += 1;
  constexpr double unknown = 1e-12;  // against what nothing shows
  precision.diagonal().array() += unknown * precision.diagonal().maxCoeff();
  const VectorXd variance =
      precision.ldlt().solve(MatrixXd::Identity(precision.rows(), precision.cols())).diagonal();
  std::vector<SolvedFrame> all;
  for (std::size_t f = 0; f <= experiment.arm_bench.points.size(); ++f) {
    const auto first = static_cast<Eigen::Index>(6 * f);
    SolvedFrame one{f == 0 ? "tracker" : experiment.arm_bench.points[f - 1].name,
                    f == 0 ? tracker : experiment.arm_bench.points[f - 1].at.frame,
                    variance.segment<3>(first).cwiseSqrt(), variance.segment<3>(first + 3).cwiseSqrt()};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (frames.col(first + 3 + axis).isZero(0)) one.turn(axis) = 0;
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace plumbline::diagnose
