/// Effects that a user states as expressions: they are what the catalogue's rows are where they say the same,
/// are found where they were put in, and are refused in one line where they make no sense.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <plumbline/base/error.hpp>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/inference/forecast.hpp"
#include "diagnose/inference/prior.hpp"
#include "diagnose/inference/white_noise_fit.hpp"
#include "diagnose/rig/user_effects/read_effects.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Rows = std::shared_ptr<const std::vector<Effect>>;

std::string parameter(const std::string& name, double scale, double low, double high) {
  return "[effect.parameters." + name + "]\nunit = \"ratio\"\nscale = " + std::to_string(scale) +
         "\nlow = " + std::to_string(low) + "\nhigh = " + std::to_string(high) + "\n";
}

std::string effect_text(const std::string& id, const std::string& acts, const std::string& parameters) {
  return "format = \"user-effects/1\"\n[[effect]]\nid = \"" + id + "\"\nwords = \"something else\"\n" + acts +
         parameters;
}

/// The effects of a file, to be appended to another.
std::string beside(const std::string& text) {
  return text.substr(text.find('\n') + 1);
}

/// A torque of every joint.
std::string torque(const std::string& id, const std::string& expression, const std::string& parameters) {
  return effect_text(id, "where = \"every joint\"\ntorque = \"" + expression + "\"\n", parameters);
}

Rows rows_of(const std::string& text) {
  std::vector<Effect> rows;
  for (const StatedEffect& one : parse_effects(text, "effects.toml"))
    rows.push_back(row_of(std::make_shared<StatedEffect>(one)));
  return std::make_shared<const std::vector<Effect>>(std::move(rows));
}

Experiment two_presses() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 15, false, 2.5);
  return experiment;
}

/// Fits beside independent noise, to the end.
struct WhiteNoise {
  explicit WhiteNoise(const Study& of)
      : study(of),
        likelihood(of.measurements(), CommandStates(of.experiment()), white_noise_alone(),
                   NoiseShape(of.measurements()), of.nominal_residual()) {}
  [[nodiscard]] Hypothesis fitted(const Candidate& candidate, const std::vector<double>& start) const {
    return maximised(study, likelihood, candidate, start, {50, 1e-9, true});
  }
  const Study& study;
  Likelihood likelihood;
};

/// A row of the catalogue, and the same in the user's words.
struct Restated {
  const char* id;
  std::vector<double> truth;
  std::string text;
  double agreement;  ///< of fitted values, relative
};

std::vector<Restated> restated() {
  return {
      {"nonlinear_spring", {0.7}, torque("cubic", "k * c * d^3", parameter("c", 0.5, -3, 50)), 1e-6},
      {"force_gain",
       {0.06},
       effect_text("gain", "[effect.reading]\nFx = \"g * Fx\"\nFy = \"g * Fy\"\n",
                   parameter("g", 0.05, -0.8, 3)),
       1e-6},
      {"force_bias",
       {0.2, -0.1},
       effect_text("tare", "[effect.reading]\nFx = \"b_x\"\nFy = \"b_y\"\n",
                   parameter("b_x", 0.1, -20, 20) + parameter("b_y", 0.1, -20, 20)),
       1e-6},
      // Ours turns the sign within 1e-5 rad either way, the catalogue's friction within 1e-5 tau_c / k: of
      // the deflections that tell tau_c, about 0.01 rad in the readings after a turn, a thousandth.
      {"joint_friction", {0.02}, torque("dry", "tau * s", parameter("tau", 0.02, 0, 5)), 1e-3},
  };
}

}  // namespace

TEST_CASE("a user effect that equals a catalogue row is fitted like that row") {
  for (const Restated& one : restated()) {
    CAPTURE(one.id);
    const Experiment experiment = measured(two_presses(), only(one.id), one.truth, 5);
    const Rows rows = rows_of(one.text);
    const Study study(experiment, rows);
    // From one start: where a fit stops depends on where it comes from by more than a millionth.
    std::vector<double> start;
    for (const double value : one.truth) start.push_back(value / 2);
    const WhiteNoise noise(study);
    const Hypothesis built_in = noise.fitted(only(one.id), start);
    const Hypothesis stated = noise.fitted({{EffectAt(rows->front())}}, start);
    REQUIRE(built_in.converged);
    REQUIRE(stated.converged);
    CHECK(stated.look.log_likelihood == close_to(built_in.look.log_likelihood).epsilon(one.agreement));
    for (std::size_t p = 0; p < one.truth.size(); ++p) {
      const auto j = static_cast<Eigen::Index>(p);
      CHECK(stated.parameters[p] == close_to(built_in.parameters[p]).epsilon(one.agreement));
      // what the readings say; the priors know scales of their own
      CHECK(stated.look.information(j, j) ==
            close_to(built_in.look.information(j, j)).epsilon(10 * one.agreement));
    }
  }
}

TEST_CASE("a user effect is forecast like the equal catalogue row") {
  for (const Restated& one : restated()) {
    if (std::string(one.id) == "joint_friction") continue;  // its large steps are of other lengths
    CAPTURE(one.id);
    const Rows rows = rows_of(one.text);
    const Study study(measured(two_presses(), only(one.id), one.truth, 5), rows);
    double cost[2] = {0, 0};
    const VectorXd alike = VectorXd::Ones(static_cast<Eigen::Index>(study.measurements().size()));
    for (const Prospect& prospect :
         forecast(study, alike, possible_effects(study), WhiteNoise(study).fitted({}, {}))) {
      if (prospect.effect == EffectAt(one.id)) cost[0] = prospect.cost;
      if (prospect.effect == EffectAt(rows->front())) cost[1] = prospect.cost;
    }
    REQUIRE(cost[0] > 0);
    // difference quotients of steps of a millionth
    CHECK(cost[1] == close_to(cost[0]).epsilon(1e-4));
  }
}

TEST_CASE("a moment of the force about one joint is an eccentric load") {
  Experiment experiment = three_links();
  experiment.link_length = {0.4};
  experiment.joint_stiffness = {2};
  experiment.link_mass = {0};
  load(experiment, {0.3}, {0, 0}, {-2, 1}, 15);
  const Rows rows = rows_of(torque("beside", "e * (cos(q) * Fx + sin(q) * Fy)", parameter("e", 0.01, -1, 1)));
  const Study study(experiment, rows);
  const Prediction stated = predict(study, {{EffectAt(rows->front())}}, {0.02}, true);
  const Prediction built_in = predict(study, only("eccentric_load"), {0.02}, true);
  REQUIRE(stated.reached);
  // Solved to ten digits of angles of about one; difference quotients of steps of 1e-6 of a scale are good to
  // four.
  CHECK((stated.runs[0] - built_in.runs[0]).abs().maxCoeff() < 1e-9);
  const double size = built_in.sensitivity[0][0].abs().maxCoeff();
  CHECK((stated.sensitivity[0][0] - built_in.sensitivity[0][0]).abs().maxCoeff() < 1e-4 * size);
}

TEST_CASE("a torque of angle, force and time is the same with end point or force imposed") {
  const Rows rows = rows_of(torque("odd", "a * sin(5 * q) + b * d * sqrt(Fx^2 + Fy^2) + a * t / 100",
                                   parameter("a", 0.02, -1, 1) + parameter("b", 0.1, -1, 1)));
  const Candidate candidate{{EffectAt(rows->front())}};
  const std::vector<double> values{0.02, 0.05};
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {0.01, 0.02}, 12, false);
  const Prediction pressed = predict(Study(experiment, rows), candidate, values);
  REQUIRE(pressed.reached);
  Experiment pulled = experiment;
  pulled.runs[0].control = Control::force;
  for (std::size_t i = 0; i < pulled.runs[0].readings.size(); ++i) {
    pulled.runs[0].readings[i][column_Fx] = pressed.runs[0](static_cast<Eigen::Index>(i), column_Fx);
    pulled.runs[0].readings[i][column_Fy] = pressed.runs[0](static_cast<Eigen::Index>(i), column_Fy);
  }
  const Prediction back = predict(Study(pulled, rows), candidate, values);
  REQUIRE(back.reached);
  CHECK((back.runs[0] - pressed.runs[0]).abs().maxCoeff() <
        1e-7);  // ten digits, at a condition of a thousand
  const Prediction nominal = predict(Study(experiment), {}, {});
  CHECK((nominal.runs[0] - pressed.runs[0]).abs().maxCoeff() > 1e-2);
}

TEST_CASE("corrections depend on run, time and joint angle, and leave commands unchanged") {
  const Rows rows = rows_of(
      effect_text("odd", "[effect.reading]\nq2 = \"a * q\"\nq = \"b * run\"\nFx = \"b * t\"\nx = \"a\"\n",
                  parameter("a", 0.02, -1, 1) + parameter("b", 0.1, -1, 1)));
  Experiment experiment = two_presses();
  const Study study(experiment, rows);
  const Prediction corrected = predict(study, {{EffectAt(rows->front())}}, {0.5, 0.25});
  for (std::size_t r : {0U, 1U}) {
    const Trace &before = study.nominal().runs[r], &after = corrected.runs[r];
    const double run = static_cast<double>(r) + 1;
    for (Eigen::Index i = 0; i < before.rows(); ++i) {
      const double t = experiment.runs[r].readings[static_cast<std::size_t>(i)].t;
      CHECK(after(i, column_x) == before(i, column_x));
      CHECK(after(i, column_Fx) == close_to(before(i, column_Fx) + 0.25 * t).scale(1));  // newtons
      CHECK(after(i, column_Fy) == before(i, column_Fy));
      CHECK(angle(after, i, 0) == close_to(angle(before, i, 0) + 0.25 * run));
      CHECK(angle(after, i, 1) == close_to(1.5 * angle(before, i, 1) + 0.25 * run));
    }
  }
}

namespace {

/// 1 where the values grew to this one, -1 where they fell, as before where they stood; 1 before they moved.
std::vector<double> ways(const std::vector<double>& values) {
  std::vector<double> all(values.size(), 1.0);
  for (std::size_t i = 1; i < values.size(); ++i) {
    all[i] = all[i - 1];
    if (values[i] != values[i - 1]) all[i] = values[i] > values[i - 1] ? 1 : -1;
  }
  return all;
}

/// The bench, but that the first run rests for two readings before it turns back.
Experiment with_rest() {
  Experiment experiment = full_bench();
  std::vector<Reading>& readings = experiment.runs[0].readings;
  readings.insert(readings.begin() + 20, 2, readings[20]);
  for (std::size_t i = 0; i < readings.size(); ++i) readings[i].t = 2.0 * static_cast<double>(i);
  return experiment;
}

/// The values that a correction adds to a channel in a run.
std::vector<double> added_by(const Study& study, const Effect& row, double value, std::size_t run,
                             const Channel& channel) {
  const Prediction corrected = predict(study, {{EffectAt(row)}}, {value});
  std::vector<double> all;
  const Eigen::Index column = channel.column;
  for (Eigen::Index i = 0; i < corrected.runs[run].rows(); ++i)
    all.push_back(corrected.runs[run](i, column) - study.nominal().runs[run](i, column));
  return all;
}

/// The estimate of the one parameter, fitted to readings as the nominal model gives them with what is
/// planted.
double fitted(const Effect& row, const std::function<void(Experiment&, const Prediction& nominal)>& plant) {
  Experiment experiment = measured(with_rest(), {}, {}, 8);
  plant(experiment, Study(experiment).nominal());
  const Study study(experiment);
  const Hypothesis fit = WhiteNoise(study).fitted({{EffectAt(row)}}, {0});
  REQUIRE(fit.converged);
  return fit.parameters[0];
}

}  // namespace

TEST_CASE("the direction of a correction is that of the command along its axis, kept during rest") {
  const Rows rows = rows_of(
      effect_text("odd", "[effect.reading]\nx = \"a * s\"\ny = \"a * s\"\nFx = \"a * s\"\nFy = \"a * s\"\n",
                  parameter("a", 0.02, -1, 1)));
  const Study study(with_rest(), rows);
  for (std::size_t r = 0; r < 3; ++r) {
    CAPTURE(r);
    const Run& run = study.experiment().runs[r];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<double> imposed;
      for (const Reading& one : run.readings)
        imposed.push_back(run.command(one)(static_cast<Eigen::Index>(axis)));
      const std::vector<double> way = ways(imposed),
                                added = added_by(study, rows->front(), 0.5, r, run.measured()[axis]);
      for (std::size_t i = 0; i < way.size(); ++i) CHECK(added[i] == close_to(0.5 * way[i]));
    }
  }
}

TEST_CASE("a run brought to its first reading has a direction there, and the correction is guide friction") {
  Experiment experiment = two_presses();
  for (Run& run : experiment.runs) run.readings.erase(run.readings.begin());
  const Rows rows =
      rows_of(effect_text("rubs", "[effect.reading]\nFx = \"f * s\"\n", parameter("f", 0.1, 0, 5)));
  const Prediction stated = predict(Study(experiment, rows), {{EffectAt(rows->front())}}, {0.5}),
                   built_in = predict(Study(experiment), only("guide_friction"), {0.5});
  for (std::size_t r : {0U, 1U}) CHECK(difference(stated.runs[r], built_in.runs[r]) < 1e-12);
}

TEST_CASE("a correction of an angle depends on its joint's direction and deflection") {
  const Rows rows =
      rows_of(effect_text("odd", "[effect.reading]\nq = \"a * s\"\n", parameter("a", 0.02, -1, 1)) +
              beside(effect_text("bent", "[effect.reading]\nq2 = \"a * d\"\n", parameter("a", 0.02, -1, 1))));
  Experiment experiment = measured(with_rest(), {}, {}, 8);  // whose angles scatter
  const Study study(experiment, rows);
  for (std::size_t joint = 0; joint < 3; ++joint) {
    CAPTURE(joint);
    std::vector<double> angles;
    const Trace& nominal = study.nominal().runs[0];
    for (Eigen::Index i = 0; i < nominal.rows(); ++i) {
      const double q = angle(nominal, i, joint);
      // It rests where it is but for rounding, and turns by far more than that from there.
      const bool rests = !angles.empty() && std::abs(q - angles.back()) < 1e-9;
      angles.push_back(rests ? angles.back() : q);
      if (!rests && i > 0) CHECK(std::abs(q - angles[angles.size() - 2]) > 2e-5);
    }
    const std::vector<double> way = ways(angles),
                              added = added_by(study, (*rows)[0], 0.5, 0, Channel(Channel::Name::q, joint)),
                              bent = added_by(study, (*rows)[1], 0.5, 0, Channel(Channel::Name::q, joint));
    for (std::size_t i = 0; i < way.size(); ++i) {
      CHECK(added[i] == close_to(0.5 * way[i]));
      const double d = angles[i] - experiment.runs[0].rest[joint];
      CHECK(bent[i] == doctest::Approx(joint == 1 ? 0.5 * d : 0).scale(1));  // radians
    }
  }
}

TEST_CASE("an error planted in readings of forces or angles is identified with its value") {
  // Both corrections are proportional to their parameter: noise moves the estimate by the same amount with
  // and without what is planted. A search stops within a tenth of the deviation that it leaves, 2e-4 of an
  // angle's.
  const Rows rows = rows_of(
      effect_text("reversal", "[effect.reading]\nFx = \"a * s\"\n", parameter("a", 0.1, -1, 1)) +
      beside(effect_text("eccentric", "[effect.reading]\nq = \"a * sin(q)\"\n", parameter("a", 0.1, -1, 1))));
  const auto nothing = [](Experiment&, const Prediction&) {};
  const auto hysteresis = [](Experiment& experiment, const Prediction&) {
    for (Run& run : experiment.runs) {
      if (!run.holds_end_point()) continue;
      std::vector<double> x;
      for (const Reading& one : run.readings) x.push_back(one[column_x]);
      const std::vector<double> way = ways(x);
      for (std::size_t i = 0; i < way.size(); ++i) run.readings[i][column_Fx] += 0.25 * way[i];
    }
  };
  const auto encoder = [](Experiment& experiment, const Prediction& nominal) {
    for (std::size_t r = 0; r < experiment.runs.size(); ++r)
      for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j)
          experiment.runs[r].readings[i][column_q + j] +=
              0.1 * std::sin(angle(nominal.runs[r], static_cast<Eigen::Index>(i), j));
  };
  CHECK(fitted((*rows)[0], hysteresis) - fitted((*rows)[0], nothing) == close_to(0.25).epsilon(2e-4));
  CHECK(fitted((*rows)[1], encoder) - fitted((*rows)[1], nothing) == close_to(0.1).epsilon(2e-4));
}

TEST_CASE("a stated law outside the catalogue is identified with its joint and size" *
          doctest::test_suite("long")) {
  const std::string text = effect_text("detent", "where = \"one joint\"\ntorque = \"a * sin(20 * q)\"\n",
                                       parameter("a", 0.02, -1, 1));
  const Rows rows = rows_of(std::string(text).replace(text.find("something else"), 14, "steps in joint {}"));
  const Candidate truth{{EffectAt(rows->front(), 2)}};
  const Experiment experiment = measured(full_bench(), truth, {0.04}, 11);
  const Diagnosis blind = plumbline::diagnose::diagnose(Study(experiment));
  CHECK(blind.cause.verdict != CauseVerdict::identified);
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment, rows));
  REQUIRE(diagnosis.cause.verdict == CauseVerdict::identified);
  const Candidate& found = diagnosis.cause.ranking.front().cause;
  CHECK(found == truth);
  CHECK(found.label() == "user:detent(2)");
  CHECK(found.effects[0].in_words() == "steps in joint 2");
  const Estimate& a = diagnosis.estimates[0][0];
  CHECK(a.low < 0.04);
  CHECK(a.high > 0.04);
}

TEST_CASE("without user effects the catalogue alone is considered, with unchanged probabilities") {
  const Study plain(full_bench()), other(full_bench(), rows_of(restated()[0].text));
  CHECK(possible_effects(other).size() == possible_effects(plain).size() + 1);
  CHECK(other.of(full_bench()).effects() == other.effects());
  // one more cause that might be
  CHECK(log_prior(other, only("force_gain")) < log_prior(plain, only("force_gain")));
}

TEST_CASE("guesses of shape parameters lie within their bounds, those of amounts on both sides of zero") {
  const Rows rows = rows_of(
      torque("stiffening", "a * tanh(d / b)", parameter("a", 0.2, -1, 1) + parameter("b", 0.1, 0.01, 1)));
  const Study study(full_bench(), rows);
  bool positive = false, negative = false;
  for (const std::vector<double>& start :
       rows->front().initial_guesses({study.scales(), 0}, study.excitation()).points) {
    CHECK(start[1] >= 0.01);
    CHECK(start[1] <= 1);
    positive = positive || start[0] > 0;
    negative = negative || start[0] < 0;
  }
  CHECK(positive);
  CHECK(negative);
  const Experiment experiment = measured(full_bench(), {{EffectAt(rows->front())}}, {0.15, 0.07}, 3);
  const Study read(experiment, rows);
  const Hypothesis fitted = fit_in_white_noise(read, {{EffectAt(rows->front())}});
  REQUIRE(fitted.converged);
  const MatrixXd spread = covariance(read, fitted);
  for (const auto& [p, truth] : {std::pair{0, 0.15}, {1, 0.07}})
    CHECK(std::abs(fitted.parameters[static_cast<std::size_t>(p)] - truth) < 5 * std::sqrt(spread(p, p)));
}

namespace {

std::string complaint(const std::string& text) {
  try {
    const Study study(full_bench());
    for (const StatedEffect& one : parse_effects(text, "effects.toml")) require_defined(one, study);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A torque with one parameter a.
std::string of_a(const std::string& expression, double low = -1, double high = 1) {
  return torque("mine", expression, parameter("a", 0.1, low, high));
}

}  // namespace

TEST_CASE("invalid input is refused in one line: place, found, expected") {
  CHECK(complaint(of_a("a * d")) == "");
  CHECK(
      complaint(of_a("a * d_2")) ==
      "effects.toml:6: effect[1].torque: found the unknown name \"d_2\" in \"a * d_2\", expected q, d, s, t, "
      "k, Fx, Fy, Fz, a and functions such as sin");
  const std::vector<std::pair<std::string, std::vector<std::string>>> wrong{
      {of_a("a * d +"), {"effects.toml:6: effect[1].torque", "\"a * d +\"", "expected an expression"}},
      {of_a("a * (d"), {"torque", "arenthes"}},
      {of_a("a = 3"), {"torque", "a single ="}},
      {of_a("a, d"), {"torque", "a list"}},
      {of_a("\\\"text\\\""), {"torque"}},
      {of_a(std::string(2000, '1')), {"torque", "2000 characters"}},
      {of_a("2 * d"), {"parameters", "the parameter a, which no expression uses"}},
      {of_a("a * sqrt(d - 5)"), {"mine.torque", "nan in joint 1", "a finite number"}},
      {of_a("a + d"), {"mine.torque", "a = 0", "expected zero"}},
      {of_a("a * d", 0.1, 1), {"parameters", "none that may be zero"}},
      {of_a("a * d", 1, 1), {"parameters.a.high", "low < high"}},
      {of_a("a * d", -2, -1), {"parameters.a.high", "include zero"}},
      {torque("force_gain", "a * d", parameter("a", 1, -1, 1)),
       {":3: effect[1].id", "\"force_gain\"", "catalogue"}},
      {torque("Mine", "a * d", parameter("a", 1, -1, 1)), {"effect[1].id", "lower-case"}},
      {torque("none", "a * d", parameter("a", 1, -1, 1)), {"effect[1].id", "\"none\"", "of their own"}},
      {torque("torque_law", "a * d", parameter("a", 1, -1, 1)), {"effect[1].id", "of their own"}},
      {torque("mine", "q * d", parameter("q", 1, -1, 1)), {"parameters.q", "no variable"}},
      {torque("mine", "sin * d", parameter("sin", 1, -1, 1)), {"parameters.sin", "no function"}},
      {torque("mine", "a * d", ""), {"parameters", "no such key"}},
      {torque("mine", "a * d", "[effect.parameters.a]\nunit = \"1\"\nscale = 1\nhigh = 1\n"),
       {"effects.toml:7: effect[1].parameters.a.low", "no such key"}},
      {torque("mine", "a * d", "[effect.parameters.a]\nunit = \"1\"\nscale = 0\nlow = 0\nhigh = 1\n"),
       {"parameters.a.scale", "a positive size"}},
      {torque("mine", "a * d", "[effect.parameters.a]\nunit = \"1\"\nscale = nan\nlow = 0\nhigh = 1\n"),
       {"parameters.a.scale", "nan"}},
      {torque("mine", "a * d", parameter("a", 1, -1, 1) + "tolerance = -1\n"), {"parameters.a.tolerance"}},
      {torque("mine", "a * d", parameter("a", 1, -1, 1) + "prior = 1\n"),
       {"parameters.a.prior", "an unknown key"}},
      {effect_text("mine", "", parameter("a", 1, -1, 1)), {":2", "neither torque nor reading"}},
      {effect_text("mine", "torque = \"a\"\n", parameter("a", 1, -1, 1)), {"effect[1].where", "no such key"}},
      {effect_text("mine", "where = \"one joint\"\ntorque = \"a\"\n", parameter("a", 1, -1, 1)),
       {"effect[1].words", "one {}"}},
      {effect_text("mine", "[effect.reading]\nFz = \"a\"\n", parameter("a", 1, -1, 1)),
       {"reading.Fz", "x, y"}},
      {effect_text("mine", "[effect.reading]\nq9 = \"a\"\n", parameter("a", 1, -1, 1)), {"q9", "q1 to q3"}},
      {effect_text("mine", "[effect.reading]\nFx = \"a * q\"\n", parameter("a", 1, -1, 1)),
       {"reading.Fx", "unknown name \"q\"", "expected x, y, Fx, Fy, t, run, s, a and functions"}},
      {effect_text("mine", "[effect.reading]\nq2 = \"a * k\"\n", parameter("a", 1, -1, 1)),
       {"reading.q2", "unknown name \"k\"", "expected x, y, Fx, Fy, t, run, s, q, d, a and functions"}},
      {effect_text("mine", "[effect.reading]\nFx = \"a * log(y - 9)\"\n", parameter("a", 1, -1, 1)),
       {"mine.reading.Fx", "at reading 0 of press-1"}},
      {"format = \"user-effects/1\"\n", {"effects.toml:", "effect", "at least one"}},
      {"format = \"user-effects/2\"\n", {"effects.toml:1: format", "user-effects/1"}},
      {"effect = 3\n", {"format", "no such key"}},
  };
  for (const auto& [text, parts] : wrong) {
    const std::string found = complaint(text);
    INFO(text);
    INFO(found);
    CHECK(found.find('\n') == std::string::npos);
    CHECK_FALSE(found.empty());
    for (const std::string& part : parts) CHECK(found.find(part) != std::string::npos);
  }
  const std::string twice = of_a("a * d");
  CHECK(complaint(twice + beside(twice)).find("\"mine\" again") != std::string::npos);
}

TEST_CASE("user effects of time or channels that the bench lacks are reported as not excited") {
  Experiment experiment = two_presses();
  experiment = measured(experiment, only("joint_stiffness", 2), {0.3}, 4);
  for (Run& run : experiment.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i) run.readings[i].t = static_cast<double>(i);
  const std::string text = torque("creeps", "a * log(1 + t)", parameter("a", 1e-2, -1, 1));
  const Study study(experiment, rows_of(text));
  REQUIRE_FALSE(study.scales().clock);
  const std::vector<EffectAt> idle = plumbline::diagnose::diagnose(study).not_excited;
  CHECK(
      std::any_of(idle.begin(), idle.end(), [](const EffectAt& at) { return at.label() == "user:creeps"; }));
}
