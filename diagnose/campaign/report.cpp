#include "diagnose/campaign/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "support/page/markup.hpp"
#include "support/page/table.hpp"

namespace plumbline::campaign {
namespace {

using Json = nlohmann::ordered_json;

std::string names(const std::vector<Outcome>& outcomes, const std::vector<std::size_t>& some) {
  std::string text;
  for (const std::size_t i : some) text += (text.empty() ? "" : ", ") + outcomes[i].name;
  return text;
}

std::string effects(const std::vector<std::string>& all) {
  return fmt::format("{}", fmt::join(all, " + "));
}

/// "0.035 N m (95 %: 0.034 to 0.036)".
std::string with_bounds(const Estimate& one, const std::string& unit) {
  return fmt::format("{:.4g}{}{} (95 %: {:.4g} to {:.4g})", one.value, unit == "ratio" ? "" : " ",
                     unit == "ratio" ? "" : unit, one.low, one.high);
}

Json as_json(const Estimate& one) {
  return {{"value", one.value}, {"low", one.low}, {"high", one.high}};
}

Json names_json(const std::vector<Outcome>& outcomes, const std::vector<std::size_t>& some) {
  Json list = Json::array();
  for (const std::size_t i : some) list.push_back(outcomes[i].name);
  return list;
}

Json as_json(const Outcome& outcome) {
  Json one{{"name", outcome.name}};
  if (outcome.date) one["date"] = date_text(outcome);
  if (!outcome.failure.empty()) {
    one["failure"] = outcome.failure;
    return one;
  }
  one["verdict"] = outcome.report.verdict;
  one["effects"] = outcome.report.effects;
  one["equivalent"] = outcome.report.equivalent;
  one["shrunk_over_floor"] = outcome.report.shrunk ? Json(*outcome.report.shrunk) : Json(nullptr);
  return one;
}

Json as_json(const Parameter& parameter, const std::vector<Outcome>& outcomes) {
  Json one{{"effect", parameter.effect},
           {"name", parameter.name},
           {"unit", parameter.unit},
           {"estimates", Json::array()}};
  for (std::size_t i = 0; i < parameter.estimates.size(); ++i) {
    Json estimate = as_json(parameter.estimates[i]);
    estimate["experiment"] = outcomes[parameter.outcomes[i]].name;
    one["estimates"].push_back(std::move(estimate));
  }
  one["mean"] = as_json(parameter.mean);
  one["spread"] = parameter.spread;
  one["p_no_spread"] = parameter.p_no_spread;
  one["drift"] = parameter.drift ? as_json(*parameter.drift) : Json(nullptr);
  return one;
}

}  // namespace

std::string date_text(const Outcome& outcome) {
  if (!outcome.date) return "";
  const std::chrono::year_month_day day(*outcome.date);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

std::string said(const Outcome& outcome) {
  if (!outcome.failure.empty()) return "failed";
  std::string text = outcome.report.verdict;
  if (!outcome.report.effects.empty()) text += " " + effects(outcome.report.effects);
  for (const std::vector<std::string>& other : outcome.report.equivalent) text += " or " + effects(other);
  if (outcome.report.effects.empty()) return text;
  return text + (outcome.report.sense == "added"     ? ", came"
                 : outcome.report.sense == "removed" ? ", went"
                                                     : "");
}

std::string same_cause(const std::vector<Outcome>& outcomes, const Comparison& comparison) {
  const std::size_t diagnosed = outcomes.size() - comparison.failed;
  if (diagnosed == 0) return "nothing was diagnosed";
  const Cause& first = comparison.causes.front();
  const std::string what =
      first.effects == std::vector<std::string>{"none"} ? "no gap" : effects(first.effects);
  if (first.named_by.size() == diagnosed) return fmt::format("yes: {} in all {}", what, diagnosed);
  if (first.named_by.size() + first.allowed_by.size() == diagnosed)
    return fmt::format("it may be: {} is named in {} of {}, and in the class of the others ({})", what,
                       first.named_by.size(), diagnosed, names(outcomes, first.allowed_by));
  std::string text = "no";
  for (const Cause& cause : comparison.causes) {
    if (cause.named_by.empty()) continue;
    text += fmt::format("{} {} in {} ({})", text == "no" ? ":" : ";", effects(cause.effects),
                        cause.named_by.size(), names(outcomes, cause.named_by));
  }
  return text;
}

std::string words(const Parameter& parameter, bool by_date) {
  std::string text = with_bounds(parameter.mean, parameter.unit) + "; ";
  constexpr double level = 0.01;
  text += parameter.p_no_spread < level
              ? fmt::format("spread between sessions {:.2g} beyond their bounds ({})", parameter.spread,
                            page::p_value(parameter.p_no_spread))
              : fmt::format("no spread between sessions beyond their bounds ({})",
                            page::p_value(parameter.p_no_spread));
  if (!parameter.drift) return text;
  const char* step = by_date ? "a day" : "from one to the next";
  const bool drifts = parameter.drift->low > 0 || parameter.drift->high < 0;
  return text + fmt::format("; {} {} {}", drifts ? "drift" : "no significant drift,",
                            with_bounds(*parameter.drift, parameter.unit), step);
}

std::string as_text(const std::vector<Outcome>& outcomes, const Comparison& comparison) {
  page::Table table{{"experiment", "date", "verdict", "residual over noise floor"}, {}};
  for (const Outcome& one : outcomes)
    table.rows.push_back(
        {one.name, one.date ? date_text(one) : "-", said(one),
         one.failure.empty() && one.report.shrunk ? fmt::format("{:.3g}", *one.report.shrunk) : "-"});
  std::string text = fmt::format("{} experiments\n\n{}\n", outcomes.size(), page::terminal_table(table));
  text += "The same cause?  " + same_cause(outcomes, comparison) + "\n";
  if (!comparison.parameters.empty()) text += "\nParameters, where the cause is identified in two or more\n";
  for (const Parameter& one : comparison.parameters)
    text += fmt::format("  {} {} (of {}): {}\n", one.effect, one.name, one.estimates.size(),
                        words(one, comparison.by_date));
  if (comparison.failed > 0) text += "\nFailed\n";
  for (const Outcome& one : outcomes)
    if (!one.failure.empty()) text += fmt::format("  {}: {}\n", one.name, one.failure);
  return text;
}

Json as_json(const std::vector<Outcome>& outcomes, const Comparison& comparison) {
  Json report{{"format", "gap-campaign/1"},
              {"experiments", Json::array()},
              {"causes", Json::array()},
              {"same_cause", same_cause(outcomes, comparison)}};
  for (const Outcome& one : outcomes) report["experiments"].push_back(as_json(one));
  for (const Cause& cause : comparison.causes)
    report["causes"].push_back({{"effects", cause.effects},
                                {"named_by", names_json(outcomes, cause.named_by)},
                                {"allowed_by", names_json(outcomes, cause.allowed_by)}});
  report["drift_by"] = comparison.by_date ? "day" : "order";
  report["parameters"] = Json::array();
  for (const Parameter& one : comparison.parameters) report["parameters"].push_back(as_json(one, outcomes));
  return report;
}

}  // namespace plumbline::campaign
