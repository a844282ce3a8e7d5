#include "diagnose/design/next_run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/design/separation.hpp"
#include "diagnose/inference/white_noise_fit.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Presses along x alone: what such a rig most often does.
Experiment along_x() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 25, false);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0}, 25, false);
  return experiment;
}

}  // namespace

TEST_CASE("a weight at the tip and a tare error are equivalent until the rig is turned out of gravity") {
  const Study study(measured(along_x(), only("tip_payload"), {0.3}, 37));
  const NoiseEstimate noise = declared_noise(study);
  const Hypothesis payload = fit_in_white_noise(study, only("tip_payload")),
                   bias = fit_in_white_noise(study, only("force_bias"));
  // The tare error imitates the weight exactly; the weight misses what noise gives b_x: one free parameter,
  // whose squared distance is a chi-square of one degree of freedom, below 11 in 999 of 1000 experiments.
  CHECK(separation(linearised_alternative(study.measurements(), noise, payload, bias)) < 1e-6);
  CHECK(separation(linearised_alternative(study.measurements(), noise, bias, payload)) < 11);

  const std::vector<Proposal> proposals = next_runs(study, {payload, bias}, noise, 4);
  REQUIRE(proposals.size() == 4);
  for (const Proposal& one : proposals) {
    CHECK(one.out_of_gravity);
    CHECK(one.log_odds > 10);
    CHECK(one.log_odds_so_far < 6);
    CHECK(one.log_odds >= 0.9 * proposals.back().log_odds);
  }
}

TEST_CASE("the predicted log-likelihood ratio of a proposal is that of its run") {
  const Candidate truth = only("rest_angle", 1), hypothesis = only("joint_stiffness", 2);
  const Study first(measured(along_x(), truth, {0.004}, 41));
  const Proposal best =
      next_runs(first, {fit_in_white_noise(first, truth), fit_in_white_noise(first, hypothesis)},
                declared_noise(first), 1)
          .at(0);

  Experiment longer = along_x();
  longer.runs.push_back(best.run);
  for (Reading& reading : longer.runs.back().readings)
    reading[column_q] = reading[column_q + 1] = reading[column_q + 2] = 0;
  // Averaged over what noise does to one run; the lead scatters by the root of twice its mean.
  double sum = 0;
  constexpr unsigned repeats = 20;
  for (unsigned seed = 0; seed < repeats; ++seed) {
    const Experiment again = measured(longer, truth, {0.004}, 100 + seed);
    const Study study(again);
    sum += (fit_in_white_noise(study, hypothesis).residual.squaredNorm() -
            fit_in_white_noise(study, truth).residual.squaredNorm()) /
           2;
  }
  const double lead = sum / repeats;
  CHECK(lead > best.log_odds_so_far);
  CHECK(lead == close_to(best.log_odds).epsilon(0.35));
}

TEST_CASE("proposals respect the limits of the rig") {
  const Study study(measured(along_x(), only("force_gain"), {0.05}, 43));
  const Hypothesis gain = fit_in_white_noise(study, only("force_gain")),
                   stiff = fit_in_white_noise(study, only("joint_stiffness", 1));
  double force = 0, needed = 0;
  for (const Trace& trace : study.nominal().runs)
    force = std::max(force, trace.col(column_Fx).abs().maxCoeff());
  for (const Proposal& one : next_runs(study, {gain, stiff}, declared_noise(study), 1000)) {
    Experiment bench = study.experiment();
    bench.runs = {one.run};
    const Prediction predicted = predict(Study(bench), gain.candidate, gain.parameters);
    REQUIRE(predicted.reached);
    needed = std::max(needed, predicted.runs[0].col(column_Fx).abs().maxCoeff());
  }
  CHECK(needed > 0);
  CHECK(needed < 2.2 * force);
}

TEST_CASE("no run with a snap under some hypothesis is proposed") {
  // nearly straight, and bent more than was believed: pushed farther it snaps through, which
  // would tell more than any run that is proposed
  Experiment experiment = three_links();
  press(experiment, {0.118, 0.046, 0.061}, {-0.053, -0.05}, 20, false);
  const Study study(measured(experiment, only("rest_angle", 2), {0.099}, 43));
  const std::vector<Hypothesis> hypotheses{fit_in_white_noise(study, only("joint_stiffness", 2)),
                                           fit_in_white_noise(study, only("rest_angle", 2))};
  const auto snaps = [&](const Run& run) {
    Experiment bench = study.experiment();
    bench.runs = {run};
    return std::any_of(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& one) {
      return predict(Study(bench), one.candidate, one.parameters).snapped;
    });
  };
  std::size_t feasible = 0;
  for (const Shape& shape : shapes(study.experiment(), 12))
    for (const CandidateRun& one : runs_from(study.experiment(), shape, operating_envelope(study)))
      feasible += snaps(one.run);
  REQUIRE(feasible > 0);
  const std::vector<Proposal> proposals = next_runs(study, hypotheses, declared_noise(study), 1000);
  REQUIRE_FALSE(proposals.empty());
  for (const Proposal& one : proposals) CHECK_FALSE(snaps(one.run));
}

TEST_CASE("a proposal's gap is the distance of the best hypothesis from the nominal model, and comes first") {
  const Study study(measured(along_x(), only("rest_angle", 1), {0.004}, 41));
  NoiseEstimate noise = declared_noise(study);
  noise_of(noise, Channel(Channel::Name::Fx)).scale = 2;
  noise_of(noise, Channel(Channel::Name::Fy)).scale = 0.5;
  const std::vector<Hypothesis> hypotheses{fit_in_white_noise(study, only("rest_angle", 1)),
                                           fit_in_white_noise(study, only("joint_stiffness", 2))};
  const auto gap_of = [&](const Proposal& one) {
    Experiment bench = study.experiment();
    bench.runs = {one.run};
    bench.gravity = {0, 0};
    const Study alone(bench);
    const Trace best = predict(alone, hypotheses[0].candidate, hypotheses[0].parameters).runs[0],
                nominal = alone.nominal().runs[0];
    double sum = 0, count = 0;
    for (Eigen::Index i = 0; i < best.rows(); ++i) {
      sum +=
          std::pow((best(i, column_Fx) - nominal(i, column_Fx)) / (2 * bench.noise[Channel::Name::Fx]), 2) +
          std::pow((best(i, column_Fy) - nominal(i, column_Fy)) / (0.5 * bench.noise[Channel::Name::Fy]), 2);
      count += 2;
      for (std::size_t j = 0; one.angles && j < 3; ++j, ++count)
        sum += std::pow((angle(best, i, j) - angle(nominal, i, j)) / bench.noise[Channel::Name::q], 2);
    }
    return std::sqrt(sum / count);
  };
  const auto key = [](const Proposal& one) { return one.description; };
  std::map<std::string, double> told;
  for (const Proposal& one : next_runs(study, hypotheses, noise, 1000)) {
    CHECK(one.gap == close_to(gap_of(one)).epsilon(1e-6));
    told[key(one)] = one.gap;
  }
  const std::vector<Proposal> shown = next_runs(study, hypotheses, noise, 1000, Aim::detect);
  REQUIRE(shown.size() == told.size());
  double most = 0;
  for (const auto& [what, gap] : told) most = std::max(most, gap);
  // grades are a quarter of a factor e wide, and two sigmas are clear
  CHECK(std::min(shown.front().gap, 2.0) > std::min(most, 2.0) * std::exp(-0.25));
  for (std::size_t i = 1; i < shown.size(); ++i)
    CHECK(std::min(shown[i].gap, 2.0) < std::min(shown[i - 1].gap, 2.0) * std::exp(0.25) + 1e-4);
}

TEST_CASE("mirrored runs are equally informative without gravity, not with it") {
  Experiment experiment = along_x();
  experiment.link_mass = {0.05, 0.05, 0.05};
  experiment.gravity = {0, -9.81};
  const Study study(measured(experiment, only("force_gain"), {0.1}, 43));
  const std::vector<Hypothesis> hypotheses{fit_in_white_noise(study, only("force_gain")),
                                           fit_in_white_noise(study, only("stiffness_scale"))};
  std::map<std::pair<bool, std::string>, std::vector<double>> promised;
  for (const Proposal& one : next_runs(study, hypotheses, declared_noise(study), 1000)) {
    std::string what = one.description;
    if (const std::size_t at = what.find("mirrored "); at != what.npos) what.erase(at, 9);
    promised[{one.out_of_gravity, what}].push_back(one.log_odds);
  }
  REQUIRE_FALSE(promised.empty());
  for (const auto& [which, odds] : promised) {
    CAPTURE(which.second);
    REQUIRE(odds.size() == 2);
    CHECK((odds[0] == close_to(odds[1]).epsilon(1e-6)) == which.first);
  }
}

TEST_CASE("joint angles are suggested only where the bench does not read them") {
  for (const bool reads : {true, false}) {
    CAPTURE(reads);
    Experiment experiment = along_x();
    if (!reads)
      for (Run& run : experiment.runs)
        for (Reading& reading : run.readings) reading.value.resize(column_q);
    const Study study(measured(experiment, only("force_gain"), {0.05}, 43));
    const std::vector<Hypothesis> hypotheses{fit_in_white_noise(study, only("force_gain")),
                                             fit_in_white_noise(study, only("joint_stiffness", 1))};
    std::size_t extras = 0;
    const std::vector<Proposal> proposals = next_runs(study, hypotheses, declared_noise(study), 1000);
    REQUIRE_FALSE(proposals.empty());
    for (const Proposal& one : proposals) {
      if (reads) CHECK(one.angles);
      extras += one.description.find("joint angles measured") != std::string::npos;
    }
    CHECK((extras > 0) == !reads);
  }
}

TEST_CASE("no run is proposed to distinguish hypotheses with the same predictions, but to detect the gap") {
  const Study study(measured(along_x(), only("rest_angle", 1), {0.02}, 47));
  const std::vector<Hypothesis> twice(2, fit_in_white_noise(study, only("rest_angle", 1)));
  CHECK(next_runs(study, twice, declared_noise(study), 1000).empty());
  CHECK_FALSE(next_runs(study, twice, declared_noise(study), 1, Aim::detect).empty());
}

TEST_CASE("expected information uses the estimated noise of each channel") {
  // a sigma declared twice as large, or found twice as large as declared, are one and the same noise
  const Experiment experiment = measured(along_x(), only("rest_angle", 1), {0.02}, 47);
  const Study study(experiment);
  const std::vector<Hypothesis> as_found{fit_in_white_noise(study, only("rest_angle", 1)),
                                         fit_in_white_noise(study, only("joint_stiffness", 2))};
  const auto leads = [](const Experiment& declared, const std::vector<Hypothesis>& hypotheses,
                        const auto& change) {
    const Study bench(declared);
    NoiseEstimate noise = declared_noise(bench);
    change(noise);
    std::vector<double> result;
    for (const Proposal& one : next_runs(bench, hypotheses, noise, 1000))
      result.push_back(one.log_odds - one.log_odds_so_far);
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto nothing = [](NoiseEstimate&) {};
  const std::vector<double> plain = leads(experiment, as_found, nothing);
  REQUIRE_FALSE(plain.empty());
  for (const Channel::Name name : {Channel::Name::Fx, Channel::Name::Fy}) {
    Experiment louder = experiment;
    louder.noise[name] *= 2;
    std::vector<Hypothesis> in_louder = as_found;
    for (const Block& block : study.measurements().blocks())
      for (Hypothesis& one : in_louder)
        if (block.channel.name == name) {
          one.residual.segment(block.first, block.count) /= 2;
          one.jacobian.middleRows(block.first, block.count) /= 2;
        }
    const std::vector<double> by_declaration = leads(louder, in_louder, nothing);
    const std::vector<double> by_finding =
        leads(experiment, as_found, [&](NoiseEstimate& found) { noise_of(found, Channel(name)).scale = 2; });
    REQUIRE(by_declaration.size() == plain.size());
    REQUIRE(by_finding.size() == plain.size());
    CHECK(by_finding.back() != close_to(plain.back()).epsilon(1e-3));
    for (std::size_t i = 0; i < plain.size(); ++i)
      CHECK(by_finding[i] == close_to(by_declaration[i]).epsilon(1e-9));
  }
}

TEST_CASE("correlated noise hides slow effects in proposed runs as in made ones") {
  // A difference that hardly changes counts (1 - phi) / (1 + phi) as much, but for the first reading of a
  // run: a quarter at 0.6. Of a press the difference grows on the way, and its steps count more.
  const Experiment experiment = measured(along_x(), only("rest_angle", 1), {0.02}, 47);
  const Study study(experiment);
  const std::vector<Hypothesis> hypotheses{fit_in_white_noise(study, only("rest_angle", 1)),
                                           fit_in_white_noise(study, only("joint_stiffness", 2))};
  const auto most_shown = [&](double correlation) {
    NoiseEstimate noise = declared_noise(study);
    for (ChannelNoise& one : noise.channels) one.correlation = correlation;
    double most = 0;
    for (const Proposal& one : next_runs(study, hypotheses, noise, 1000))
      most = std::max(most, one.log_odds - one.log_odds_so_far);
    return most;
  };
  const double white = most_shown(0), slow = most_shown(0.6);
  CHECK(slow > 0.2 * white);
  CHECK(slow < 0.5 * white);
}
