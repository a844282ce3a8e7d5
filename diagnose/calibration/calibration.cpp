#include "diagnose/calibration/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/registration.hpp"
#include "diagnose/bench/sensor_registration.hpp"
#include "diagnose/calibration/columns.hpp"
#include "diagnose/calibration/unseen.hpp"
#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {
namespace {

class Calibrator {
 public:
  explicit Calibrator(const Study& study) : read_(study), experiment_(study.experiment()) {}

  Study result() {
    require_reached();
    require_a_length();
    tracker_ = register_frames(experiment_);
    register_sensors(experiment_);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      fit_at(everything(), round > 0);
      const VectorXd step = LeastSquares(frames_).solve(VectorXd(values_ - effects_.columns * fit_.mean));
      tracker_ = tracker_ * move_frames(experiment_, step);
    }
    fit_at(everything(), true);
    return collected();
  }

 private:
  void require_reached() const {
    if (!read_.nominal().reached)
      throw Error("experiment \"" + read_.experiment().name + "\"",
                  "loads under which the nominal arm does not hold its poses",
                  "joints and links that are stiffer than their loads");
  }

  /// Heights that are all one, as of contacts with a plane, are those of an arm of no size too.
  void require_a_length() const {
    const CharacteristicScales& scales = read_.scales();
    using Name = Channel::Name;
    if (!scales.measures(Name::height) || scales.measures(Name::place) || scales.measures(Name::distance))
      return;
    for (const Channel& channel : experiment_.arm_bench.sensor_channels(experiment_.arm->arm.size())) {
      std::set<double> values;
      for (const Run& run : experiment_.runs)
        for (const Reading& reading : run.readings)
          if (std::isfinite(channel.of(reading))) values.insert(channel.of(reading));
      if (channel.name == Name::height && values.size() > 1) return;
    }
    throw Error("experiment \"" + experiment_.name + "\"", "contacts alone, whose heights are all one",
                "heights that differ, distances or places beside them, or arm.frames = \"known\"");
  }

  /// The arm with means of tolerances, or of these and what sticks out of them.
  [[nodiscard]] Study with(const std::vector<Tolerance>& means) const {
    Experiment now = experiment_;
    for (const Tolerance& one : means)
      if (std::any_of(one.mean.begin(), one.mean.end(), [](double mean) { return mean != 0; }))
        now.effects.push_back(nominal_effect(read_, one));
    return read_.of(std::move(now));
  }

  /// The arm with these means, or with a half of them, a quarter …: a linear fit may bend it farther than it
  /// holds its poses, as the nominal arm does.
  [[nodiscard]] Study held(std::vector<Tolerance>& means) const {
    constexpr int halvings = 10;
    Study study = with(means);
    for (int i = 0; i < halvings && !study.nominal().reached; ++i) {
      for (Tolerance& one : means)
        for (double& mean : one.mean) mean /= 2;
      study = with(means);
    }
    return study;
  }

  [[nodiscard]] std::vector<Tolerance> everything() const {
    std::vector<Tolerance> all = tolerances_;
    all.insert(all.end(), beside_.begin(), beside_.end());
    return all;
  }

  /// Fits to first order about means, and takes over what is found.
  void fit_at(std::vector<Tolerance> means, bool causes) {
    const Study study = held(means);
    frames_ = frame_columns(study);
    effects_ = effect_columns(study);
    values_ =
        study.measurements().residual(study.nominal()) + effects_.columns * effects_.coefficients(means);
    require_enough();
    const GroupedRegression regression(frames_, effects_.columns, effects_.groups, values_);
    fit_ = causes ? regression.extended(effects_.always(), effects_.offered())
                  : regression.fit(effects_.always());
    tolerances_.clear(), beside_.clear();
    for (std::size_t g = 0; g < fit_.groups.size(); ++g) {
      std::vector<Tolerance>& to = fit_.groups[g] < effects_.everywhere ? tolerances_ : beside_;
      for (Tolerance& one : effects_.effects(fit_, g)) to.push_back(std::move(one));
    }
  }

  void require_enough() const {
    constexpr Eigen::Index beside_frames = 3;
    const Eigen::Index unknowns = beside_frames + (frames_.array() != 0).colwise().any().count();
    if (values_.size() <= unknowns)
      throw Error("experiment \"" + experiment_.name + "\"",
                  fmt::format("{} measured values", values_.size()),
                  fmt::format("more than {}, or arm.frames = \"known\"", unknowns));
    if (!values_.allFinite() || effects_.everywhere == 0)
      throw Error("experiment \"" + experiment_.name + "\"", "poses that the calibrated arm does not hold",
                  "joints and links that are stiffer than their loads, or arm.frames = \"known\"");
  }

  Study collected() {
    Experiment calibrated = held(tolerances_).experiment();
    Calibration all;
    all.noise = fit_.noise;
    all.frames = solved(read_.experiment().arm_bench, experiment_, tracker_, frames_, effects_.columns, fit_);
    all.tolerances = tolerances_;
    for (std::size_t g = 0; g < effects_.everywhere; ++g)
      if (constexpr double told = 0.5; fit_.determined[g] > told)
        all.sizes.push_back(effects_.size_of(fit_.groups[g], fit_.size[g]));
    for (const Tolerance& one : beside_) all.beside.push_back(nominal_effect(read_, one));
    const UnseenTest test{read_.measurements(), frames_, effects_, values_};
    all.nominal = test.nominal(), all.least_squares = test.least_squares(), all.corrected = test.corrected();
    calibrated.arm_bench.calibration = std::make_shared<const Calibration>(std::move(all));
    return read_.of(std::move(calibrated));
  }

  const Study& read_;
  Experiment experiment_;  ///< with its readings told in the arm's world
  Pose<double> tracker_ = Pose<double>::Identity();
  MatrixXd frames_;
  EffectColumns effects_;
  VectorXd values_;  ///< what the arm leaves without any of the effects, to first order
  GroupedFit fit_;
  std::vector<Tolerance> tolerances_, beside_;
};

}  // namespace

Study calibrated(const Study& study) {
  if (study.experiment().arm_bench.frames == ArmBench::Frames::known) return study;
  return Calibrator(study).result();
}

}  // namespace plumbline::diagnose
