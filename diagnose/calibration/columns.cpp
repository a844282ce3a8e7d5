#include "diagnose/calibration/columns.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/bench/registration.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether an effect is nothing at zero, so that a small amount of it shows what a larger one does.
bool grows_from_nothing(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  return !at.effect->perturbation.large_step && at.effect->perturbation.growing.empty() &&
         std::all_of(ranges.begin(), ranges.end(),
                     [](const ParameterRange& one) { return one.may_be_nothing() && one.tolerance == 0; });
}

/// The effects that grow from nothing, those that are everywhere first, each kind of them together.
Candidate growing_effects(const Study& study) {
  Candidate all;
  for (const EffectAt& at : possible_effects(study))
    if (grows_from_nothing(study, at)) all.effects.push_back(at);
  std::stable_partition(all.effects.begin(), all.effects.end(),
                        [](const EffectAt& at) { return !at.effect->everywhere.empty(); });
  return all;
}

std::vector<std::size_t> numbers(std::size_t from, std::size_t to) {
  std::vector<std::size_t> all(to - from);
  std::iota(all.begin(), all.end(), from);
  return all;
}

/// The groups of effects that are everywhere, before those of single effects.
void group_everywhere(EffectColumns& all) {
  std::vector<ColumnGroup> everywhere;
  const Effect* last = nullptr;
  for (const ColumnGroup& one : all.groups) {
    const Effect* const effect = all.parameters[static_cast<std::size_t>(one.first)].at.effect;
    if (effect->everywhere.empty()) break;
    if (effect == last)
      everywhere.back().count += one.count;
    else
      everywhere.push_back(one);
    last = effect;
  }
  all.everywhere = everywhere.size();
  all.groups.insert(all.groups.begin(), everywhere.begin(), everywhere.end());
}

}  // namespace

std::vector<std::size_t> EffectColumns::always() const {
  return numbers(0, everywhere);
}

std::vector<std::size_t> EffectColumns::offered() const {
  return numbers(everywhere, groups.size());
}

std::vector<Tolerance> EffectColumns::effects(const GroupedFit& fit, std::size_t group) const {
  std::vector<Tolerance> all;
  for (Eigen::Index c = groups[fit.groups[group]].first, end = c + groups[fit.groups[group]].count; c < end;
       ++c) {
    const auto& [at, range] = parameters[static_cast<std::size_t>(c)];
    if (all.empty() || !(all.back().at == at)) all.push_back({at, {}, {}});
    const auto place = std::find(fit.columns.begin(), fit.columns.end(), c) - fit.columns.begin();
    const bool own = fit.owner[static_cast<std::size_t>(place)] == group;
    all.back().mean.push_back(own ? std::clamp(fit.mean(c) * range.scale, range.low, range.high) : 0);
    all.back().deviation.push_back(fit.size[group] * range.scale);
  }
  return all;
}

VectorXd EffectColumns::coefficients(const std::vector<Tolerance>& means) const {
  VectorXd all = VectorXd::Zero(columns.cols());
  std::size_t of_effect = 0;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const auto& [at, range] = parameters[p];
    of_effect = p > 0 && parameters[p - 1].at == at ? of_effect + 1 : 0;
    for (const Tolerance& one : means)
      if (one.at == at) all(static_cast<Eigen::Index>(p)) += one.mean[of_effect] / range.scale;
  }
  return all;
}

LearnedSize EffectColumns::size_of(std::size_t group, double size) const {
  // Arms slide at their base, where they slide at all: the last joint turns.
  const Parameter& last = parameters[static_cast<std::size_t>(groups[group].first + groups[group].count - 1)];
  return {last.at, size * last.range.scale, last.range.unit};
}

EffectColumns effect_columns(const Study& study) {
  const Candidate growing = growing_effects(study);
  const Prediction here = predict(study, growing, std::vector<double>(study.ranges(growing).size(), 0), true);
  EffectColumns all;
  std::vector<VectorXd> columns;
  std::size_t next = 0;
  for (const EffectAt& at : growing.effects) {
    const std::vector<ParameterRange> ranges = study.ranges(at);
    std::vector<VectorXd> slopes;
    for (std::size_t p = 0; p < ranges.size() && here.reached; ++p)
      slopes.push_back(ranges[p].scale * study.measurements().in_sigmas(here.sensitivity[next + p]));
    next += ranges.size();
    const auto finite = [](const VectorXd& one) { return one.allFinite(); };
    const auto shows = [](const VectorXd& one) { return !one.isZero(0); };
    if (!std::all_of(slopes.begin(), slopes.end(), finite) ||
        std::none_of(slopes.begin(), slopes.end(), shows))
      continue;
    all.groups.push_back(
        {static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(slopes.size())});
    columns.insert(columns.end(), slopes.begin(), slopes.end());
    for (const ParameterRange& range : ranges) all.parameters.push_back({at, range});
  }
  all.columns.resize(static_cast<Eigen::Index>(study.measurements().size()),
                     static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) all.columns.col(static_cast<Eigen::Index>(c)) = columns[c];
  group_everywhere(all);
  return all;
}

Pose<double> move_frames(Experiment& experiment, const VectorXd& coefficients) {
  const auto motion = [&](Eigen::Index frame) {
    Pose<double> by = Pose<double>::Identity();
    by.translation() = coefficients.segment<3>(6 * frame);
    by.linear() = rotation_by<double>(coefficients.segment<3>(6 * frame + 3));
    return by;
  };
  std::vector<ArmSensor>& beside_tracker = experiment.arm_bench.sensors;
  const auto first = static_cast<Eigen::Index>(1 + experiment.arm_bench.points.size());
  for (Eigen::Index s = 0; s < std::ssize(beside_tracker); ++s) {
    ArmSensor& sensor = beside_tracker[static_cast<std::size_t>(s)];
    sensor.at = sensor.at * motion(first + s);
    sensor.focal_length *= std::exp(coefficients(6 * (first + std::ssize(beside_tracker)) + s));
  }
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

std::vector<SolvedFrame> solved(const ArmBench& declared, const Experiment& experiment,
                                const Pose<double>& tracker, const MatrixXd& frames, const MatrixXd& effects,
                                const GroupedFit& fit) {
  MatrixXd columns(frames.rows(), frames.cols() + static_cast<Eigen::Index>(fit.columns.size()));
  columns.leftCols(frames.cols()) = frames;
  for (std::size_t c = 0; c < fit.columns.size(); ++c)
    columns.col(frames.cols() + static_cast<Eigen::Index>(c)) =
        fit.size[fit.owner[c]] * effects.col(fit.columns[c]);
  MatrixXd precision = columns.transpose() * columns / (fit.noise * fit.noise);
  precision.diagonal().tail(columns.cols() - frames.cols()).array() += 1;
  constexpr double unknown = 1e-12;  // against what nothing shows
  precision.diagonal().array() += unknown * precision.diagonal().maxCoeff();
  const VectorXd variance =
      precision.ldlt().solve(MatrixXd::Identity(precision.rows(), precision.cols())).diagonal();
  const ArmBench& bench = experiment.arm_bench;
  using Of = SolvedFrame::Of;
  std::vector<SolvedFrame> all{{Of::tracker, "tracker", tracker, Pose<double>::Identity(), {}, {}}};
  for (std::size_t p = 0; p < bench.points.size(); ++p)
    all.push_back(
        {Of::point, bench.points[p].name, bench.points[p].at.frame, declared.points[p].at.frame, {}, {}});
  for (std::size_t s = 0; s < bench.sensors.size(); ++s)
    all.push_back({Of::sensor, bench.sensors[s].name, bench.sensors[s].at, declared.sensors[s].at, {}, {}});
  const auto deviation = [&](Eigen::Index column) {
    return frames.col(column).isZero(0) ? 0 : std::sqrt(variance(column));
  };
  for (std::size_t f = 0; f < all.size(); ++f)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      all[f].shift(axis) = deviation(static_cast<Eigen::Index>(6 * f) + axis);
      all[f].turn(axis) = deviation(static_cast<Eigen::Index>(6 * f) + 3 + axis);
    }
  for (std::size_t s = 0; s < bench.sensors.size(); ++s) {
    if (bench.sensors[s].knows_focal_length) continue;
    SolvedFrame& one = all[1 + bench.points.size() + s];
    one.focal_length = bench.sensors[s].focal_length;
    one.focal_length_sd = one.focal_length * deviation(static_cast<Eigen::Index>(6 * all.size() + s));
  }
  return all;
}

}  // namespace plumbline::diagnose
