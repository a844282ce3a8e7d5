#include "diagnose/design/next_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/design/expected_information.hpp"
#include "diagnose/design/separation.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double usual_angle_sigma = 1e-3;  // rad: a common encoder, where no noise is declared

/// The bench with the proposed run alone.
Experiment bench_for(const Experiment& experiment, const Run& run, bool out_of_gravity) {
  Experiment bench = experiment;
  bench.runs = {run};
  bench.runs.front().number = bench.run_count;  // a run number without run-to-run effects
  if (out_of_gravity) {
    bench.gravity = {0, 0};
    bench.bench = {Bench::Plane::vertical, {0, 0}, true};
  }
  return bench;
}

/// The predictions of a run; nothing where a hypothesis or the nominal model cannot follow it within the
/// envelope.
std::optional<std::vector<Prediction>> predictions(const Study& bench,
                                                   const std::vector<Hypothesis>& hypotheses,
                                                   const OperatingEnvelope& so_far) {
  std::vector<Prediction> all;
  if (!bench.nominal().reached) return std::nullopt;  // the run could not be diagnosed
  for (const Hypothesis& hypothesis : hypotheses) {
    all.push_back(predict(bench, hypothesis.candidate, hypothesis.parameters, true));
    const Prediction& one = all.back();
    if (!one.reached || one.snapped || !so_far.allows(one.runs[0], bench.experiment().runs[0]))
      return std::nullopt;
  }
  return all;
}

/// The measured channels of a run that have a noise, with joint angles where they are asked for.
std::vector<Channel> channels_of(const Run& run, const Noise& sigma, bool angles) {
  const std::vector<Channel> measured = run.measured();
  std::vector<Channel> channels = run.measurable();
  std::erase_if(channels, [&](const Channel& one) {
    const bool asked = one.name == Channel::Name::q
                           ? angles
                           : std::find(measured.begin(), measured.end(), one) != measured.end();
    return !asked || !(one.sigma(sigma) > 0);
  });
  return channels;
}

/// The noise that a channel has shown; of one that is not measured yet, the worst of its kind, white.
ChannelNoise noise_of(const NoiseEstimate& noise, const Channel& channel) {
  const bool is_known = std::any_of(noise.channels.begin(), noise.channels.end(),
                                    [&](const ChannelNoise& one) { return one.channel == channel; });
  return is_known ? noise.of(channel) : ChannelNoise{channel, noise.scale_of(channel.name), 0, 1};
}

/// The prediction of a run by a hypothesis, whitened.
Forecast forecast(const Prediction& predicted, const std::vector<Channel>& channels, const Noise& sigma,
                  const NoiseEstimate& noise, const MatrixXd& covariance) {
  const Trace& trace = predicted.runs[0];
  const Eigen::Index rows = trace.rows();
  Forecast result;
  result.covariance = covariance;
  result.read.resize(rows * static_cast<Eigen::Index>(channels.size()));
  result.slope.resize(result.read.size(), static_cast<Eigen::Index>(predicted.sensitivity.size()));
  Eigen::Index at = 0;
  for (const Channel& channel : channels) {
    const Eigen::Index c = channel.column;
    const ChannelNoise found = noise_of(noise, channel);
    const double real = channel.sigma(sigma) * found.scale;
    result.read.segment(at, rows) = innovations(trace.col(c).matrix(), real, found.correlation);
    for (std::size_t p = 0; p < predicted.sensitivity.size(); ++p)
      result.slope.col(static_cast<Eigen::Index>(p)).segment(at, rows) =
          innovations(predicted.sensitivity[p][0].col(c).matrix(), real, found.correlation);
    at += rows;
  }
  return result;
}

/// Root mean square difference of two predictions.
double distance(const Forecast& one, const Forecast& other) {
  return (one.read - other.read).norm() / std::sqrt(static_cast<double>(one.read.size()));
}

/// The rows of the run for a linearised alternative.
LinearisedAlternative rows_of(const Forecast& truth, const Forecast& alternative) {
  return {truth.read - alternative.read, -alternative.slope};
}

/// The expected log odds of the true hypothesis over its best alternative, averaged over the hypotheses.
template <class Rows>
double expected_log_odds(std::size_t hypotheses, Rows rows) {
  double sum = 0;
  for (std::size_t a = 0; a < hypotheses; ++a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < hypotheses; ++b)
      if (a != b) nearest = std::min(nearest, separation(rows(a, b)));
    sum += nearest / 2;
  }
  return sum / static_cast<double>(hypotheses);
}

Noise with_angles(Noise sigma) {
  if (double& q = sigma[Channel::Name::q]; q <= 0) q = usual_angle_sigma;
  return sigma;
}

/// Evaluates one run after the other.
class Planner {
 public:
  Planner(const Study& study, const std::vector<Hypothesis>& hypotheses, const NoiseEstimate& noise)
      : experiment_(study.experiment()),
        noise_(noise),
        so_far_(operating_envelope(study)),
        reads_angles_(study.scales().measures(Channel::Name::q) || study.scales().axes == 1),
        hypotheses_(hypotheses) {
    for (const Hypothesis& hypothesis : hypotheses_) open_.push_back(covariance(study, hypothesis));
    for (const Hypothesis& truth : hypotheses_)
      for (const Hypothesis& alternative : hypotheses_)
        known_.push_back(reduced(linearised_alternative(study.measurements(), noise, truth, alternative)));
    before_ =
        expected_log_odds(hypotheses_.size(), [&](std::size_t a, std::size_t b) { return known(a, b); });
  }

  void add_candidates() {
    constexpr std::size_t shapes = 12;
    for (const CandidateRun& one : candidate_runs(experiment_, shapes, so_far_))
      add(one.description, one.run);
  }

  [[nodiscard]] std::vector<Proposal> best(std::size_t count, Aim aim) {
    constexpr double clear = 2;
    if (aim == Aim::discriminate)
      std::erase_if(proposals_, [](const Proposal& one) { return one.log_odds < same_readings; });
    // Among runs of equal benefit, to a few percent, the least demanding comes first.
    const auto grade = [&](const Proposal& one) {
      const double shown = aim == Aim::detect ? std::min(one.gap, clear) : clear;
      return std::pair(std::lround(4 * std::log(shown + 1e-4)),
                       std::lround(16 * std::log(one.information + 1e-4)));
    };
    std::stable_sort(proposals_.begin(), proposals_.end(),
                     [&](const Proposal& a, const Proposal& b) { return grade(a) > grade(b); });
    std::vector<Proposal> chosen;
    for (const Proposal& one : proposals_) {
      const bool repeated = std::any_of(chosen.begin(), chosen.end(), [&](const Proposal& other) {
        return other.run.control == one.run.control && other.run.rest == one.run.rest &&
               other.angles == one.angles && other.out_of_gravity == one.out_of_gravity;
      });
      if (!repeated && chosen.size() < count) chosen.push_back(one);
    }
    return chosen;
  }

 private:
  [[nodiscard]] const LinearisedAlternative& known(std::size_t a, std::size_t b) const {
    return known_[a * hypotheses_.size() + b];
  }

  void add(const std::string& what, const Run& run) {
    const bool weighs = experiment_.bench.plane != Bench::Plane::horizontal;
    for (const bool out_of_gravity : {false, true}) {
      if (out_of_gravity && (!weighs || experiment_.arm)) continue;
      const Study bench(bench_for(experiment_, run, out_of_gravity));
      const auto all = predictions(bench, hypotheses_, so_far_);
      if (!all) continue;
      for (const bool angles : {false, true}) {
        if (experiment_.arm ? reads_angles_ != angles : reads_angles_ && !angles) continue;
        const std::vector<Forecast> hypotheses = forecasts(*all, run, angles);
        const Forecast nominal = forecasts({bench.nominal()}, run, angles).front();
        if (hypotheses.front().read.size() == 0) continue;
        const double after = expected_log_odds(hypotheses.size(), [&](std::size_t a, std::size_t b) {
          return stacked(known(a, b), rows_of(hypotheses[a], hypotheses[b]));
        });
        proposals_.push_back({what + (out_of_gravity ? ", the rig turned out of gravity" : "") +
                                  (angles && !reads_angles_ ? ", joint angles measured" : ""),
                              run, angles, out_of_gravity, expected_information(hypotheses), after, before_,
                              distance(hypotheses.front(), nominal)});
      }
    }
  }

  [[nodiscard]] std::vector<Forecast> forecasts(const std::vector<Prediction>& predicted, const Run& run,
                                                bool angles) const {
    const Noise sigma = with_angles(experiment_.noise);
    const std::vector<Channel> channels = channels_of(run, sigma, angles);
    std::vector<Forecast> all;
    for (std::size_t r = 0; r < predicted.size(); ++r)
      all.push_back(forecast(predicted[r], channels, sigma, noise_, open_[r]));
    return all;
  }

  const Experiment& experiment_;
  const NoiseEstimate& noise_;
  OperatingEnvelope so_far_;
  bool reads_angles_;  ///< in the experiment so far; a joint alone has no other angles
  const std::vector<Hypothesis>& hypotheses_;
  std::vector<MatrixXd> open_;                ///< covariance of their parameters
  std::vector<LinearisedAlternative> known_;  ///< [truth][alternative]
  double before_ = 0;
  std::vector<Proposal> proposals_;
};

}  // namespace

std::vector<Proposal> next_runs(const Study& study, const std::vector<Hypothesis>& hypotheses,
                                const NoiseEstimate& noise, std::size_t count, Aim aim) {
  Planner planner(study, hypotheses, noise);
  planner.add_candidates();
  return planner.best(count, aim);
}

}  // namespace plumbline::diagnose
