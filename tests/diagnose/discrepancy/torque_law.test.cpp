#include "diagnose/discrepancy/torque_law.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/decision/heldout.hpp"
#include "diagnose/discrepancy/law_choice.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/hinge.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE(
    "a law is the same in whatever order the runs are listed, and relaxes only where there is a clock") {
  // Runs of unlike gaps, whose blocks therefore begin in unlike folds.
  const auto relaxing = [] {
    return [arm = 0.0, last = 0.0](double d) mutable {
      arm = 0.9 * arm + 20 * (d - last);
      last = d;
      return hinge_stiffness * d * (1 + 4 * d * d) + arm;
    };
  };
  Experiment experiment = hinge({cycle(0.4, -0.3), cycle(-0.4, 0.2), cycle(0.3, 0.1)}, relaxing, 2);
  for (const bool clock : {false, true}) {
    CAPTURE(clock);
    for (Run& run : experiment.runs)
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        run.readings[i].t = static_cast<double>(i) * (clock ? 0.5 : 1);
    Experiment turned = experiment;
    std::rotate(turned.runs.begin(), turned.runs.begin() + 1, turned.runs.end());
    const Study study(experiment), other_way(turned);
    const auto law = fit_torque_law(study, declared_noise(study)),
               same = fit_torque_law(other_way, declared_noise(other_way));
    REQUIRE(law);
    REQUIRE(same);
    CHECK(same->shape.knots == law->shape.knots);
    CHECK(same->cross_validated == close_to(law->cross_validated).epsilon(1e-6));
    const Eigen::VectorXd &one = law->laws.front().coefficients, &other = same->laws.front().coefficients;
    CHECK((one - other).norm() < 1e-6 * one.norm());
    CHECK(free_laws(study, *law).front().arms.empty() == !clock);
  }
}

TEST_CASE("beyond what was exercised a law is not tested") {
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 4 * d * d); };
  const Experiment experiment = hinge(
      {cycle(0.2, 0), cycle(-0.4, 0)}, [&] { return truth; }, 5);
  HeldOut heldout = choose_blocks(experiment);
  for (std::size_t r = 0; r < 2; ++r) heldout.reading[r].assign(heldout.reading[r].size(), r == 1);
  const Study seen(without(experiment, heldout));
  const auto law = fit_torque_law(seen, declared_noise(seen));
  REQUIRE(law);
  CHECK_FALSE(covers(Study(experiment), *law, heldout.reading));
}

TEST_CASE(
    "the law that is fitted is the law that the chain has: knots, what slips, what widens, what relaxes, a "
    "profile") {
  const Study study(full_bench());
  JointTorqueLaw law;
  law.joints = {2};
  law.stiffness = study.experiment().joint_stiffness[1];
  law.span = {-0.3, 0.4, 60};
  law.coefficients = Eigen::VectorXd::Zero(law_terms_count);
  for (Eigen::Index k = 0; k < finest_knots; ++k)
    law.coefficients(k) = 0.05 * std::sin(12 * knot_place(law.span, k));
  law.coefficients(finest_knots + 1) = 0.03;
  law.coefficients(finest_knots + slip_places + 3) = 0.06;
  law.coefficients(finest_knots + slider_terms + 1) = 0.2;
  for (Eigen::Index k = 0; k < profile_knots; ++k)
    law.coefficients(plain_terms + profile_knots + k) =
        0.02 + 0.01 * std::cos(9 * knot_place(law.span, 2 * k));
  const TorqueLaw chosen{{law}, {finest_knots}, 1};
  const Prediction with = predict_with_law(study, chosen);
  const std::vector<double>& length = study.experiment().link_length;
  for (const LawTrace& trace : law_traces(study, chosen)) {
    const Trace& run = with.runs[trace.run];
    for (Eigen::Index r = 0; r < run.rows(); ++r) {
      const double second = angle(run, r, 0) + angle(run, r, 1), third = second + angle(run, r, 2);
      const double x = length[1] * std::cos(second) + length[2] * std::cos(third),
                   y = length[1] * std::sin(second) + length[2] * std::sin(third);
      CHECK(std::abs(trace.torque(r) - (x * run(r, column_Fy) - y * run(r, column_Fx))) < 1e-7);
    }
  }
}

namespace {

/// What the best law at a hinge leaves of the rms where it predicts each fifth of the readings, two blocks of
/// ten of every run, from the others: as the headers tell it, by sums of its own.
double left_unseen(const Study& study, const NoiseEstimate& noise) {
  const Experiment& experiment = study.experiment();
  // A rest angle of one is a torque of the spring's stiffness, that way.
  const Prediction answer = predict(study, only("rest_angle", 1), {0.0}, true);
  const Eigen::VectorXd per_torque = study.measurements().in_sigmas(answer.sensitivity[0]) / -hinge_stiffness;
  std::vector<Eigen::VectorXd> bent;
  LawSpan span;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    bent.emplace_back(answer.runs[r].col(column_q).matrix().array() - experiment.runs[r].rest[0]);
    span.low = std::min(span.low, bent.back().minCoeff());
    span.high = std::max(span.high, bent.back().maxCoeff());
    span.duration =
        std::max(span.duration, experiment.runs[r].readings.back().t - experiment.runs[r].readings.front().t);
  }
  const Eigen::VectorXd residual = study.nominal_residual();
  const LawSums none{Eigen::MatrixXd::Zero(law_terms_count, law_terms_count),
                     Eigen::VectorXd::Zero(law_terms_count), 0};
  // Each reading is left out twice, with other ones of the other run, which carries less of the gap.
  LawFolds folds{std::vector<LawSums>(10, none), 2};
  const auto carried = [&](std::size_t run) {
    double sum = 0;
    for (const Series& series : study.measurements().series())
      for (std::size_t i = 0; series.run == run && i < series.readings.size(); ++i)
        sum += std::pow(residual(static_cast<Eigen::Index>(series.first + i)), 2);
    return sum;
  };
  const std::size_t lesser = carried(0) < carried(1) ? 0 : 1;
  double nominal = 0;
  for (const Series& series : study.measurements().series()) {
    const Run& run = experiment.runs[series.run];
    const Eigen::MatrixXd terms = law_terms(span, run, bent[series.run]);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const std::size_t reading = series.readings[i], block = 10 * reading / run.readings.size();
      const auto value = static_cast<Eigen::Index>(series.first + i);
      const double scale = noise.of(series.channel).scale, left = residual(value) / scale;
      const Eigen::VectorXd slope =
          per_torque(value) / scale * terms.row(static_cast<Eigen::Index>(reading)).transpose();
      const std::size_t later = series.run == lesser ? 1 : 0;
      for (const std::size_t fold : {(block + later) % 5, 5 + (block + 5 - later) % 5})
        folds.parts[fold] += {slope * slope.transpose(), slope * left, left * left};
      nominal += left * left;
    }
  }
  return std::sqrt(choose_law(folds, study.measurements().size()).left / nominal);
}

}  // namespace

TEST_CASE(
    "a law is worth what it leaves of readings that it has not seen, and offered where that is surely less") {
  // Many readings, of which a law has to predict a tenth of the rms; and so few that it has to predict more,
  // for the gain of one that says nothing scatters by 1 / sqrt(values).
  const auto shortened = [](const std::vector<double>& path, std::size_t step) {
    std::vector<double> some;
    for (std::size_t i = 0; i < path.size(); i += step) some.push_back(path[i]);
    return some;
  };
  for (const std::size_t step : {1U, 8U}) {
    const std::vector<double> there = shortened(cycle(0.4, -0.3), step),
                              back = shortened(cycle(-0.4, 0.2), step);
    int offered = 0, refused = 0;
    for (const double size : {0.04, 0.06, 0.065, 0.07, 0.08, 0.1, 0.12, 0.13, 0.15, 0.3}) {
      CAPTURE(step);
      CAPTURE(size);
      Experiment experiment = hinge(
          {there, back},
          [&] { return [&](double d) { return hinge_stiffness * d * (1 + size * d * d / 4); }; }, 7);
      // some forces were not read: the others of their block stay in its fifth
      experiment.runs[1].readings[3][column_Fx] = experiment.runs[1].readings[5][column_Fx] = nan_value();
      const Study study(experiment);
      NoiseEstimate noise = declared_noise(study);
      noise_of(noise, Channel(Channel::Name::Fx)).scale = 1.25;
      noise_of(noise, Channel(Channel::Name::Fy)).scale = 0.8;
      const double values = static_cast<double>(study.measurements().size()),
                   most = std::min(0.9, std::sqrt(1 - 2 / std::sqrt(values)));
      CHECK((most < 0.9) == (step > 1));
      const double left = left_unseen(study, noise);
      const auto law = fit_torque_law(study, noise);
      CHECK(law.has_value() == (left < most));
      // Both derivatives by a torque are difference quotients of a millionth.
      if (law) CHECK(law->cross_validated == close_to(left).epsilon(1e-4));
      ++(law ? offered : refused);
    }
    CHECK(offered > 1);
    CHECK(refused > 1);
  }
}
