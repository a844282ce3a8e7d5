#include "diagnose/motion/motion_plan.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>
#include <set>

#include "diagnose/design/fewest_runs.hpp"
#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {
namespace {

using diagnose::Contrast, diagnose::LinearisedAlternative;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// An effect where it is expected to stand.
std::vector<double> typical(const std::vector<Parameter>& parameters) {
  std::vector<double> values;
  for (const Parameter& one : parameters)
    values.push_back(std::clamp(one.guess != 0 ? one.guess : one.range.scale, one.range.low, one.range.high));
  return values;
}

/// The logs as the model predicts them, its unknown numbers at their typical sizes.
Bench predicted_bench(Bench bench) {
  for (MotionLog& log : bench.logs)
    for (std::size_t c = 0; c < channel_count; ++c)
      if (bench.sigma_beside[c] > 0)
        log.beside.push_back({static_cast<Channel>(c), std::vector<double>(log.time.size(), 0)});
  const Study rough(bench);
  const Drive<double> drive = rough.drive(rough.parameters({}), typical(rough.parameters({})));
  for (MotionLog& log : bench.logs) {
    const std::vector<std::vector<double>> read =
        readings_of(drive, log, {0, 0, log.time.size(), log.step}, log.command.front(), 0.0);
    log.position = read.front();
    for (std::size_t i = 0; i < log.beside.size(); ++i) log.beside[i].value = read[1 + i];
  }
  return bench;
}

/// Predictions near an effect's typical size.
using Tangent = std::vector<SegmentMeans>;

/// The rows of one motion in standard deviations of the noise, with its begins summed out.
/// \param truth  whose readings the alternative is fitted to
LinearisedAlternative of_motion(const Tangent& truth, const Tangent& alternative, std::size_t motion) {
  std::vector<LinearisedAlternative> blocks;
  Index rows = 0;
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const SegmentMeans& other = alternative[s];
    if (other.log != motion) continue;
    MatrixXd covariance = other.initial * other.initial.transpose();
    covariance.diagonal() += other.variance;
    const Eigen::LLT<MatrixXd> factor(covariance);
    blocks.push_back(
        {factor.matrixL().solve(other.residual - truth[s].residual), factor.matrixL().solve(other.slopes)});
    rows += other.residual.size();
  }
  LinearisedAlternative all{VectorXd(rows), MatrixXd(rows, alternative.front().slopes.cols())};
  Index row = 0;
  for (const LinearisedAlternative& one : blocks) {
    all.difference.segment(row, one.difference.size()) = one.difference;
    all.slope.middleRows(row, one.slope.rows()) = one.slope;
    row += one.difference.size();
  }
  return diagnose::reduced(all);
}

double ratio_of(const Contrast& contrast) {
  std::vector<std::size_t> all(contrast.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return diagnose::expected_log_likelihood_ratio(contrast, all);
}

/// The step of the alternative's parameters to the truth, as far as it is linear.
VectorXd step_to(const Contrast& contrast) {
  LinearisedAlternative all = contrast.front();
  for (std::size_t motion = 1; motion < contrast.size(); ++motion)
    all = diagnose::stacked(all, contrast[motion]);
  return all.slope.colPivHouseholderQr().solve(all.difference);
}

class Comparison {
 public:
  Comparison(const Study& study, const std::function<void(double)>& progress)
      : study_(study), nominal_(tangent({})) {
    for (const Row& row : study.rows()) {
      if (progress) progress(static_cast<double>(tangents_.size()) / static_cast<double>(size()));
      tangents_.push_back(tangent({{&row}}));
      gaps_.push_back(contrast(tangents_.back(), {}, nominal_, 0));
    }
  }

  [[nodiscard]] std::size_t size() const { return study_.rows().size(); }
  [[nodiscard]] const Row& row(std::size_t i) const { return study_.rows()[i]; }
  [[nodiscard]] const Contrast& gap(std::size_t truth) const { return gaps_[truth]; }

  /// Those in which one of the two is the truth and the other competes with it.
  [[nodiscard]] std::vector<Contrast> between(std::size_t i, std::size_t j) const {
    std::vector<Contrast> all;
    for (const auto& [truth, other] : {std::pair{i, j}, {j, i}})
      if (competes(row(truth), row(other)))
        all.push_back(contrast(tangents_[truth], {{&row(other)}}, tangents_[other],
                               may_come_near * ratio_of(gaps_[truth])));
    return all;
  }

 private:
  [[nodiscard]] Tangent tangent(const Candidate& candidate) const {
    const std::vector<Parameter> parameters = study_.parameters(candidate);
    return study_.left(parameters, typical(parameters), study_.rough_begins());
  }
  /// The alternative where it comes nearest to the truth, by Gauss and Newton's steps from its typical size.
  /// \param near  the ratio from which it may come near
  [[nodiscard]] Contrast contrast(const Tangent& truth, const Candidate& candidate, Tangent other,
                                  double near) const {
    constexpr int most_steps = 4;
    const std::vector<Parameter> parameters = study_.parameters(candidate);
    std::vector<double> values = typical(parameters);
    Contrast nearest;
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0; step <= most_steps; ++step) {
      Contrast here;
      for (std::size_t motion = 0; motion < study_.bench().logs.size(); ++motion)
        here.push_back(of_motion(truth, other, motion));
      const double ratio = ratio_of(here), gained = least - ratio;
      if (ratio < least) least = ratio, nearest = here;
      if (least >= near || gained < diagnose::same_readings) break;
      const VectorXd by = step_to(here);
      for (std::size_t p = 0; p < parameters.size(); ++p)
        values[p] = std::clamp(values[p] + by(static_cast<Index>(p)), parameters[p].range.low,
                               parameters[p].range.high);
      other = study_.left(parameters, values, study_.rough_begins());
    }
    return nearest;
  }
  /// What contains the truth, or has more than one parameter more, no reading can rule out.
  static bool competes(const Row& truth, const Row& other) {
    const std::set<Term> own = terms_of(other);
    const std::set<Term> all = terms_of(truth);
    const bool holds = other.refines && std::includes(own.begin(), own.end(), all.begin(), all.end());
    return !holds && other.parameters.size() <= truth.parameters.size() + 1;
  }

  /// The share of the gap below which a tangent may lead to a reproduction.
  static constexpr double may_come_near = 0.3;

  const Study& study_;
  Tangent nominal_;
  std::vector<Tangent> tangents_;
  std::vector<Contrast> gaps_;
};

/// The effects that are seen, and how far each two are apart.
struct Told {
  std::vector<std::size_t> seen;
  std::vector<std::vector<double>> apart;
  std::vector<Contrast> contrasts;  ///< those that tell
  std::size_t pairs = 0;            ///< that are told apart

  explicit Told(const Comparison& effects) {
    for (std::size_t i = 0; i < effects.size(); ++i)
      if (ratio_of(effects.gap(i)) > diagnose::told_apart)
        seen.push_back(i), contrasts.push_back(effects.gap(i));
    apart.assign(effects.size(), std::vector<double>(effects.size(), 0));
    for (const std::size_t i : seen)
      for (const std::size_t j : seen)
        if (j > i) compare(effects, i, j);
  }

  [[nodiscard]] std::vector<std::size_t> near(std::size_t i) const {
    std::vector<std::size_t> all;
    for (const std::size_t j : seen)
      if (apart[i][j] <= diagnose::told_apart) all.push_back(j);
    return all;
  }

 private:
  void compare(const Comparison& effects, std::size_t i, std::size_t j) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Contrast> both = effects.between(i, j);
    for (const Contrast& one : both) least = std::min(least, ratio_of(one));
    apart[i][j] = apart[j][i] = least;
    if (least <= diagnose::told_apart) return;
    ++pairs;
    std::move(both.begin(), both.end(), std::back_inserter(contrasts));
  }
};

/// Effects that have the same ones near them.
std::vector<AlikeEffects> alike(const Comparison& effects, const Told& told) {
  std::vector<AlikeEffects> all;
  std::set<std::size_t> taken;
  for (const std::size_t i : told.seen) {
    const std::vector<std::size_t> near = told.near(i);
    if (near.size() < 2 || taken.count(i) > 0) continue;
    AlikeEffects one;
    double furthest = 0;
    for (const std::size_t j : near) {
      const bool same = told.near(j) == near;
      (same ? one.effects : one.others).push_back(effects.row(j).id);
      if (same) taken.insert(j), furthest = std::max(furthest, told.apart[i][j]);
    }
    one.exactly = one.effects.size() > 1 && furthest < diagnose::same_readings;
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

MotionPlan plan_of(Bench bench, const std::function<void(double)>& progress) {
  const Study study(predicted_bench(std::move(bench)));
  const Comparison effects(study, progress);
  const Told told(effects);
  MotionPlan plan;
  plan.name = study.bench().name;
  plan.motions = study.bench().logs.size();
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (std::find(told.seen.begin(), told.seen.end(), i) == told.seen.end())
      plan.undetectable.push_back(effects.row(i).id);
  plan.indistinguishable = alike(effects, told);
  plan.separated = told.pairs;
  const diagnose::FewestRuns fewest =
      diagnose::fewest_runs(told.contrasts, plan.motions, diagnose::told_apart);
  for (const std::size_t motion : fewest.runs) plan.fewest.push_back(study.bench().logs[motion].name);
  plan.proved_minimal = fewest.proved;
  return plan;
}

}  // namespace plumbline::motion
