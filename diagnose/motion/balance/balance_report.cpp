#include "diagnose/motion/balance/balance_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnose/report/view.hpp"

namespace plumbline::motion {
namespace {

bool is_excluded(const BalanceNumber& one) {
  return one.stated < one.low || one.stated > one.high;
}

/// Changes that are not improbable beside the first.
std::string causes_text(const Balance& balance) {
  constexpr double named = 0.01;
  std::string text =
      "\nWhich single change of the model explains the torques?  With frictions of each joint\n";
  for (const BalanceCause& one : balance.causes) {
    if (one.probability < named) continue;
    text += fmt::format("  {:>7}  {}", diagnose::probability_in_words(one.probability), one.words);
    for (const CauseNumber& number : one.numbers)
      text += fmt::format(": {} = {:.4g}{} (95 %: {:.4g} to {:.4g})", number.name, number.value,
                          number.unit == "ratio" ? "" : " " + number.unit, number.low, number.high);
    text += fmt::format("; {:.3g} N m left by joint\n", fmt::join(one.left, " "));
  }
  return text;
}

}  // namespace

std::string as_text(const Balance& balance) {
  std::string text = fmt::format("{}\n\nWhich inertias and frictions?  Of {} logs with {} readings\n",
                                 balance.name, balance.logs, balance.readings);
  for (const BalanceNumber& one : balance.numbers)
    text +=
        fmt::format("  {} = {:.4g} {} (95 %: {:.4g} to {:.4g}); the model has {:.4g}{}\n", one.name,
                    one.value, one.unit, one.low, one.high, one.stated, is_excluded(one) ? ", outside" : "");
  if (balance.lead != 0)
    text += fmt::format("  the torque is {:.0f} ms {} the motion\n", 1e3 * std::abs(balance.lead),
                        balance.lead > 0 ? "ahead of" : "behind");
  for (const std::string& one : balance.contradictions)
    text += fmt::format("  the model contradicts itself: {}, as no body has\n", one);
  text += causes_text(balance);
  text += "\nHow much torque is left?  By joint, N m, root mean square\n";
  for (const TorqueLeft& one : balance.left)
    text += fmt::format("  {}{}: {:.3g} in all, {:.3g} less the model's, {:.3g} less what was found\n",
                        one.log, one.held_out ? " (held out)" : "", fmt::join(one.whole, " "),
                        fmt::join(one.stated, " "), fmt::join(one.found, " "));
  return text;
}

nlohmann::ordered_json as_json(const Balance& balance) {
  nlohmann::ordered_json json{{"format", "torque-report/1"},
                              {"name", balance.name},
                              {"lead", balance.lead},
                              {"numbers", nlohmann::ordered_json::array()},
                              {"left", nlohmann::ordered_json::array()}};
  for (const BalanceNumber& one : balance.numbers)
    json["numbers"].push_back({{"name", one.name},
                               {"unit", one.unit},
                               {"value", one.value},
                               {"interval_95", {one.low, one.high}},
                               {"stated", one.stated}});
  for (const TorqueLeft& one : balance.left)
    json["left"].push_back({{"log", one.log},
                            {"held_out", one.held_out},
                            {"whole", one.whole},
                            {"stated", one.stated},
                            {"found", one.found}});
  json["contradictions"] = balance.contradictions;
  json["causes"] = nlohmann::ordered_json::array();
  for (const BalanceCause& one : balance.causes) {
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (const CauseNumber& number : one.numbers)
      numbers.push_back({{"name", number.name},
                         {"unit", number.unit},
                         {"value", number.value},
                         {"interval_95", {number.low, number.high}}});
    json["causes"].push_back({{"effect", one.id},
                              {"words", one.words},
                              {"probability", one.probability},
                              {"parameters", numbers},
                              {"left", one.left}});
  }
  return json;
}

}  // namespace plumbline::motion
