#include "diagnose/decision/cross_validation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "diagnose/decision/smooth_forecast.hpp"
#include "diagnose/inference/start.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Experiment four_presses() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  press(experiment, {-0.2, -0.5, 0.4}, {-0.06, 0.02}, 20, true);
  press(experiment, {0.2, 0.5, -0.4}, {-0.04, 0}, 20, true);
  press(experiment, {0.2, -0.3, -0.4}, {0, -0.05}, 20, true);
  return experiment;
}

/// One hypothesis, fitted to all readings.
struct Fitted {
  const Study& study;
  NoiseEstimate noise = declared_noise(study);
  Findings findings;
  Hypothesis whole;

  Fitted(const Study& of, const Candidate& candidate) : study(of) {
    findings.states = std::make_shared<const CommandStates>(study.experiment());
    findings.likelihood = std::make_shared<const Likelihood>(
        study.measurements(), *findings.states, full_model(), noise.shape, study.nominal_residual());
    whole = maximised(study, *findings.likelihood, candidate, initial_guesses(study, candidate),
                      Effort{50, 1e-3});
    REQUIRE(whole.converged);
  }
};

std::optional<Shrink> shrink_of(const Study& study, const Candidate& candidate) {
  const Fitted fitted(study, candidate);
  return cross_validated(study, fitted.findings, fitted.noise, fitted.whole);
}

bool is_of_blocks(const Shrink& shrink) {
  return std::all_of(shrink.heldout.begin(), shrink.heldout.end(),
                     [](const std::string& name) { return name.find('[') != std::string::npos; });
}

}  // namespace

TEST_CASE("every run that another is like is held out once, in whatever order they stand") {
  Experiment experiment = four_presses();
  press(experiment, {0.2, -0.3, -0.4}, {0, -0.05}, 20, false);  // the only one that does not come back
  std::vector<std::string> names;
  for (int turn = 0; turn < 5; ++turn) {
    std::vector<std::string> now;
    for (const HeldOut& part : run_parts(experiment)) {
      now.insert(now.end(), part.names.begin(), part.names.end());
      for (std::size_t r = 0; r < 5; ++r)
        CHECK(part.reading[r][0] ==
              (std::count(part.names.begin(), part.names.end(), experiment.runs[r].id) == 1));
    }
    if (turn == 0) names = now;
    CHECK(now == names);
    std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
  }
  CHECK(std::set<std::string>(names.begin(), names.end()) ==
        std::set<std::string>{"press-1", "press-2", "press-3", "press-4"});
  CHECK(names.size() == 4);
}

TEST_CASE("no reading is held out in two parts, and none at the ends of a run in blocks") {
  const Experiment experiment = four_presses();
  for (const auto& parts : {run_parts(experiment), block_parts(experiment)}) {
    HeldOut all = nothing_held(experiment);
    for (const HeldOut& part : parts)
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t i = 0; i < part.reading[r].size(); ++i) {
          CHECK_FALSE((all.reading[r][i] && part.reading[r][i]));
          all.reading[r][i] = all.reading[r][i] || part.reading[r][i];
        }
  }
  for (const HeldOut& part : block_parts(experiment))
    for (const std::vector<bool>& run : part.reading) CHECK_FALSE((run.front() || run.back()));
}

TEST_CASE("what is fitted without a part never sees it, and is measured on it alone") {
  const Experiment experiment = measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3);
  const Study study(experiment);
  NoiseEstimate noise = declared_noise(study);
  noise.shape.outlier[5] = true;
  noise.shape.relative(study.nominal_residual().size() - 1) = 7;
  // Each part's prediction is off by a size of its own, everywhere.
  double size = 1, squares = 0, values = 0;
  int outliers_seen = 0, noisier_seen = 0, parts = 0;
  std::mutex one_at_a_time;
  const auto blind = [&](const Study& seen, const NoiseEstimate& noise_seen, const HeldOut& part) {
    const std::scoped_lock lock(one_at_a_time);
    ++parts;
    const std::vector<ReadingPlace>& places = study.measurements().places();
    for (std::size_t i = 0; i < places.size(); ++i)
      if (part.reading[places[i].run][places[i].reading] && !noise.shape.outlier[i])
        squares += std::pow(size / noise.shape.relative(static_cast<Eigen::Index>(i)), 2), values += 1;
    CHECK(noise_seen.shape.outlier.size() == seen.measurements().size());
    for (const bool one : noise_seen.shape.outlier) outliers_seen += one ? 1 : 0;
    for (const double one : noise_seen.shape.relative) noisier_seen += one == 7 ? 1 : 0;
    for (const Run& run : seen.experiment().runs)
      for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        if (experiment.runs[r].id != run.id) continue;
        for (std::size_t i = 0; i < run.readings.size(); ++i)
          if (part.reading[r][i]) CHECK(std::isnan(run.readings[i][column_Fx]));
      }
    return std::optional(VectorXd(VectorXd::Constant(study.nominal_residual().size(), size++)));
  };
  const auto found = cross_validated(study, noise, blind);
  REQUIRE(found);
  REQUIRE(parts == 4);
  // Every reading is seen by all parts but its own.
  CHECK(outliers_seen == 3);
  CHECK(noisier_seen == 3);
  CHECK(found->outliers == 1);
  CHECK(found->chi2_per_value_after == close_to(squares / values));
}

TEST_CASE("a part of which the others do not tell is passed over; blocks stand in where no run is told of") {
  const Experiment experiment = measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3);
  const Study study(experiment);
  NoiseEstimate noise = declared_noise(study);
  // Half of the gap is left of what is asked for, but for parts that `passed` names.
  const auto halved = [&](const std::function<bool(const HeldOut&)>& passed) {
    return cross_validated(
        study, noise,
        [&](const Study&, const NoiseEstimate&, const HeldOut& part) -> std::optional<VectorXd> {
          if (passed(part)) return std::nullopt;
          return study.nominal_residual() / 2;
        });
  };
  const auto of_runs = [](const HeldOut& part) { return part.names.front().find('[') == std::string::npos; };
  // The same of all these readings at once.
  const auto agrees = [&](const std::optional<Shrink>& found, const std::vector<HeldOut>& parts) {
    REQUIRE(found);
    HeldOut all = nothing_held(experiment);
    for (const HeldOut& part : parts) {
      all.names.insert(all.names.end(), part.names.begin(), part.names.end());
      for (std::size_t r = 0; r < part.reading.size(); ++r)
        for (std::size_t i = 0; i < part.reading[r].size(); ++i)
          if (part.reading[r][i]) all.reading[r][i] = true;
    }
    const Shrink expected = measure_shrink(study.measurements(), all, study.nominal_residual(),
                                           study.nominal_residual() / 2, noise);
    CHECK(found->heldout == expected.heldout);
    CHECK(found->ratio == close_to(0.5));
    CHECK(found->chi2_per_value_after == close_to(expected.chi2_per_value_after));
    CHECK(found->noise_floor_ratio == close_to(expected.noise_floor_ratio));
  };
  const auto is_second = [](const HeldOut& part) { return part.names.front() == "press-2"; };
  std::vector<HeldOut> runs = run_parts(experiment);
  agrees(halved([](const HeldOut&) { return false; }), runs);
  std::erase_if(runs, is_second);
  REQUIRE(runs.size() == 3);
  agrees(halved(is_second), runs);
  agrees(halved(of_runs), block_parts(experiment));
  CHECK_FALSE(halved([](const HeldOut&) { return true; }));

  // Where neither carries a gap what was asked first is said, of the runs.
  for (ChannelNoise& one : noise.channels) one.scale = 1e4;
  agrees(halved([](const HeldOut&) { return false; }), run_parts(experiment));
  // A run of seven readings has no eighths, and a single one no other.
  const Study few(blank_experiment({7}));
  CHECK_FALSE(
      cross_validated(few, declared_noise(few),
                      [](const Study&, const NoiseEstimate&, const HeldOut&) -> std::optional<VectorXd> {
                        FAIL("nothing is held out");
                        return std::nullopt;
                      }));
}

TEST_CASE("what a block holds out of one way, a run that comes back shows on the other") {
  for (const auto& turns : {std::vector<double>{0, 1, 0}, {0, 1, -1, 0}}) {
    // 64 steps, as many a unit of the way
    double whole = 0;
    for (std::size_t leg = 1; leg < turns.size(); ++leg) whole += std::abs(turns[leg] - turns[leg - 1]);
    Experiment experiment = blank_experiment({65});
    std::vector<Reading>& readings = experiment.runs[0].readings;
    const double step = whole / 64;
    double place = turns[0];
    for (std::size_t i = 0, leg = 1; i < readings.size(); ++i) {
      readings[i][column_x] = 0.3 + 0.01 * place;
      if (leg < turns.size() && std::abs(turns[leg] - place) < step / 2) ++leg;
      if (leg < turns.size()) place += std::copysign(step, turns[leg] - place);
    }
    const std::vector<HeldOut> parts = block_parts(experiment);
    REQUIRE(parts.size() == 3);
    for (const HeldOut& part : parts) {
      const std::vector<bool>& held = part.reading[0];
      std::size_t alone = 0;
      for (std::size_t i = 0; i < readings.size(); ++i) {
        if (!held[i]) continue;
        bool seen = false;
        for (std::size_t other = 0; other < readings.size(); ++other)
          seen = seen ||
                 (!held[other] && std::abs(readings[other][column_x] - readings[i][column_x]) < 0.011 * step);
        alone += !seen;
      }
      CHECK(alone == 0);
    }
  }
}

TEST_CASE("a true cause predicts to the noise, a wrong one surely no better than the nominal model") {
  const Study study(measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3));
  const auto right = shrink_of(study, only("joint_stiffness", 2));
  REQUIRE(right);
  CHECK(right->heldout.size() == 4);
  CHECK(right->tested());
  CHECK(right->ratio < 1.1 * right->noise_floor_ratio);
  CHECK_FALSE(right->fails());
  const auto wrong = shrink_of(study, only("sensor_drift"));
  REQUIRE(wrong);
  CHECK(wrong->ratio_low >= 1);
}

// A run of another unloaded shape is told by no smooth function of the others' commands, and by the cause.
TEST_CASE("a true cause says more of unseen readings than a smooth function does, a stand-in does not") {
  const Study study(measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3));
  const auto gain_of = [&](const Candidate& candidate) {
    const Fitted fitted(study, candidate);
    return gain_over_smooth(study, fitted.findings, fitted.noise, fitted.whole);
  };
  const auto right = gain_of(only("joint_stiffness", 2)), stand_in = gain_of(only("sensor_drift"));
  REQUIRE(right);
  CHECK(right->ratio_high < 1);
  REQUIRE(stand_in);
  CHECK(stand_in->ratio_high >= 1);
}

TEST_CASE("a run's own tare is tested on blocks of the run: no other run determines it") {
  const Experiment experiment = four_presses();
  const EffectAt tare{"run_tare", 0};
  const Study bare(experiment);
  std::vector<double> values(bare.ranges(tare).size(), 0.0);
  for (std::size_t p = 0; p < values.size(); ++p)
    values[p] = (p % 2 == 0 ? 1 : -1) * bare.ranges(tare)[p].scale;
  const Study study(measured(experiment, {{tare}}, values, 4));
  const auto found = shrink_of(study, {{tare}});
  REQUIRE(found);
  CHECK(is_of_blocks(*found));
  CHECK(found->ratio < 1.2 * found->noise_floor_ratio);
}

TEST_CASE("where the runs that can be spared carry no gap, blocks are held out") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-1e-4, 0}, 20, true);
  press(experiment, {-0.2, -0.5, 0.4}, {0, -1e-4}, 20, true);
  load(experiment, {0.2, 0.5, -0.4}, {0, 0}, {-2, 0}, 30);
  const Candidate truth = only("joint_stiffness", 2);
  const auto found = shrink_of(Study(measured(experiment, truth, {0.2}, 3)), truth);
  REQUIRE(found);
  CHECK(is_of_blocks(*found));
  CHECK(found->tested());
  CHECK(found->ratio < 1.2 * found->noise_floor_ratio);

  // Where no block carries a gap either, nothing is tested.
  const auto untested = shrink_of(Study(measured(experiment, truth, {0}, 4)), truth);
  if (untested) CHECK_FALSE(untested->tested());
}
