#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/inference/screen.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// What a fit leaves and what can be done about it, as the screen is said to weigh them: outliers pull as one
/// at the bound, beyond three times what the fit leaves; a row beneath for each parameter that a tolerance
/// holds.
struct Weighed {
  Eigen::VectorXd left;
  Eigen::MatrixXd own;
  Eigen::VectorXd weight;
};

Weighed weighed_by_hand(const Study& study, const Fit& fitted, const FitSettings& settings) {
  const auto values = static_cast<Eigen::Index>(fitted.whitened.size());
  const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
  Eigen::Index held = 0;
  for (const ParameterRange& range : ranges) held += range.tolerance > 0 ? 1 : 0;
  Weighed all{Eigen::VectorXd::Zero(values + held),
              Eigen::MatrixXd::Zero(values + held, fitted.jacobian.cols()), Eigen::VectorXd::Zero(values)};
  const double bound =
      settings.outlier_bound * std::max(1.0, 3 * std::sqrt(fitted.cost / static_cast<double>(values)));
  for (Eigen::Index i = 0; i < values; ++i) {
    const double z = fitted.whitened[static_cast<std::size_t>(i)];
    all.weight(i) = std::abs(z) > bound ? std::sqrt(bound / std::abs(z)) : 1;
    all.left(i) = all.weight(i) * z;
    all.own.row(i) = all.weight(i) * fitted.jacobian.row(i);
  }
  Eigen::Index row = values;
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    if (!(ranges[p].tolerance > 0)) continue;
    all.left(row) = fitted.parameters[p] / ranges[p].tolerance;
    all.own(row++, static_cast<Eigen::Index>(p)) = 1 / ranges[p].tolerance;
  }
  return all;
}

/// What a change of the prediction is among the rows.
Eigen::VectorXd row_of_change(const Study& study, const Weighed& rows, const FitSettings& settings,
                              const std::vector<Trace>& change) {
  const std::vector<double> white =
      whiten(study.measurements(), study.measurements().in_sigmas(change), settings.noise);
  Eigen::VectorXd column = Eigen::VectorXd::Zero(rows.left.size());
  for (Eigen::Index i = 0; i < rows.weight.size(); ++i)
    column(i) = rows.weight(i) * white[static_cast<std::size_t>(i)];
  return column;
}

Eigen::VectorXd least_squares_of(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values) {
  return columns.colPivHouseholderQr().solve(values);
}

/// The rows less what the fit's own parameters can follow of them.
Eigen::VectorXd beyond_own(const Weighed& rows, const Eigen::VectorXd& values) {
  return rows.own.cols() == 0 ? values
                              : Eigen::VectorXd(values - rows.own * least_squares_of(rows.own, values));
}

const Prospect& prospect_of_effect(const std::vector<Prospect>& all, const EffectAt& at) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Prospect& one) { return one.effect == at; });
  REQUIRE(found != all.end());
  return *found;
}

/// The forecast of an effect of one parameter that acts in proportion, from the derivatives of a prediction.
void check_proportional(const Study& study, const Fit& fitted, const FitSettings& settings,
                        const EffectAt& at) {
  CAPTURE(at.label());
  const Weighed rows = weighed_by_hand(study, fitted, settings);
  Candidate both = fitted.candidate;
  both.effects.push_back(at);
  std::vector<double> parameters = fitted.parameters;
  parameters.push_back(0);
  const Eigen::VectorXd column =
      row_of_change(study, rows, settings, predict(study, both, parameters, true).sensitivity.back());
  const Eigen::VectorXd residual = beyond_own(rows, rows.left), newcomer = beyond_own(rows, column);
  const ParameterRange range = study.ranges(at).front();
  const double step = std::clamp(newcomer.dot(residual) / newcomer.squaredNorm(), range.low, range.high);
  const double share = (residual - step * newcomer).squaredNorm() / residual.squaredNorm();
  const Prospect found = prospect_of_effect(screen(study, fitted, settings), at);
  // Both derivatives are quotients of the same step, of a millionth, in rigs that differ by rounding.
  CHECK(found.cost == close_to(fitted.cost * share).epsilon(1e-6));
  REQUIRE(found.from.size() == 3);
  CHECK(found.from[0].back() == close_to(step).epsilon(1e-6));
  CHECK(found.from[1].back() == 0);
  CHECK(found.from[2].back() == found.from[0].back());
  const auto own = static_cast<std::size_t>(rows.own.cols());
  const Eigen::VectorXd by =
      own == 0 ? Eigen::VectorXd() : least_squares_of(rows.own, Eigen::VectorXd(step * column));
  const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
  for (std::size_t p = 0; p < own; ++p) {
    CHECK(found.from[0][p] == fitted.parameters[p]);
    CHECK(found.from[1][p] == fitted.parameters[p]);
    CHECK(found.from[2][p] == close_to(std::clamp(fitted.parameters[p] + by(static_cast<Eigen::Index>(p)),
                                                  ranges[p].low, ranges[p].high))
                                  .epsilon(1e-5));
  }
}

/// Two short runs, of a stiffness that is wrong and a gain.
Study short_bench(int outlier = 0) {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.05, 0}, 8, true);
  press(bench, {-0.4, 0.3, 0.5}, {-0.04, 0.03}, 8, false);
  return Study(measured(bench, {{{"joint_stiffness", 2}, {"force_gain"}}}, {0.1, 0.04}, 5, outlier));
}

const std::vector<EffectAt> in_proportion_to{
    {"joint_stiffness", 2}, {"rest_angle", 1}, {"force_gain"}, {"joint_stiffness", 3}};

}  // namespace

TEST_CASE("beside the nominal model a forecast is that of least squares on one derivative") {
  const Study study = short_bench();
  for (const double scale : {1.0, 2.0}) {
    FitSettings settings;
    settings.noise.scale.fill(scale);
    settings.noise.correlation.fill(0.3);
    const Fit nominal = fit_from(study, {}, settings, {});
    for (const EffectAt& at : in_proportion_to) check_proportional(study, nominal, settings, at);
  }
}

TEST_CASE("beside a fit a forecast readjusts what was fitted") {
  const Study study = short_bench();
  const Candidate known{{{"joint_stiffness", 1}, {"rest_angle", 2}}};
  const Fit fitted = fit(study, known, {});
  for (const EffectAt& at : in_proportion_to) check_proportional(study, fitted, {}, at);
  const std::vector<Prospect> all = screen(study, fitted, {});
  CHECK(std::is_sorted(all.begin(), all.end(),
                       [](const Prospect& a, const Prospect& b) { return a.cost < b.cost; }));
  for (const EffectAt& own : known.effects)
    CHECK(std::none_of(all.begin(), all.end(), [&](const Prospect& one) { return one.effect == own; }));
  for (const Prospect& one : all)
    CHECK(std::count_if(all.begin(), all.end(),
                        [&](const Prospect& other) { return other.effect == one.effect; }) == 1);
}

TEST_CASE("what tolerances hold counts by its prior, and an outlier less") {
  const Study study = short_bench(11);
  // As far as machining lets them: a start that no fit has settled.
  const Fit fitted =
      fit_from(study, {{{"rest_angle", 2}, {"stiffness_spread"}}}, {}, {0.01, 0.05, -0.02, 0.01});
  for (const EffectAt& at : {EffectAt("rest_angle", 1), EffectAt("force_gain")})
    check_proportional(study, fitted, {}, at);
}

TEST_CASE("a newcomer that a tolerance holds goes less far than the readings ask") {
  const Study study = short_bench();
  const Fit nominal = fit_from(study, {}, {}, {});
  const Weighed rows = weighed_by_hand(study, nominal, {});
  const EffectAt springs("stiffness_spread");
  const std::vector<ParameterRange> ranges = study.ranges(springs);
  const Prediction at_nothing = predict(study, {{springs}}, std::vector<double>(ranges.size(), 0), true);
  Eigen::MatrixXd columns(rows.left.size(), static_cast<Eigen::Index>(ranges.size()));
  Eigen::VectorXd inverse(columns.cols());
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    columns.col(static_cast<Eigen::Index>(p)) = row_of_change(study, rows, {}, at_nothing.sensitivity[p]);
    inverse(static_cast<Eigen::Index>(p)) = std::pow(ranges[p].tolerance, -2);
  }
  const Eigen::MatrixXd curved = columns.transpose() * columns + Eigen::MatrixXd(inverse.asDiagonal());
  // Twenty rounds, one parameter after the other, as the screen takes them.
  Eigen::VectorXd steps = Eigen::VectorXd::Zero(columns.cols());
  const Eigen::VectorXd pull = columns.transpose() * rows.left;
  for (int round = 0; round < 20; ++round)
    for (Eigen::Index p = 0; p < steps.size(); ++p) {
      const double others = curved.row(p).dot(steps) - curved(p, p) * steps(p);
      steps(p) = std::clamp((pull(p) - others) / curved(p, p), ranges[0].low, ranges[0].high);
    }
  const Prospect found = prospect_of_effect(screen(study, nominal, {}), springs);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    CHECK(found.from[0][p] == close_to(steps(static_cast<Eigen::Index>(p))).epsilon(1e-5));
  CHECK(found.cost ==
        close_to(nominal.cost * (rows.left - columns * steps).squaredNorm() / rows.left.squaredNorm())
            .epsilon(1e-6));
}

TEST_CASE(
    "what acts otherwise when little is asked by a step as long as a start, of which any share will do") {
  const Study study = short_bench();
  const Candidate known{{EffectAt("rest_angle", 2)}};
  const Fit fitted = fit(study, known, {});
  const Weighed rows = weighed_by_hand(study, fitted, {});
  const Eigen::VectorXd residual = beyond_own(rows, rows.left);
  const Prediction main = simulate(study.experiment(), rig_with(study, known, fitted.parameters), {});
  for (const EffectAt& at :
       {EffectAt("joint_friction"), EffectAt("guide_friction"), EffectAt("backlash", 1)}) {
    if (!at.effect->perturbation.large_step) continue;
    CAPTURE(at.label());
    const ParameterRange range = study.ranges(at).front();
    REQUIRE(study.ranges(at).size() == 1);
    const Prospect found = prospect_of_effect(screen(study, fitted, {}), at);
    double best = fitted.cost, best_step = 0, best_to = 0;
    Candidate both = known;
    both.effects.push_back(at);
    const InitialGuesses from = initial_guesses(study, at);
    for (std::size_t s = 0; s < std::min(at.effect->perturbation.guesses, from.points.size()); ++s) {
      const double to = from.points[s].front();
      std::vector<double> parameters = fitted.parameters;
      parameters.push_back(to);
      Prediction far = simulate(study.experiment(), rig_with(study, both, parameters), {});
      if (!far.reached) continue;
      for (std::size_t r = 0; r < far.runs.size(); ++r) far.runs[r] -= main.runs[r];
      const Eigen::VectorXd column = beyond_own(rows, row_of_change(study, rows, {}, far.runs));
      const double most = to > 0 ? range.high / to : 1e300;
      const double share = std::clamp(column.dot(residual) / column.squaredNorm(), 0.0, most);
      const double cost = fitted.cost * (residual - share * column).squaredNorm() / residual.squaredNorm();
      if (s == 0 || cost < best) best = cost, best_step = share * to, best_to = to;
    }
    CHECK(found.cost == close_to(best).epsilon(1e-6));
    REQUIRE(found.from.size() == 3);
    CHECK(found.from[0].back() == close_to(best_step).epsilon(1e-5));
    CHECK(found.from[1].back() == found.from[0].back());
    CHECK(found.from[2].back() == best_to);
    CHECK(found.from[0].front() == fitted.parameters.front());
  }
}
