#include "diagnose/decision/rotation.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "diagnose/report/report.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;
using Json = nlohmann::ordered_json;

namespace {

Experiment four_presses() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  press(experiment, {-0.2, -0.5, 0.4}, {-0.06, 0.02}, 20, true);
  press(experiment, {0.2, 0.5, -0.4}, {-0.04, 0}, 20, true);
  press(experiment, {0.2, -0.3, -0.4}, {0, -0.05}, 20, true);
  return experiment;
}

std::string names(const Json& effects) {
  std::set<std::string> sorted;
  for (const Json& one : effects)
    sorted.insert(one.is_string() ? one.get<std::string>()
                                  : one["id"].get<std::string>() + one["joint"].dump());
  return fmt::format("{}", fmt::join(sorted, " + "));
}

/// What a report says, by what it says it of.
std::map<std::string, Json> said(const Json& report) {
  std::map<std::string, Json> all{{"verdict", report["cause"]["verdict"]},
                                  {"chi2", report["gap"]["chi2_per_dof"]}};
  // Of explanations that are exactly alike either may stand first.
  std::vector<std::string> alike;
  for (const Json& one : report["cause"]["ranking"])
    if (one["probability"] > 0.05) all["probability of " + names(one["effects"])] = one["probability"];
  for (const Json& one : report["cause"]["equivalent"]) alike.push_back(names(one));
  for (const Json& one : report["where"]["runs"])
    all["share of " + one["run"].get<std::string>()] = one["share"];
  for (const Json& one : report["cause"]["effects"]) {
    alike.push_back(one["id"].get<std::string>() +
                    (one["joint"].is_null() ? "" : "(" + one["joint"].dump() + ")"));
    if (report["cause"]["verdict"] == "identified")
      for (const auto& [name, value] : one["parameters"].items()) all[name] = value["value"];
  }
  std::sort(alike.begin(), alike.end());
  all["class"] = alike;
  if (report["shrink"].is_null()) return all;
  for (const char* key :
       {"ratio", "ratio_low", "ratio_high", "noise_floor_ratio", "tested", "of", "selected_without_heldout"})
    all[key] = report["shrink"][key];
  std::vector<std::string> heldout = report["shrink"]["heldout"];
  std::sort(heldout.begin(), heldout.end());
  all["heldout"] = heldout;
  return all;
}

/// What differs by more than the tolerance of fits, whose sums are rounded in another order.
std::string differences(const std::map<std::string, Json>& a, const std::map<std::string, Json>& b) {
  constexpr double close = 0.01;
  std::string all;
  for (const auto& [what, value] : a) {
    const auto other = b.find(what);
    const bool same = other != b.end() &&
                      (value.is_number() ? std::abs(value.get<double>() - other->second.get<double>()) <=
                                               close * std::max(0.1, std::abs(value.get<double>()))
                                         : value == other->second);
    if (!same)
      all +=
          what + " " + value.dump() + " -> " + (other == b.end() ? "nothing" : other->second.dump()) + "\n";
  }
  return all;
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
  // Each part's prediction is off by a size of its own, everywhere.
  double size = 1, squares = 0, values = 0;
  std::mutex one_at_a_time;
  const auto blind = [&](const Study& seen, const HeldOut& part) {
    const std::scoped_lock lock(one_at_a_time);
    for (std::size_t r = 0; r < experiment.runs.size(); ++r)
      for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
        if (!part.reading[r][i]) continue;
        squares += 2 * size * size, values += 2;  // Fx and Fy
      }
    for (const Run& run : seen.experiment().runs)
      for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        if (experiment.runs[r].id != run.id) continue;
        for (std::size_t i = 0; i < run.readings.size(); ++i)
          if (part.reading[r][i]) CHECK(std::isnan(run.readings[i].Fx));
      }
    return std::optional(std::vector<double>(study.measurements().size(), size++));
  };
  const auto found = rotated(study, {}, blind);
  REQUIRE(found);
  CHECK(found->parts.size() > 1);
  CHECK(found->shrink.chi2_per_value_after == close_to(squares / values));
}

TEST_CASE("a part of which the others do not tell is passed over; blocks stand in where no run is told of") {
  const Experiment experiment = measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3);
  const Study study(experiment);
  NoiseModel noise;
  noise.scale = {1, 1, 2, 3, 1.5};
  noise.correlation.fill(0.4);
  // Half of the gap is left of what is asked for, but for parts that `passed` names.
  const auto halved = [&](const std::function<bool(const HeldOut&)>& passed) {
    return rotated(study, noise,
                   [&](const Study&, const HeldOut& part) -> std::optional<std::vector<double>> {
                     if (passed(part)) return std::nullopt;
                     std::vector<double> left = study.nominal_residual();
                     for (double& one : left) one /= 2;
                     return left;
                   });
  };
  const auto is = [](const HeldOut& part, const std::string& name) {
    return std::find(part.names.begin(), part.names.end(), name) != part.names.end();
  };
  const auto of_runs = [](const HeldOut& part) { return part.names.front().find('[') == std::string::npos; };
  // The same of all these readings at once.
  const auto expected = [&](const std::vector<HeldOut>& parts) {
    HeldOut all = nothing_held(experiment);
    std::vector<double> after = study.nominal_residual();
    for (const HeldOut& part : parts) {
      all.names.insert(all.names.end(), part.names.begin(), part.names.end());
      for (const Series& series : study.measurements().series())
        for (std::size_t i = 0; i < series.readings.size(); ++i)
          if (part.reading[series.run][series.readings[i]]) {
            all.reading[series.run][series.readings[i]] = true;
            after[series.first + i] /= 2;
          }
    }
    return measure_shrink(study.measurements(), all, study.nominal_residual(), after, noise);
  };
  const auto agree = [&](const std::optional<Rotated>& found, std::vector<HeldOut> parts) {
    REQUIRE(found);
    REQUIRE(found->parts.size() == parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) {
      CHECK(found->parts[p].names == parts[p].names);
      CHECK(found->parts[p].reading == parts[p].reading);
    }
    const Shrink shrink = expected(parts);
    CHECK(found->shrink.heldout == shrink.heldout);
    CHECK(found->shrink.ratio == shrink.ratio);
    CHECK(found->shrink.ratio < 0.51);  // outliers are told by what is left, of which there may be others
    CHECK(found->shrink.chi2_per_value_after == shrink.chi2_per_value_after);
    CHECK(found->shrink.noise_floor_ratio == shrink.noise_floor_ratio);
    CHECK(found->shrink.independent == shrink.independent);
  };
  std::vector<HeldOut> runs = run_parts(experiment);
  agree(halved([](const HeldOut&) { return false; }), runs);
  std::erase_if(runs, [&](const HeldOut& part) { return is(part, "press-2"); });
  REQUIRE(runs.size() == 3);
  agree(halved([&](const HeldOut& part) { return is(part, "press-2"); }), runs);
  agree(halved(of_runs), block_parts(experiment));
  CHECK_FALSE(halved([](const HeldOut&) { return true; }));

  // Where neither carries a gap what was asked first is said, of the runs.
  noise.scale.fill(1e4);
  agree(halved([](const HeldOut&) { return false; }), run_parts(experiment));
  // A run of seven readings has no eighths, and a single one no other.
  const Study few(blank_experiment({7}));
  CHECK_FALSE(rotated(few, noise, [](const Study&, const HeldOut&) -> std::optional<std::vector<double>> {
    FAIL("nothing is held out");
    return std::nullopt;
  }));
}

TEST_CASE(
    "the others tell of a run where its open tare spreads the prediction by half of the noise or less") {
  const Experiment bare = measured(four_presses(), {}, {}, 3);  // sizes go by what is read
  const EffectAt tare{"run_tare", 0};
  const double sizeable = Study(bare).ranges(tare)[0].scale, sigma = bare.noise.Fx;
  REQUIRE(bare.noise.Fy == sigma);
  std::vector<double> values(8);
  for (std::size_t p = 0; p < 8; ++p) values[p] = p % 3 == 0 ? 5 * sizeable : -5 * sizeable;
  const Study study(measured(bare, {{tare}}, values, 4));
  // The tare shifts two of the five channels by itself, and no run but its own tells it: its prior leaves it
  // open by a width that goes with the forces of the others. The mean of the variances is
  // 2/5 width^2 / (sigma scale)^2, a half of the noise where the scale is sqrt(4/5) width / sigma.
  std::map<std::string, double> equal;
  for (const HeldOut& part : run_parts(study.experiment())) {
    const Study others = study.of(without(study.experiment(), part));
    const double width =
        std::sqrt(std::acos(-1.0) / 2) * others.ranges(tare)[0].scale;  // of a Cauchy density
    equal[part.names.at(0)] = width / sigma * std::sqrt(0.8);
  }
  REQUIRE(equal.size() == 4);
  for (const auto& [limit, at] : equal)
    for (const double share : {0.999, 1.001}) {
      CAPTURE(limit);
      CAPTURE(share);
      NoiseModel noise;
      noise.scale.fill(share * at);
      FitSettings settings;
      settings.noise = noise;
      std::set<std::string> expected;
      for (const auto& [name, scale] : equal)
        if (scale < share * at) expected.insert(name);
      const auto found = rotated(study, fit(study, {{tare}}, settings), noise, noise);
      REQUIRE(found);
      CHECK(found->shrink.tested());  // five widths are more than three times this noise
      std::set<std::string> names(found->shrink.heldout.begin(), found->shrink.heldout.end());
      if (expected.empty()) {
        for (const std::string& name : names) CHECK(name.find('[') != std::string::npos);
      } else {
        CHECK(names == expected);
      }
    }
}

TEST_CASE("the open spread is the mean over all readings held out, as each channel answers to what is open") {
  const EffectAt rests{"run_rest", 0};
  std::vector<double> values;
  for (int p = 0; p < 12; ++p) values.push_back(p % 2 == 0 ? 0.15 : -0.15);
  const Study study(measured(four_presses(), {{rests}}, values, 4));
  const std::vector<ParameterRange> ranges = study.ranges(rests);
  REQUIRE(ranges.size() == 12);
  // What no run tells keeps the prior, nothing give or take a tolerance, each by itself: a reading's variance
  // is the sum of the squares of its slopes there. Those of other runs' angles are zero.
  const std::vector<double> nothing(12, 0.0);
  const Prediction at_rest = predict(study, {{rests}}, nothing, true);
  std::vector<std::pair<double, std::string>> equal;  // scale of noise where the mean is a half of it
  for (const HeldOut& part : run_parts(study.experiment())) {
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < 12; ++p) {
      REQUIRE(ranges[p].tolerance > 0);
      const std::vector<double> slopes = study.measurements().in_sigmas(at_rest.sensitivity[p]);
      for (const Series& series : study.measurements().series())
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          if (!part.reading[series.run][series.readings[i]]) continue;
          sum += std::pow(ranges[p].tolerance * slopes[series.first + i], 2);
          count += p == 0 ? 1 : 0;
        }
    }
    equal.emplace_back(std::sqrt(2 * sum / count), part.names.at(0));
  }
  std::sort(equal.begin(), equal.end());
  REQUIRE(equal[0].first < 0.99 * equal[1].first);
  REQUIRE(equal[1].first < 0.99 * equal[2].first);
  for (const double share : {0.999, 1.001}) {
    CAPTURE(share);
    NoiseModel noise;
    noise.scale.fill(share * equal[1].first);
    FitSettings settings;
    settings.noise = noise;
    const auto found = rotated(study, fit(study, {{rests}}, settings), noise, noise);
    REQUIRE(found);
    std::vector<std::string> names = found->shrink.heldout;
    std::sort(names.begin(), names.end());
    std::vector<std::string> expected{equal[0].second};
    if (share > 1) expected.push_back(equal[1].second);
    std::sort(expected.begin(), expected.end());
    CHECK(names == expected);
  }
}

TEST_CASE("without a part is fitted in the noise as it is, from where the whole fit stands") {
  const Study study(measured(four_presses(), only("joint_stiffness", 2), {0.3}, 3));
  NoiseModel noise;
  noise.scale = {1, 1, 9, 2, 5};
  FitSettings settings;
  settings.noise = noise;
  // another cause, of which each channel asks another size
  const Fit whole = fit(study, only("joint_stiffness", 1), settings);
  const auto found = rotated(study, whole, noise, noise);
  REQUIRE(found);
  std::vector<double> after = study.nominal_residual();
  HeldOut all = nothing_held(study.experiment());
  for (const HeldOut& part : found->parts) {
    const Fit blind =
        fit_from(study.of(without(study.experiment(), part)), whole.candidate, settings, whole.parameters);
    const std::vector<double> left = study.residual(predict(study, blind.candidate, blind.parameters));
    all.names.insert(all.names.end(), part.names.begin(), part.names.end());
    for (const Series& series : study.measurements().series())
      for (std::size_t i = 0; i < series.readings.size(); ++i)
        if (part.reading[series.run][series.readings[i]]) {
          all.reading[series.run][series.readings[i]] = true;
          after[series.first + i] = left[series.first + i];
        }
  }
  const Shrink expected = measure_shrink(study.measurements(), all, study.nominal_residual(), after, noise);
  CHECK(found->shrink.ratio == close_to(expected.ratio).epsilon(1e-9));  // two sums of the same numbers
  CHECK(found->shrink.heldout == expected.heldout);
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
      readings[i].x = 0.3 + 0.01 * place;
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
          seen = seen || (!held[other] && std::abs(readings[other].x - readings[i].x) < 0.011 * step);
        alone += !seen;
      }
      CHECK(alone == 0);
    }
  }
}

TEST_CASE("what shrinks belongs to the cause that it is asked of") {
  const Experiment experiment = measured(four_presses(), only("joint_stiffness", 2), {0.2}, 3);
  const Study study(experiment);
  const NoiseModel noise;
  const auto right = rotated(study, fit(study, only("joint_stiffness", 2), {}), noise, noise);
  const auto wrong = rotated(study, fit(study, only("joint_stiffness", 1), {}), noise, noise);
  REQUIRE(right);
  REQUIRE(wrong);
  CHECK(right->shrink.heldout.size() == 4);
  CHECK(right->shrink.ratio < 1.1 * right->shrink.noise_floor_ratio);
  CHECK(wrong->shrink.ratio > 2 * right->shrink.ratio);
}

TEST_CASE("a run's own tare is tested on blocks of the run: no other run determines it") {
  Experiment experiment = four_presses();
  const EffectAt tare{"run_tare", 0};
  const Study bare(experiment);
  std::vector<double> values(bare.ranges(tare).size(), 0.0);
  for (std::size_t p = 0; p < values.size(); ++p)
    values[p] = (p % 2 == 0 ? 1 : -1) * bare.ranges(tare)[p].scale;
  const Study study(measured(experiment, {{tare}}, values, 4));
  const auto found = rotated(study, fit(study, {{tare}}, {}), {}, {});
  REQUIRE(found);
  for (const std::string& name : found->shrink.heldout) CHECK(name.find('[') != std::string::npos);
  CHECK(found->shrink.ratio < 1.2 * found->shrink.noise_floor_ratio);
}

TEST_CASE("where the runs that can be spared carry no gap, blocks are held out") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-1e-4, 0}, 20, true);
  press(experiment, {-0.2, -0.5, 0.4}, {0, -1e-4}, 20, true);
  load(experiment, {0.2, 0.5, -0.4}, {0, 0}, {-2, 0}, 30);
  const Candidate truth = only("joint_stiffness", 2);
  const Study study(measured(experiment, truth, {0.2}, 3));
  const auto found = rotated(study, fit(study, truth, {}), {}, {});
  REQUIRE(found);
  for (const std::string& name : found->shrink.heldout) CHECK(name.find('[') != std::string::npos);
  CHECK(found->shrink.tested());
  CHECK(found->shrink.ratio < 1.2 * found->shrink.noise_floor_ratio);

  // Where no block carries a gap either, runs are.
  const Study gapless(measured(experiment, truth, {0}, 4));
  const auto untested = rotated(gapless, fit(gapless, truth, {}), {}, {});
  REQUIRE(untested);
  for (const std::string& name : untested->shrink.heldout) CHECK(name.find('[') == std::string::npos);
  CHECK_FALSE(untested->shrink.tested());
}

TEST_CASE("the order of the runs does not change the answer" * doctest::test_suite("long")) {
  const std::vector<std::pair<Candidate, std::vector<double>>> truths{
      {only("backlash", 2), {0.03}},
      {only("force_gain"), {0.1}},
      {{{{"joint_friction", 0}, {"joint_stiffness", 1}}}, {0.03, 0.3}},
      {{}, {}}};
  unsigned seed = 20;
  for (const auto& [truth, parameters] : truths) {
    Experiment experiment = measured(four_presses(), truth, parameters, ++seed);
    const std::map<std::string, Json> report =
        said(as_json(plumbline::diagnose::diagnose(Study(experiment))));
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
      if (turn == 1) std::swap(experiment.runs[0], experiment.runs[1]);
      CAPTURE(truth.label());
      CHECK(differences(report, said(as_json(plumbline::diagnose::diagnose(Study(experiment))))) == "");
    }
  }
}
