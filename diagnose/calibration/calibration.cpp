#include "diagnose/calibration/calibration.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/calibration/columns.hpp"
#include "diagnose/calibration/grouped_regression.hpp"
#include "diagnose/calibration/registration.hpp"
#include "diagnose/calibration/unseen.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {
namespace {

/// The posterior means of the coefficients of a group.
Eigen::VectorXd mean_of(const GroupedFit& fit, const std::vector<ColumnGroup>& groups, std::size_t place) {
  Eigen::Index first = 0;
  for (std::size_t g = 0; g < place; ++g) first += groups[fit.groups[g]].count;
  return fit.mean.segment(first, groups[fit.groups[place]].count);
}

class Calibrator {
 public:
  explicit Calibrator(const Study& study)
      : given_(study.experiment()), experiment_(given_), stated_(study.experiment().stated) {
    tracker_ = Pose<double>::Identity();
  }

  std::shared_ptr<const Calibration> result() {
    if (frames_unknown()) tracker_ = register_frames(experiment_);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      const Study study = present();
      lay_columns(study, round > 0);
      if (!can_be_fitted()) return nullptr;
      const GroupedRegression regression(frame_columns_, all_columns(), groups_, values_);
      fit_ = regression.extended(always_, round > 0 ? offered_ : std::vector<std::size_t>{});
      move();
    }
    const Study study = present();
    lay_columns(study, true);
    return can_be_fitted() ? collected(study) : nullptr;
  }

 private:
  [[nodiscard]] bool frames_unknown() const { return given_.arm_bench.frames == ArmBench::Frames::unknown; }

  /// The study of the arm as it is calibrated so far.
  [[nodiscard]] Study present() const {
    Experiment now = experiment_;
    now.effects.insert(now.effects.end(), random_.begin(), random_.end());
    return Study::as_it_is(std::move(now), stated_);
  }

  void lay_columns(const Study& study, bool causes) {
    frame_columns_ =
        frames_unknown() ? columns_of_frames(study) : Eigen::MatrixXd(study.measurements().size(), 0);
    random_columns_ = random_columns(study);
    groups_.clear(), always_.clear(), offered_.clear();
    for (const ColumnGroup& one : random_columns_.groups) {
      always_.push_back(groups_.size());
      groups_.push_back(one);
    }
    cause_columns_ = causes ? columns_of_causes(study) : EffectColumns{};
    const Eigen::Index behind = random_columns_.columns.cols();
    for (const ColumnGroup& one : cause_columns_.groups) {
      offered_.push_back(groups_.size());
      groups_.push_back({behind + one.first, one.count});
    }
    if (random_mean_.size() == 0) random_mean_.setZero(behind);
    values_ = study.nominal_residual();
    if (random_mean_.size() == behind) values_ += random_columns_.columns * random_mean_;
  }

  /// Whether there are more readings than frames need, and an arm that holds its poses.
  [[nodiscard]] bool can_be_fitted() const {
    return values_.size() > frame_columns_.cols() + 3 && values_.allFinite() && frame_columns_.allFinite() &&
           random_mean_.size() > 0 && random_mean_.size() == random_columns_.columns.cols() &&
           random_columns_.columns.allFinite();
  }

  [[nodiscard]] Eigen::MatrixXd all_columns() const {
    Eigen::MatrixXd all(values_.size(), random_columns_.columns.cols() + cause_columns_.columns.cols());
    all.leftCols(random_columns_.columns.cols()) = random_columns_.columns;
    if (cause_columns_.columns.cols() > 0)
      all.rightCols(cause_columns_.columns.cols()) = cause_columns_.columns;
    return all;
  }

  /// Coefficients of all columns, zero of those that are not in the fit.
  [[nodiscard]] Eigen::VectorXd coefficients() const {
    Eigen::VectorXd all =
        Eigen::VectorXd::Zero(random_columns_.columns.cols() + cause_columns_.columns.cols());
    for (std::size_t g = 0; g < fit_.groups.size(); ++g)
      all.segment(groups_[fit_.groups[g]].first, groups_[fit_.groups[g]].count) = mean_of(fit_, groups_, g);
    return all;
  }

  /// Takes over the posterior mean: the random effects into the arm, the frames into the readings.
  void move() {
    const Eigen::VectorXd found = coefficients();
    random_mean_ = random_columns_.clamped(found.head(random_columns_.columns.cols()));
    random_ = random_columns_.at(random_mean_);
    if (frame_columns_.cols() == 0) return;
    const Eigen::VectorXd step =
        LeastSquares(frame_columns_).solve(Eigen::VectorXd(values_ - all_columns() * found));
    tracker_ = tracker_ * move_frames(experiment_, step);
  }

  [[nodiscard]] std::vector<SolvedFrame> solved_frames() const {
    if (!frames_unknown()) return {};
    return solved(experiment_, tracker_, frame_columns_, random_columns_.columns, sizes_by_column(),
                  fit_.noise);
  }

  [[nodiscard]] Eigen::VectorXd sizes_by_column() const {
    Eigen::VectorXd size(random_columns_.columns.cols());
    for (std::size_t g = 0; g < random_columns_.groups.size(); ++g)
      size.segment(random_columns_.groups[g].first, random_columns_.groups[g].count)
          .setConstant(fit_.size[g]);
    return size;
  }

  std::shared_ptr<const Calibration> collected(const Study& study) {
    const GroupedRegression regression(frame_columns_, all_columns(), groups_, values_);
    fit_ = regression.extended(always_, offered_);
    auto all = std::make_shared<Calibration>();
    all->experiment = study.experiment();
    all->random_effects = random_.size();
    all->noise = fit_.noise;
    all->whitening =
        Whitening(frame_columns_, random_columns_.columns * sizes_by_column().asDiagonal() / fit_.noise);
    all->frames = solved_frames();
    for (std::size_t g = 0; g < random_columns_.groups.size(); ++g)
      all->sizes.push_back(random_columns_.size_of(g, fit_.size[g]));
    for (std::size_t g = random_columns_.groups.size(); g < fit_.groups.size(); ++g)
      all->beside.push_back(
          cause_columns_.effect(fit_.groups[g] - random_columns_.groups.size(), mean_of(fit_, groups_, g)));
    all->imitate = cause_columns_.within(frame_columns_);
    const Eigen::MatrixXd columns = all_columns();
    const UnseenTest test{study, frame_columns_, columns, groups_, always_, offered_, values_};
    all->nominal = test.nominal(), all->least_squares = test.least_squares(),
    all->corrected = test.corrected();
    return all;
  }

  const Experiment& given_;
  Experiment experiment_;
  std::shared_ptr<const std::vector<Effect>> stated_;
  Pose<double> tracker_;
  std::vector<NominalEffect> random_;
  Eigen::VectorXd random_mean_;
  Eigen::MatrixXd frame_columns_;
  EffectColumns random_columns_, cause_columns_;
  std::vector<ColumnGroup> groups_;
  std::vector<std::size_t> always_, offered_;
  Eigen::VectorXd values_;
  GroupedFit fit_;
};

}  // namespace

std::shared_ptr<const Calibration> calibrated(const Study& study) {
  return Calibrator(study).result();
}

}  // namespace plumbline::diagnose
