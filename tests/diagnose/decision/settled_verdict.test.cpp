#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/alike.hpp"
#include "diagnose/decision/verdict.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Equals = std::vector<std::size_t>;

/// An explanation of so much evidence and likelihood with so many parameters.
Hypothesis evident(const Candidate& candidate, double log_evidence, double log_likelihood,
                   std::size_t parameters) {
  Hypothesis one;
  one.fit.candidate = candidate;
  one.fit.parameters.assign(parameters, 1);
  one.log_evidence = log_evidence;
  one.log_likelihood = log_likelihood;
  return one;
}

/// Told apart by its likelihood wherever it is by its evidence.
Hypothesis evident(const Candidate& candidate, double log_evidence) {
  return evident(candidate, log_evidence, 100 * log_evidence, 1);
}

Cause settled_cause(const std::vector<Hypothesis>& hypotheses, std::size_t chosen, double unknown) {
  Cause cause;
  for (const Hypothesis& one : hypotheses) cause.ranking.push_back({one, 0, 0});
  settle_on(cause, chosen, unknown);
  return cause;
}

/// A fit that is beyond doubt: every parameter a scale from zero, and known well.
Fit undoubted(const Study& study, const Candidate& candidate, const std::vector<double>& residual) {
  Fit fit;
  fit.candidate = candidate;
  for (const ParameterRange& range : study.ranges(candidate)) fit.parameters.push_back(range.scale);
  const auto count = static_cast<Eigen::Index>(fit.parameters.size());
  fit.at_bound.assign(fit.parameters.size(), false);
  fit.information = 1e9 * Eigen::MatrixXd::Identity(count, count);
  fit.covariance = 1e-9 * Eigen::MatrixXd::Identity(count, count);
  fit.residual = residual;
  fit.converged = true;
  return fit;
}

const Candidate too_strong{{{"force_gain"}}}, off_centre{{{"eccentric_load"}}}, drifting{{{"sensor_drift"}}};

}  // namespace

TEST_CASE("the best partial explanation, by Schwarz's criterion of an eighth of the values") {
  const auto of = [](double squares, std::size_t parameters) {
    Fit fit;
    fit.residual = {squares};
    fit.parameters.assign(parameters, 0);
    return fit;
  };
  const auto best = [](std::size_t readings, std::vector<Fit> fits) {
    std::vector<const Fit*> all;
    for (Fit& one : fits) {
      // Of the size that these squares make, far beyond what a robust loss would count in full, with either
      // sign.
      const double size = 100 * std::sqrt(one.residual[0]);
      one.residual.assign(2 * readings, size);
      for (std::size_t i = 0; i < one.residual.size(); i += 2) one.residual[i] = -size;
      all.push_back(&one);
    }
    return best_partial(Measurements(blank_experiment({readings})), all);
  };
  // 40 values count as 5: a parameter costs ln 5, squares less by 5^(1/5) = 1.38 are worth it
  CHECK(best(20, {of(10, 1), of(10 / 1.37, 2)}) == 0);
  CHECK(best(20, {of(10, 1), of(10 / 1.39, 2)}) == 1);
  CHECK(best(20, {of(10, 3), of(10, 1), of(11, 1)}) == 1);
  // eight values count as one, of which a parameter costs ln 2
  CHECK(best(4, {of(10, 1), of(10 / 1.98, 2)}) == 0);
  CHECK(best(4, {of(10, 1), of(10 / 2.02, 2)}) == 1);
}

TEST_CASE("probabilities go with the evidence beside that of a cause outside, of any size") {
  for (const double level : {0.0, -2000.0}) {
    const Cause cause = settled_cause({evident(too_strong, level), evident(off_centre, level - std::log(4.0)),
                                       evident(drifting, level - 50)},
                                      0, 0.2);
    CHECK(cause.unknown == 0.2);
    CHECK(cause.best == 0);
    CHECK(cause.ranking[0].probability == close_to(0.8 * 0.8));
    CHECK(cause.ranking[1].probability == close_to(0.2 * 0.8));
    CHECK(cause.ranking[2].probability < 1e-20);
    // ln 4 is less than the three that tell apart
    CHECK(cause.equivalent == Equals{1});
    CHECK(cause.verdict == CauseVerdict::ambiguous);
  }
  CHECK(settled_cause({evident(too_strong, 0), evident(off_centre, -3.1)}, 0, 0.1).verdict ==
        CauseVerdict::identified);
  CHECK(settled_cause({evident(too_strong, 0), evident(off_centre, -3.1)}, 1, 0.1).equivalent == Equals{0});
}

TEST_CASE(
    "what tolerances alone tell apart is listed up to eight: a value at each joint beside one for all") {
  const Candidate for_all{{{"length_scale"}}}, at_each{{{"length_spread"}}},
      more{{{"length_spread"}, {"gravity"}}}, other_spread{{{"rest_spread"}}}, at_one{{{"link_length", 2}}};
  const auto beside = [&](const Candidate& best, const Candidate& other, double behind) {
    return settled_cause({evident(best, 0), evident(other, -behind)}, 0, 0.05).equivalent;
  };
  CHECK(beside(for_all, at_each, 7.9) == Equals{1});
  CHECK(beside(for_all, at_each, 8.1).empty());
  CHECK(beside(at_each, for_all, 7.9).empty());  // what the readings ask for
  CHECK(beside(for_all, other_spread, 7.9).empty());
  CHECK(beside(for_all, more, 7.9).empty());
  CHECK(beside(at_one, at_each, 7.9) == Equals{1});
  CHECK(beside({{{"joint_friction"}, {"gravity"}}}, {{{"gravity"}, {"friction_spread"}}}, 7.9) == Equals{1});
  CHECK(beside({{{"joint_friction"}, {"gravity"}}}, {{{"friction_spread"}, {"force_gain"}}}, 7.9).empty());
}

TEST_CASE("beside machining alone the likeliest of the changes that its values may hide are listed") {
  const auto machining_with = [](std::vector<EffectAt> more) {
    Candidate all{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
    all.effects.insert(all.effects.end(), more.begin(), more.end());
    return all;
  };
  const Candidate alone = machining_with({});
  const auto listed = [&](const std::vector<std::pair<Candidate, double>>& others) {
    std::vector<Hypothesis> all{evident(alone, 0)};
    for (const auto& [candidate, behind] : others) all.push_back(evident(candidate, -behind));
    return settled_cause(all, 0, 0.05).equivalent;
  };
  const Candidate second_joint = machining_with({{"joint_stiffness", 2}}),
                  third_rest = machining_with({{"rest_angle", 3}}),
                  lengths = machining_with({{"length_scale"}}), weight = machining_with({{"gravity"}});
  // The second within three of the first of them, the third not; gravity is no change that values can make.
  CHECK(listed({{weight, 4}, {second_joint, 4.5}, {third_rest, 7.4}, {lengths, 7.6}}) == Equals{2, 3});
  CHECK(listed({{second_joint, 8.1}}).empty());
  // a gain of the load cell is what all stiffnesses make
  CHECK(listed({{machining_with({{"force_gain"}}), 5}}) == Equals{1});
  CHECK(listed({{machining_with({{"joint_stiffness", 2}, {"gravity"}}), 5}}).empty());
  CHECK(listed({{{{{"stiffness_spread"}, {"joint_stiffness", 2}}}, 5}}).empty());
  // With a cause beside it machining is not all.
  CHECK(settled_cause({evident(weight, 0), evident(machining_with({{"gravity"}, {"rest_angle", 3}}), -5)}, 0,
                      0.05)
            .equivalent.empty());
}

TEST_CASE("what is less probable than not is named with the next, until together they are") {
  // thirty that fall behind by just too much: 1 and 30 exp(-3.05) = 1.421
  std::vector<Hypothesis> all{evident(too_strong, 0)};
  for (int i = 0; i < 30; ++i) all.push_back(evident(off_centre, -3.05));
  const double whole = 1 + 30 * std::exp(-3.05), each = std::exp(-3.05) / whole;
  const auto more = static_cast<std::size_t>(std::ceil((0.5 - 1 / whole) / each));
  REQUIRE(more == 5);
  CHECK(settled_cause(all, 0, 0).equivalent == Equals{1, 2, 3, 4, 5});
  CHECK(settled_cause(all, 0, 0).verdict == CauseVerdict::ambiguous);
  // with a fifth for another cause there is less for each
  CHECK(settled_cause(all, 0, 0.1).equivalent.size() ==
        static_cast<std::size_t>(std::ceil((0.5 - 0.9 / whole) / (0.9 * each))));
  // the one that is chosen and those that come near it are not counted again
  all.resize(3);
  all[2] = evident(drifting, -1);
  const Cause nearly = settled_cause(all, 0, 0.4);
  CHECK(nearly.equivalent == Equals{2});
  CHECK(nearly.ranking[0].probability + nearly.ranking[2].probability > 0.5);
  const Cause rest = settled_cause(all, 0, 0.5);
  CHECK(rest.equivalent == Equals{2, 1});
  std::swap(all[0], all[1]);
  CHECK(settled_cause(all, 1, 0).equivalent == Equals{2});
}

TEST_CASE(
    "what has less than three quarters of what is listed is not named alone, though only more of it is "
    "near") {
  const Candidate more{{{"force_gain"}, {"sensor_drift"}}}, still_more{{{"force_gain"}, {"eccentric_load"}}};
  const auto beside = [&](double odds, double unknown) {
    return settled_cause({evident(too_strong, 0), evident(more, -std::log(odds)), evident(still_more, -40)},
                         0, unknown);
  };
  for (const double unknown : {0.0, 0.25}) {
    CHECK(beside(3.01, unknown).verdict == CauseVerdict::identified);
    CHECK(beside(2.99, unknown).equivalent == Equals{1});
  }
  // two together are not asked for as much
  const Cause near =
      settled_cause({evident(too_strong, 0), evident(off_centre, 0), evident(more, -0.1)}, 0, 0);
  CHECK(near.equivalent == Equals{1});
}

TEST_CASE(
    "what is as likely, with one parameter more and as many effects, comes near; with two it does not") {
  const Hypothesis best = evident(too_strong, 0, 0, 1);
  const auto near = [&](const Hypothesis& other) {
    return !settled_cause({best, other}, 0, 0).equivalent.empty();
  };
  CHECK(near(evident(off_centre, -20, -2.9, 1)));
  CHECK_FALSE(near(evident(off_centre, -20, -3.1, 1)));
  CHECK(near(evident(off_centre, -20, -2.9, 2)));
  CHECK_FALSE(near(evident(off_centre, -20, -2.9, 3)));
  const Candidate two{{{"eccentric_load"}, {"sensor_drift"}}}, added{{{"force_gain"}, {"sensor_drift"}}};
  CHECK_FALSE(near(evident(two, -20, 5, 2)));
  CHECK(near(evident(two, -2.9, 5, 2)));
  CHECK_FALSE(near(evident(added, -1.2, 5, 2)));  // it with something added
  // a refinement: of one square of a normal number 6.635 is chance once in a hundred, of two 9.210
  const Hypothesis plain = evident({{{"joint_friction"}}}, 0, 0, 1);
  const auto refines = [&](double gained, std::size_t parameters) {
    const Hypothesis uneven = evident({{{"direction_friction"}}}, -20, gained, parameters);
    return !settled_cause({plain, uneven}, 0, 0).equivalent.empty();
  };
  CHECK_FALSE(refines(6.63 / 2, 2));
  CHECK(refines(6.64 / 2, 2));
  CHECK_FALSE(refines(9.20 / 2, 3));
  CHECK(refines(9.22 / 2, 3));
  CHECK_FALSE(refines(50, 1));
}

TEST_CASE(
    "of more than one effect the cause is another one time in eight, of one as seldom as its test says") {
  const Study study(blank_experiment({40}));
  std::mt19937_64 random(12);
  const std::vector<double> residual = correlated_noise(study.measurements(), 1, 0, random);
  const auto unknown = [&](const Candidate& candidate) {
    return judge(study, {{{undoubted(study, candidate, residual), 0, 0, {}}}, {}}).unknown;
  };
  CHECK(unknown({{{"force_gain"}, {"eccentric_load"}}}) == beliefs::wrong_compound);
  CHECK(unknown(too_strong) < 0.05);
}

TEST_CASE("where more than noise is tolerated an explanation is refused by its chi-square") {
  // Six values, four parameters: of two degrees of freedom a sum of squares exceeds s with exp(-s / 2).
  const Study study(blank_experiment({3}));
  const Candidate four{{{"force_bias"}, {"position_offset"}}};
  const auto judged = [&](double size, double scale, const Candidate& candidate) {
    Findings findings{{{undoubted(study, candidate, {size, -size, size, -size, size, -size}), 0, 0, {}}}, {}};
    findings.tolerance = NoiseModel();
    findings.tolerance->scale.fill(scale);
    return judge(study, findings);
  };
  CHECK(judged(0.6, 1, four).ranking.at(0).hypothesis.p_value.value() == close_to(std::exp(-6 * 0.36 / 2)));
  CHECK(judged(0.6, 2, four).ranking.at(0).hypothesis.p_value.value() == close_to(std::exp(-6 * 0.09 / 2)));
  CHECK(judged(0.6, 1, four).ranking.at(0).chi2_per_dof == close_to(6 * 0.36 / 2));
  CHECK(judged(0.6, 1, four).verdict == CauseVerdict::identified);
  CHECK(judged(1.6, 1, four).verdict == CauseVerdict::unknown);  // exp(-7.7) is less than a thousandth
  // as many parameters as values fit anything
  const Cause six = judged(0, 1, {{{"force_bias"}, {"position_offset"}, {"sensor_drift"}}});
  CHECK(six.verdict == CauseVerdict::unknown);
  CHECK(six.ranking.at(0).hypothesis.p_value.value() == 0);
}

TEST_CASE("confirmed by all readings: what came near, what leads and its parts, and two that stand") {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.05, 0}, 12, true);
  const Study study(measured(bench, too_strong, {0.06}, 5));
  const auto standing = [&](const Candidate& candidate, double log_evidence) {
    return evident(candidate, log_evidence, 0, study.ranges(candidate).size());
  };
  const auto ids = [&](const Findings& found) {
    std::vector<std::string> labels;
    for (const Hypothesis& one : confirmed(study, found).hypotheses)
      labels.push_back(one.fit.candidate.label());
    std::sort(labels.begin(), labels.end());
    std::string all;
    for (const std::string& one : labels) all += (all.empty() ? "" : "; ") + one;
    return all;
  };
  const Candidate rest{{{"joint_stiffness", 2}}}, both{{{"force_gain"}, {"joint_stiffness", 2}}};
  std::vector<Hypothesis> all{standing(too_strong, 0), standing(rest, -49),
                              standing({{{"joint_stiffness", 1}}}, -51)};
  for (Hypothesis& one : all) one.fit.parameters.assign(1, 0.01);
  CHECK(ids({all, {}}) == "force_gain; joint_stiffness(2)");
  // where only one stands, the next is asked however far behind
  CHECK(ids({{all[0], all[2]}, {}}) == "force_gain; joint_stiffness(1)");
  // a part of what leads
  Hypothesis pair = standing(both, 10);
  pair.fit.parameters = {0.01, 0.01};
  CHECK(ids({{pair, all[1], all[0], all[2]}, {}}) ==
        "force_gain; force_gain + joint_stiffness(2); joint_stiffness(2)");

  Findings found{all, {}};
  const Findings plain = confirmed(study, found);
  CHECK_FALSE(plain.tolerance.has_value());
  CHECK(plain.hypotheses[0].fit.candidate == too_strong);
  CHECK(plain.hypotheses[0].fit.parameters[0] == close_to(0.06).epsilon(0.05));
  CHECK(plain.hypotheses[0].log_evidence > plain.hypotheses[1].log_evidence);
  CHECK(plain.hypotheses[0].log_evidence != 0);
  found.tolerance = NoiseModel();
  found.tolerance->scale.fill(3);
  const Findings tolerated = confirmed(study, found);
  REQUIRE(tolerated.tolerance.has_value());
  // neighbours share it, eight at a time: as wide as the root of that
  CHECK(tolerated.noise.scale[2] == close_to(3 * std::sqrt(8.0)));
}
