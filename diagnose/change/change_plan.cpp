#include "diagnose/change/change_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/design/design_space.hpp"
#include "diagnose/design/separation.hpp"
#include "diagnose/inference/prior.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

/// "joint_stop(2)"
EffectAt effect_in(const std::string& text) {
  const std::size_t open = text.find('(');
  std::size_t joint = 0;
  if (open != std::string::npos) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + open + 1, end, joint);
    if (error != std::errc() || stop + 1 != end || *stop != ')' || joint == 0)
      throw Error("--change", "\"" + text + "\"", "an effect, or EFFECT(JOINT)");
  }
  const std::string id = text.substr(0, open);
  return {effect(id, joint), joint};
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> all;
  const char *from = text.data(), *const end = from + text.size();
  for (bool more = true; more;) {
    double value = 0;
    const auto [stop, error] = std::from_chars(from, end, value);
    more = stop != end && *stop == ',';
    if (error != std::errc() || !std::isfinite(value) || (!more && stop != end))
      throw Error("--change", "\"" + text + "\"", "numbers with commas between them");
    all.push_back(value);
    from = stop + 1;
  }
  return all;
}

/// Readings of the nominal model in the place of what is to be measured.
Study undisturbed(const Experiment& bench) {
  return Study(measured_as(bench, simulate(bench, nominal_rig(bench), {})));
}

/// The change in the fitted coordinates of its parameters.
Instance stated_change(const Study& study, const std::string& text, std::vector<std::string>& words) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) throw Error("--change", "\"" + text + "\"", "EFFECT=VALUE");
  const EffectAt at = effect_in(text.substr(0, sign));
  const std::vector<EffectAt> possible = possible_effects(study);
  if (std::find(possible.begin(), possible.end(), at) == possible.end())
    throw Error("--change", at.label(), "an effect that can act on this bench, and that it measures");
  const std::vector<ParameterRange> ranges = study.ranges(at);
  const std::vector<double> values = numbers_in(text.substr(sign + 1));
  if (values.size() != ranges.size())
    throw Error("--change", fmt::format("{} values of {}", values.size(), at.label()),
                fmt::format("{}, one a parameter", ranges.size()));
  Instance change{{{at}}, {}};
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const ParameterRange& range = ranges[p];
    change.parameters.push_back(fitted_value(range.coordinate, values[p]));
    if (!(change.parameters[p] >= range.low && change.parameters[p] <= range.high))
      throw Error("--change", fmt::format("{} = {:g}", range.name, values[p]),
                  fmt::format("a value from {:g} to {:g}", catalogue_value(range.coordinate, range.low),
                              catalogue_value(range.coordinate, range.high)));
    const std::string unit = range.unit == "ratio" ? "" : " " + std::string(range.unit);
    words.push_back(fmt::format("{} = {:g}{}", range.name, values[p], unit));
  }
  return change;
}

/// By run, in noise of a difference.
std::vector<Repeat> repeats(const Study& study, const Instance& change) {
  const Prediction changed = predict(study, change.candidate, change.parameters);
  if (!changed.reached)
    throw Error("--change", change.candidate.label() + " of this size",
                "a change under which the chain can make the runs");
  const VectorXd difference = study.residual(changed) - study.nominal_residual();
  std::vector<Repeat> all;
  for (const Run& run : study.experiment().runs) all.push_back({run.id, 0});
  for (std::size_t i = 0; i < study.measurements().size(); ++i) {
    const double off = difference(static_cast<Eigen::Index>(i));
    all[study.measurements().places()[i].run].evidence += off * off / 4;  // twice the variance
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Repeat& a, const Repeat& b) { return a.evidence > b.evidence; });
  return all;
}

/// Expected evidence of the change over none, by its likelihood ratio.
double expected_evidence(const Study& study, const Instance& change, double ratio) {
  double evidence = ratio + log_prior(study, change.candidate);
  const std::vector<ParameterRange> ranges = study.ranges(change.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].may_be_nothing() && change.parameters[p] != 0)
      evidence -= std::log1p(2 * ratio * std::pow(ranges[p].scale / change.parameters[p], 2)) / 2;
  return evidence;
}

/// The size, over the stated one, at which all runs together show the change: their likelihood ratio grows
/// with its square.
double least_shown(const Study& study, const Instance& change, double ratio) {
  const auto shows = [&](double size) {
    Instance other = change;
    for (double& value : other.parameters) value *= size;
    return expected_evidence(study, other, size * size * ratio) > told_apart;
  };
  double low = 1e-6, high = 1e6;
  if (!shows(high)) return 0;
  while (high / low > 1.001) {
    const double middle = std::sqrt(low * high);
    (shows(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

ChangePlan plan_of_change(const Experiment& bench, const std::string& text) {
  const Study study = undisturbed(bench);
  ChangePlan plan;
  plan.experiment = bench.name;
  const Instance change = stated_change(study, text, plan.values);
  plan.change = change.candidate.effects.front().in_words();
  plan.runs = repeats(study, change);
  double ratio = 0;
  for (std::size_t r = 0; r < plan.runs.size(); ++r) {
    ratio += plan.runs[r].evidence;
    if (plan.fewest == 0 && expected_evidence(study, change, ratio) > told_apart) plan.fewest = r + 1;
  }
  plan.least = least_shown(study, change, ratio);
  return plan;
}

std::string as_text(const ChangePlan& plan) {
  std::string text = fmt::format("{}\n\nA change by {}\n", plan.experiment, plan.change);
  for (const std::string& value : plan.values) text += "  " + value + "\n";
  text += plan.fewest == 0 ? "would not be shown by these runs, each made once more\n"
                           : fmt::format("would be shown by {} of {} runs, made once more\n", plan.fewest,
                                         plan.runs.size());
  for (std::size_t r = 0; r < plan.runs.size(); ++r)
    text += fmt::format("  {}{} (expected log-likelihood ratio {:.3g})\n",
                        r < plan.fewest ? "" : "not: ", plan.runs[r].run, plan.runs[r].evidence);
  if (plan.least > 0) text += fmt::format("All of them show a change {:.2g} times as large\n", plan.least);
  return text;
}

nlohmann::ordered_json as_json(const ChangePlan& plan) {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const Repeat& one : plan.runs)
    runs.push_back({{"run", one.run}, {"log_likelihood_ratio", one.evidence}});
  return {{"format", "change-plan/1"}, {"experiment", plan.experiment}, {"change", plan.change},
          {"values", plan.values},     {"fewest", plan.fewest},         {"runs", runs},
          {"least", plan.least}};
}

}  // namespace plumbline::diagnose
