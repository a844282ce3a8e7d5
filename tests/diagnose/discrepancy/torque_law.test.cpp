#include "diagnose/answers/diagnosis.hpp"

#include <algorithm>
#include <functional>

#include "diagnose/discrepancy/law_choice.hpp"
#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/noise/outliers.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

constexpr double hinge_stiffness = 50, lever = 0.2, force_noise = 0.1;

/// A hinge on a rig that leads a rod, which pushes along x, by its end: its angle is known from the end point
/// and its torque from the force alone, T = -lever sin(q) Fx.
/// \param torque  at the hinge by deflection,
/// called in the order of the readings of a run
Experiment hinge(const std::vector<std::vector<double>>& deflections,
                 const std::function<std::function<double(double)>()>& torque, unsigned seed) {
  Experiment experiment;
  experiment.name = "hinge";
  experiment.link_length = {lever, lever};
  experiment.joint_stiffness = {hinge_stiffness, 0};
  experiment.link_mass = {0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, false};
  experiment.noise = {0, 0, force_noise, force_noise, 0};
  const double rest = std::acos(0.0);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, force_noise);
  for (const std::vector<double>& path : deflections) {
    Run run{"run-" + std::to_string(experiment.runs.size() + 1), Control::end_point, {rest, -rest}, {}};
    const auto carried = torque();
    for (const double d : path) {
      const double height = lever * std::sin(rest + d);
      run.readings.push_back({static_cast<double>(run.readings.size()),
                              lever * (1 + std::cos(rest + d)),
                              height,
                              noise(engine) - carried(d) / height,
                              noise(engine),
                              {}});
    }
    experiment.runs.push_back(run);
  }
  return experiment;
}

/// 0 to `far` to `back` to 0, in even steps.
std::vector<double> cycle(double far, double back) {
  std::vector<double> path;
  constexpr double step = 0.01;
  const auto go = [&](double to) {
    const double from = path.empty() ? 0 : path.back();
    const int count = static_cast<int>(std::lround(std::abs(to - from) / step));
    for (int i = path.empty() ? 0 : 1; i <= count; ++i) path.push_back(from + (to - from) * i / count);
  };
  go(far);
  go(back);
  go(0);
  return path;
}

std::optional<OfferedLaw> offered_for(const Experiment& experiment) {
  return offer_law(Study(experiment), NoiseModel(), [](const Study&) { return Instance(); });
}

}  // namespace

TEST_CASE("a hardening law is recovered, and said") {
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 4 * d * d); };
  const Experiment experiment = hinge(
      {cycle(0.4, -0.4), cycle(-0.4, 0.4)}, [&] { return truth; }, 1);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->shrink->ratio < 1.3 * offered->shrink->noise_floor_ratio);
  // Straight between knots h apart, the law is off by h^2/12 T'' at the knots and less between; T'' is at
  // most 24 k 0.4 and h 0.05 where the choice is fine enough to reach the noise. Five standard deviations of
  // one reading beside, at the ends, where few readings bear a knot.
  const double tolerance = 0.05 * 0.05 / 12 * 24 * hinge_stiffness * 0.4 + 5 * force_noise * lever;
  for (const FreeLaw::Knot& knot : offered->pictures.front().knots)
    if (std::abs(knot.deflection) <= 0.4) CHECK(std::abs(knot.torque - truth(knot.deflection)) < tolerance);
  CHECK(offered->pictures.front().words.find("hardening") != std::string::npos);
  CHECK(offered->pictures.front().sliders.empty());
}

TEST_CASE("the loop of a spring with a slider is recovered") {
  static constexpr double slip = 2, turn = 0.05;
  const auto truth = [&] {
    return [=, carried = 0.0, last = 0.0](double d) mutable {
      carried = std::clamp(carried + slip / turn * (d - last), -slip, slip);
      last = d;
      return hinge_stiffness * d + carried;
    };
  };
  const Experiment experiment = hinge({cycle(0.4, -0.3), cycle(-0.4, 0.2), cycle(0.3, 0.1)}, truth, 2);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->shrink->ratio < 0.3);
  double carried = 0;
  for (const FreeLaw::Slider& one : offered->pictures.front().sliders) carried += one.torque;
  // The nearest sliders slip at 0.04 and 0.08 rad: a tenth of the torque is what their mixture may miss.
  CHECK(carried == close_to(slip).epsilon(0.1));
  CHECK(offered->pictures.front().words.find("loop of") != std::string::npos);
}

TEST_CASE("a loop that is open over a part of the way alone is recovered, whichever way it runs") {
  // Friction about 0.15 rad; where it is negative the way back gives more than the way there took.
  for (const double sign : {1.0, -1.0}) {
    const auto level = [=](double d) { return sign * 1.5 * std::exp(-std::pow((d - 0.15) / 0.08, 2)); };
    const auto truth = [&] {
      return [=, share = 0.0, last = 0.0](double d) mutable {
        share = std::clamp(share + (d - last) / 0.04, -1.0, 1.0);
        last = d;
        return hinge_stiffness * d + level(d) * share;
      };
    };
    const Experiment experiment = hinge({cycle(0.4, -0.3), cycle(-0.4, 0.2), cycle(0.4, 0.05)}, truth, 2);
    const std::optional<OfferedLaw> offered = offered_for(experiment);
    REQUIRE(offered);
    REQUIRE(offered->shrink);
    CHECK(offered->shrink->ratio < 0.3);
    const LawPicture& picture = offered->pictures.front();
    REQUIRE(picture.sliders.size() == 1);
    const auto& profile = picture.sliders.front().profile;
    const auto widest = std::max_element(profile.begin(), profile.end(), [](const auto& a, const auto& b) {
      return std::abs(a.torque) < std::abs(b.torque);
    });
    // knots are 0.05 rad apart: one lies at the middle of the loop, and is held straight with its neighbours
    CHECK(widest->deflection == close_to(0.15));
    CHECK(widest->torque == close_to(sign * 1.5).epsilon(0.2));
    CHECK(picture.words.find("rad and of") != std::string::npos);
    CHECK((picture.words.find("gives more than the way there took") != std::string::npos) == (sign < 0));
  }
}

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
    const auto law = fit_torque_law(Study(experiment), NoiseModel(), {}),
               same = fit_torque_law(Study(turned), NoiseModel(), {});
    REQUIRE(law);
    REQUIRE(same);
    CHECK(same->shape.knots == law->shape.knots);
    CHECK(same->cross_validated == close_to(law->cross_validated).epsilon(1e-6));
    const Eigen::VectorXd &one = law->laws.front().coefficients, &other = same->laws.front().coefficients;
    CHECK((one - other).norm() < 1e-6 * one.norm());
    CHECK(free_laws(Study(experiment), *law).front().arms.empty() == !clock);
  }
}

TEST_CASE("a joint that has slack is said to have it") {
  const auto truth = [](double d) {
    return hinge_stiffness * std::copysign(std::max(0.0, std::abs(d) - 0.1), d);
  };
  const std::optional<OfferedLaw> offered = offered_for(hinge(
      {cycle(0.4, -0.4), cycle(-0.4, 0.4)}, [&] { return truth; }, 3));
  REQUIRE(offered);
  CHECK(offered->pictures.front().words.find("slack of 0.2 rad") != std::string::npos);
}

TEST_CASE("two knots to a side tell a hardening or a softening spring from a straight one") {
  const auto words = [](double cubic) {
    const LawSpan span{-0.4, 0.4, 10};
    JointTorqueLaw law{{1}, span, Eigen::VectorXd::Zero(law_terms_count), hinge_stiffness};
    for (Eigen::Index k = 0; k < finest_knots; ++k)
      law.coefficients(k) = hinge_stiffness * cubic * std::pow(knot_place(span, k), 3);
    return picture_of(law, 5).words;
  };
  CHECK(words(5).find("hardening from") != std::string::npos);
  CHECK(words(-3).find("softening from") != std::string::npos);
  CHECK(words(0) == "close to the nominal spring");
}

TEST_CASE("nothing is offered for noise") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Experiment experiment = hinge(
        {cycle(0.4, -0.4)}, [] { return [](double d) { return hinge_stiffness * d; }; }, seed);
    CHECK_FALSE(offered_for(experiment));
  }
}

TEST_CASE("where nothing predicts what was held out, nothing is offered") {
  // A joint that answers each of eight readings in its own way.
  const std::vector<double> wavers{9, -9, 8, -8, 9, -7, 8, -9};
  const auto torque = [&] {
    return [&, at = std::size_t{0}](double d) mutable {
      return hinge_stiffness * d + 10 * force_noise * lever * wavers[at++];
    };
  };
  const Experiment experiment = hinge({{0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}}, torque, 1);
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment));
  CHECK(diagnosis.cause.verdict == CauseVerdict::unknown);
  CHECK(diagnosis.nothing_predicts);
  CHECK_FALSE(diagnosis.shrink);
  CHECK_FALSE(diagnosis.offers_law());
}

TEST_CASE("a law of readings so few that none can be held out is offered untested") {
  // Seven: an eighth of a run is what is held out at once.
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 40 * d * d); };
  const Experiment experiment = hinge(
      {{0.0, 0.1, 0.2, 0.3, 0.4, 0.25, 0.05}}, [&] { return truth; }, 1);
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment));
  CHECK(diagnosis.cause.reservation == Reservation::not_tested);
  REQUIRE(diagnosis.law);
  CHECK_FALSE(diagnosis.law->shrink);
  CHECK_FALSE(diagnosis.offers_law());
}

TEST_CASE("beyond what was exercised a law is not tested") {
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 4 * d * d); };
  const Experiment experiment = hinge(
      {cycle(0.2, 0), cycle(-0.4, 0)}, [&] { return truth; }, 5);
  HeldOut heldout = choose_blocks(experiment);
  for (std::size_t r = 0; r < 2; ++r) heldout.reading[r].assign(heldout.reading[r].size(), r == 1);
  const auto law = fit_torque_law(Study(without(experiment, heldout)), NoiseModel(), {});
  REQUIRE(law);
  CHECK_FALSE(covers(Study(experiment), *law, heldout));
}

TEST_CASE("in a chain of several joints the law is where the torque is missing") {
  Experiment experiment = three_links();
  experiment.noise.q = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 40, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 40, true);
  press(experiment, {0.5, -0.3, 0.4}, {-0.05, -0.02}, 40, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  experiment = measured(experiment, only("joint_stop", 2), {0.05, 3}, 6);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->pictures.front().joints == std::vector<std::size_t>{2});
  CHECK(offered->shrink->ratio < 0.3);
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
  const TorqueLaw chosen{{}, {law}, {finest_knots}, 1};
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
/// \param stiffer  the spring that it stands beside is by this share
double left_unseen(const Study& study, const NoiseModel& noise, double stiffer) {
  const Experiment& experiment = study.experiment();
  // A rest angle of one is a torque of the spring's stiffness, that way.
  const Prediction answer =
      predict(study, {{{"rest_angle", 1}, {"joint_stiffness", 1}}}, {0.0, stiffer}, true);
  std::vector<double> per_torque = study.measurements().in_sigmas(answer.sensitivity[0]);
  for (double& one : per_torque) one /= -hinge_stiffness * (1 + stiffer);
  std::vector<Eigen::VectorXd> bent;
  LawSpan span;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    bent.emplace_back(answer.runs[r].col(column_q).matrix().array() - experiment.runs[r].rest[0]);
    span.low = std::min(span.low, bent.back().minCoeff());
    span.high = std::max(span.high, bent.back().maxCoeff());
    span.duration =
        std::max(span.duration, experiment.runs[r].readings.back().t - experiment.runs[r].readings.front().t);
  }
  const std::vector<double> residual = without_outliers(study.measurements(), study.residual(answer)),
                            before = without_outliers(study.measurements(), study.nominal_residual());
  const LawSums none{Eigen::MatrixXd::Zero(law_terms_count, law_terms_count),
                     Eigen::VectorXd::Zero(law_terms_count), 0};
  // Each reading is left out twice, with other ones of the other run, which carries less of the gap.
  LawFolds folds{std::vector<LawSums>(10, none), 2};
  const auto carried = [&](std::size_t run) {
    double sum = 0;
    const std::vector<double> gap = study.nominal_residual();
    for (const Series& series : study.measurements().series())
      for (std::size_t i = 0; series.run == run && i < series.readings.size(); ++i)
        sum += std::pow(gap[series.first + i], 2);
    return sum;
  };
  const std::size_t lesser = carried(0) < carried(1) ? 0 : 1;
  double nominal = 0;
  for (const Series& series : study.measurements().series()) {
    const Run& run = experiment.runs[series.run];
    const Eigen::MatrixXd terms = law_terms(span, run, bent[series.run]);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const std::size_t reading = series.readings[i], block = 10 * reading / run.readings.size();
      const double left = residual[series.first + i] / noise.of(series.channel);
      const Eigen::VectorXd slope = per_torque[series.first + i] / noise.of(series.channel) *
                                    terms.row(static_cast<Eigen::Index>(reading)).transpose();
      const std::size_t later = series.run == lesser ? 1 : 0;
      for (const std::size_t fold : {(block + later) % 5, 5 + (block + 5 - later) % 5})
        folds.parts[fold] += {slope * slope.transpose(), slope * left, left * left};
      nominal += std::pow(before[series.first + i] / noise.of(series.channel), 2);
    }
  }
  return std::sqrt(choose_law(folds, residual.size()).left / nominal);
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
    const double stiffer = step == 1 ? 0.03 : 0;
    int offered = 0, refused = 0;
    for (const double size : {0.04, 0.06, 0.065, 0.07, 0.08, 0.1, 0.12, 0.13, 0.15, 0.3}) {
      CAPTURE(step);
      CAPTURE(size);
      Experiment experiment = hinge(
          {there, back},
          [&] { return [&](double d) { return hinge_stiffness * d * (1 + size * d * d / 4); }; }, 7);
      // some forces were not read: the others of their block stay in its fifth
      experiment.runs[1].readings[3].Fx = experiment.runs[1].readings[5].Fx = nan_value();
      const Study study(experiment);
      NoiseModel noise;
      noise.scale = {1, 1, 1.25, 0.8, 1};
      const double values = static_cast<double>(study.measurements().size()),
                   most = std::min(0.9, std::sqrt(1 - 2 / std::sqrt(values)));
      CHECK((most < 0.9) == (step > 1));
      const double left = left_unseen(study, noise, stiffer);
      const auto law = fit_torque_law(study, noise, {only("joint_stiffness", 1), {stiffer}});
      CHECK(law.has_value() == (left < most));
      // Both derivatives by a torque are difference quotients of a millionth.
      if (law) CHECK(law->base.parameters == std::vector{stiffer});
      if (law) CHECK(law->cross_validated == close_to(left).epsilon(1e-4));
      ++(law ? offered : refused);
    }
    CHECK(offered > 1);
    CHECK(refused > 1);
  }
}
