/// docs/effects.md and diagnose/rig/effects/README.md against the catalogue in code, both ways: ids, words,
/// parameters, units, ranges, and what is equivalent to what.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <plumbline/chain/kinematics.hpp>
#include <regex>
#include <sstream>

#include "diagnose/inference/study.hpp"
#include "support/files/text_file.hpp"

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using files::read_text;

namespace {

struct DocumentedParameter {
  std::string name, unit, from, to;
};

/// One of the catalogue's page: with its words in a list, with a part of them, its column's title, in the
/// table of sensors.
struct NamedEffect {
  std::string id;
  bool at_joint;
  std::string words;
  bool whole;
};

/// One of the page of numbers.
struct MeasuredEffect {
  std::string id;
  bool at_joint;
  std::vector<DocumentedParameter> parameters;
};

/// "- `id(j)`, words; `id`, words: law", and "| sensor | `id(j)` | … |" under titles.
std::vector<NamedEffect> named_effects() {
  static const std::regex item(R"(`(\w+)(\(j\))?`, ([^:;]+))"),
      cell(R"(\| *(`(\w+)(\(j\))?`|[^|]*?) *(?=\|))");
  std::vector<NamedEffect> effects;
  std::vector<std::string> titles;
  std::istringstream page(read_text(PLUMBLINE_SOURCE_DIR "/docs/effects.md"));
  for (std::string line; std::getline(page, line);) {
    const bool listed = line.starts_with("- `");
    const std::string part = listed ? line.substr(0, line.find(": ")) : line;
    std::size_t column = 0;
    for (std::sregex_iterator at(part.begin(), part.end(), listed ? item : cell), end; at != end;
         ++at, ++column) {
      const std::smatch& found = *at;
      if (listed)
        effects.push_back({found[1], found[2].matched, found[3], true});
      else if (found[2].matched)
        effects.push_back({found[2], found[3].matched, titles.at(column), false});
      else if (part.starts_with("| of |"))
        titles.push_back(found[1]);
    }
  }
  return effects;
}

struct Numbers {
  std::vector<MeasuredEffect> effects;
  std::vector<std::pair<std::string, std::string>> equivalent;
};

Numbers read_numbers() {
  static const std::regex parameter(
      R"(\| (`(\w+)(\(j\))?`(, [\w ]+)?)? \| `(\w+)` \| ([^|]*) \| ([^|]*) \| ([^|]*) \|)");
  static const std::regex pair(R"(\| `(\w+)` \| `(\w+)` \| [^|]* \|)");
  Numbers numbers;
  std::istringstream page(read_text(PLUMBLINE_SOURCE_DIR "/diagnose/rig/effects/README.md"));
  std::smatch found;
  for (std::string line; std::getline(page, line);) {
    if (std::regex_match(line, found, parameter)) {  // an empty first cell continues the one above
      if (found[1].matched) numbers.effects.push_back({found[2], found[3].matched, {}});
      numbers.effects.back().parameters.push_back({found[5], found[6], found[7], found[8]});
    } else if (std::regex_match(line, found, pair)) {
      numbers.equivalent.emplace_back(found[1], found[2]);
    }
  }
  return numbers;
}

/// Two links with end points for chosen joint angles; forces are set where a test needs them.
Experiment two_links(std::vector<double> stiffness, std::vector<double> rest,
                     const std::vector<std::vector<double>>& shapes) {
  Experiment experiment{{{0.3, 0.2}, std::move(stiffness), {0, 0}, {0, 0}, {}, {}},
                        "two links",
                        {Bench::Plane::vertical, {0.6, -0.8}, true},
                        {1e-3, 1e-3, 0.02, 0.02, 1e-3},
                        {}};
  const Chain<double> chain({0.3, 0.2}, {1, 1});
  Run run{"press", Control::end_point, std::move(rest), {}};
  for (const auto& q : shapes) {
    const Point<double> at = end_point(chain, q);
    run.readings.push_back({2.0 * static_cast<double>(run.readings.size()), {at.x, at.y, -4, 0}});
  }
  experiment.runs.push_back(run);
  return experiment;
}

/// "0.3 f L / k" with the numbers of an experiment for the symbols.
double evaluate(const std::string& expression, const std::map<std::string, double>& symbols) {
  double value = 1;
  bool divide = false;
  std::istringstream words(expression);
  for (std::string word; words >> word;) {
    if (word == "/") {
      divide = true;
      continue;
    }
    const auto symbol = symbols.find(word);
    const double factor = symbol != symbols.end() ? symbol->second : std::stod(word);
    value = divide ? value / factor : value * factor;
    divide = false;
  }
  return value;
}

/// A parameter for each value of the index that ends its name, if it does: "a_i" stands for a_1 … a_n.
std::vector<DocumentedParameter> each_value(const std::vector<DocumentedParameter>& stated,
                                            const std::string& index, std::size_t count) {
  std::vector<DocumentedParameter> all;
  const std::regex place("_" + index + R"(\b|_)" + index + "(?=_)");
  for (const DocumentedParameter& one : stated) {
    const bool each = std::regex_search(one.name, place);
    for (std::size_t i = 1; i <= (each ? count : 1); ++i) {
      all.push_back(one);
      all.back().name = std::regex_replace(one.name, place, "_" + std::to_string(i));
    }
  }
  return all;
}

std::string with_joint(const std::string& words, std::size_t joint) {
  return std::regex_replace(words, std::regex(R"(\bj\b)"), std::to_string(joint));
}

}  // namespace

TEST_CASE("the catalogue's page names every effect once, by its words, and no other") {
  std::vector<NamedEffect> named = named_effects();
  for (const Effect& row : catalogue()) {
    const std::string words = EffectAt(row, row.at_joint ? 2 : 0).in_words();
    INFO(row.id, ": ", words);
    const auto own = std::find_if(named.begin(), named.end(), [&](const NamedEffect& one) {
      const std::string said = with_joint(one.words, 2);
      return one.id == row.id && one.at_joint == row.at_joint &&
             (one.whole ? words == said : words.find(said) != std::string::npos);
    });
    REQUIRE(own != named.end());
    named.erase(own);
  }
  for (const NamedEffect& other : named)
    FAIL_CHECK("no effect of the catalogue: ", other.id, ", ", other.words);
}

TEST_CASE("places, parameters, units and ranges are those of the catalogue") {
  const Numbers numbers = read_numbers();
  const Study study(two_links({2, 1}, {0.4, -0.9}, {{0.4, -0.9}, {0.5, -1.0}, {0.6, -1.1}}));
  // By hand: the mean of 2 and 1; lengths 0.3 and 0.2; no masses; all forces 4; 0.3 4 0.5, and that over 1.5;
  // one over its square is 6.25; times 0, 2, 4.
  const std::map<std::string, double> symbols{{"k", 1.5},   {"k_j", 1.0},    {"L", 0.5},     {"l", 0.25},
                                              {"f", 4.0},   {"phi", 0.4},    {"w", 1.0},     {"c_0", 10.0},
                                              {"tau", 0.6}, {"m", 4 / 9.81}, {"m_j", 0.0},   {"T", 4.0},
                                              {"dt", 2.0},  {"q_min", -0.9}, {"q_max", -0.9}};
  REQUIRE(numbers.effects.size() == catalogue().size());
  for (std::size_t e = 0; e < catalogue().size(); ++e) {
    const MeasuredEffect& documented = numbers.effects[e];
    INFO(documented.id);
    const std::size_t joint = documented.at_joint ? 2 : 0;
    const Effect& row = catalogue()[e];
    CHECK(row.id == documented.id);
    CHECK(row.at_joint == documented.at_joint);
    const std::vector<ParameterRange> ranges = study.ranges({row, joint});
    const std::vector<DocumentedParameter> parameters =
        each_value(each_value(documented.parameters, "r", 1), "i", 2);
    REQUIRE(ranges.size() == parameters.size());
    for (std::size_t p = 0; p < ranges.size(); ++p) {
      const DocumentedParameter& stated = parameters[p];
      INFO(stated.name);
      CHECK(std::string(ranges[p].name) == stated.name);
      CHECK(std::string(ranges[p].unit) == stated.unit);
      const double low = catalogue_value(ranges[p].coordinate, ranges[p].low);
      const double high = catalogue_value(ranges[p].coordinate, ranges[p].high);
      CHECK(std::min(low, high) == close_to(evaluate(stated.from, symbols)));
      CHECK(std::max(low, high) == close_to(evaluate(stated.to, symbols)));
    }
  }
}

namespace {

/// Two effects that predict the same of an experiment without a second sensor, to a share of the largest
/// value of each channel.
struct Same {
  EffectAt first;
  std::vector<double> first_values;  ///< in the catalogue's units
  EffectAt second;
  std::vector<double> second_values;
  Experiment experiment;
  double tolerance;
};

Trace of_first_sensor(Trace trace) {
  trace.middleCols(column_Fx_2, 2) = 0;
  return trace;
}

Trace predicted(const Study& study, const EffectAt& at, std::vector<double> values) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = fitted_value(ranges[p].coordinate, values[p]);
  const Prediction prediction = predict(study, {{at}}, values);
  REQUIRE(prediction.reached);
  return of_first_sensor(prediction.runs.front());
}

std::vector<Same> same_predictions() {
  const std::vector<double> rest{0.4, -0.9};
  const std::vector<std::vector<double>> from_rest{rest, {0.45, -1.0}, {0.5, -1.1}, {0.55, -1.2}};
  const std::vector<std::vector<double>> beyond{{0.5, -1.2}, {0.55, -1.3}, {0.6, -1.4}};
  const std::vector<std::vector<double>> one_side{rest, {0.45, -0.8}, {0.5, -0.7}, {0.55, -0.6}};
  const Experiment press = two_links({2, 1.5}, rest, from_rest);
  const Experiment alike = two_links({1.5, 1.5}, rest, from_rest);
  const Experiment left = two_links({2, 1.5}, rest, one_side);
  const Experiment one_spring = two_links({0, 1.5}, rest, from_rest);
  const Experiment bent = two_links({2, 1.5}, rest, beyond);
  Experiment heavy = press;
  heavy.link_mass = {0.12, 0.08}, heavy.gravity = {0.6 * 9.81, -0.8 * 9.81};
  const double solved = 1e-8;  // equilibria are solved to ten digits
  return {
      {{"train_compliance"}, {2e-3}, {"base_compliance"}, {2e-3, 0}, press, solved},
      {{"tip_payload"}, {0.5}, {"force_bias"}, {-0.5 * 0.6, 0.5 * 0.8}, press, solved},
      {{"joint_stiffness", 2}, {0.3}, {"force_gain"}, {0.3}, one_spring, solved},
      {{"stiffness_scale"}, {0.3}, {"force_gain"}, {0.3}, press, solved},
      {{"guide_friction"}, {0.2}, {"force_bias"}, {-0.2, 0}, bent, solved},
      {{"backlash", 2}, {0.05}, {"rest_angle", 2}, {-0.05}, bent, solved},
      // The stop is touched after 0.001 rad of deflections of 0.3 rad and more.
      {{"joint_stop", 2}, {1e-3, 0.45}, {"joint_stiffness", 2}, {0.3}, bent, 1e-3 / 0.3},
      // In 6 s an arm of 1e6 s loses 6e-6 of its torque.
      {{"viscoelasticity"}, {0.3, 1e6}, {"joint_stiffness", 2}, {0.3}, one_spring, 6e-6},
      {{"mass_scale"}, {0.25}, {"gravity"}, {0.1}, heavy, solved},
      {{"asymmetric_spring"}, {0.3}, {"stiffness_scale"}, {0.3}, left, solved},
      // The spring gives way after 0.001 rad of deflections of 0.3 rad and more.
      {{"piecewise_spring", 2}, {1e-3, 0.3}, {"joint_stiffness", 2}, {-0.3}, bent, 1e-3 / 0.3},
      {{"piecewise_spring"}, {0.08, 0.4}, {"plastic_set"}, {1.5 * 0.08, 0.4 / 0.6}, alike, solved},
      {{"hysteresis"}, {0.1, 1, 0.15, 1, 0.05, 1}, {"stiffness_scale"}, {0.3}, press, solved},
      {{"relaxation_spectrum"}, {0.1, 3, 0.2, 3}, {"viscoelasticity"}, {0.3, 3}, press, solved},
      {{"tendon_friction"}, {0.1}, {"rest_angle", 2}, {-0.9 * std::expm1(-0.1)}, press, solved},
      {{"direction_friction"}, {0.02, 0.5}, {"joint_friction"}, {0.03}, left, solved},
      // No joint turns faster than 0.05 rad/s.
      {{"speed_friction"}, {0.02, 0.5, 1e7}, {"joint_friction"}, {0.03}, left, solved},
      // The cell follows within 1 ms of intervals of 2 s.
      {{"sensor_creep"}, {0.3, 1e-3}, {"force_gain"}, {0.3}, press, 0.3 * 1e-3 / 2},
      {{"run_tare"}, {0.3, -0.2}, {"force_bias"}, {0.3, -0.2}, press, solved},
      {{"stiffness_spread"}, {0.2, 0.2}, {"stiffness_scale"}, {0.2}, press, solved},
      {{"length_spread"}, {0.01, 0.01}, {"length_scale"}, {0.01}, press, solved},
      {{"rest_spread"}, {0.02, 0.02}, {"rest_offset"}, {0.02}, press, solved},
      {{"friction_spread"}, {0.02, 0.02}, {"joint_friction"}, {0.02}, press, solved},
      {{"hardening_spread"}, {0.8, 0.8}, {"nonlinear_spring"}, {0.8}, press, solved},
  };
}

}  // namespace

TEST_CASE("effects documented as equivalent predict the same, and the nominal model something else") {
  const std::vector<Same> all = same_predictions();
  std::vector<std::pair<std::string, std::string>> tested;
  for (const Same& one : all) {
    tested.emplace_back(one.first.effect->id, one.second.effect->id);
    INFO(tested.back().first, " and ", tested.back().second);
    const Study study(one.experiment);
    const Trace first = predicted(study, one.first, one.first_values);
    const Trace second = predicted(study, one.second, one.second_values);
    const Trace nominal = of_first_sensor(study.nominal().runs.front());
    const double size = nominal.abs().maxCoeff();
    CHECK((first - second).abs().maxCoeff() <= one.tolerance * size);
    CHECK((first - nominal).abs().maxCoeff() > 10 * one.tolerance * size);
  }
  CHECK(read_numbers().equivalent == tested);
}
