#include "diagnose/campaign/since.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "diagnose/campaign/report.hpp"

namespace plumbline::campaign {
namespace {

std::set<std::string> effects_of(const StatedReport& report) {
  std::set<std::string> all(report.effects.begin(), report.effects.end());
  for (const std::vector<std::string>& other : report.equivalent) all.insert(other.begin(), other.end());
  all.erase("unknown");
  return all;
}

/// "tau_c 0.05 N m (95 %: 0.04 to 0.06)" of every parameter of the effect; empty where none is estimated.
std::string sizes(const std::string& effect, const StatedReport& report) {
  std::string text;
  for (const auto& [key, one] : report.bounds)
    if (const std::string before = parameter_key(effect, ""); key.rfind(before, 0) == 0)
      text += fmt::format("{}{} {:.4g}{} (95 %: {:.4g} to {:.4g})", text.empty() ? "" : ", ",
                          key.substr(before.size()), one.value, one.unit == "ratio" ? "" : " " + one.unit,
                          one.low, one.high);
  return text;
}

}  // namespace

std::vector<Since> since_when(const std::vector<Outcome>& outcomes) {
  std::vector<Since> all;
  std::set<std::string> lasting;
  std::optional<std::size_t> later;
  for (std::size_t i = outcomes.size(); i-- > 0;) {
    if (!outcomes[i].failure.empty()) continue;
    const std::set<std::string> here = effects_of(outcomes[i].report);
    if (!later) lasting = here;
    std::erase_if(lasting, [&](const std::string& effect) {
      if (here.contains(effect)) return false;
      all.push_back({effect, *later});
      return true;
    });
    later = i;
  }
  for (const std::string& effect : lasting) all.push_back({effect, *later});
  std::reverse(all.begin(), all.end());
  return all;
}

std::string words(const Since& since, const std::vector<Outcome>& outcomes) {
  const Outcome& first = outcomes[since.first];
  std::string text = "since " + first.name;
  if (first.date) text += fmt::format(" ({})", date_text(first));
  if (const std::string size = sizes(since.effect, first.report); !size.empty()) text += ": " + size;
  const std::string last = sizes(since.effect, outcomes.back().report);
  if (since.first + 1 < outcomes.size() && !last.empty())
    text += fmt::format("; at last, in {}: {}", outcomes.back().name, last);
  return text;
}

std::string as_text(const std::vector<Since>& since, const std::vector<Outcome>& outcomes) {
  if (since.empty()) return "Since when?  Nothing is there in the last data set that was not in the first\n";
  std::string text = "Since when?\n";
  for (const Since& one : since) text += fmt::format("  {} {}\n", one.effect, words(one, outcomes));
  return text;
}

nlohmann::ordered_json as_json(const std::vector<Since>& since, const std::vector<Outcome>& outcomes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Since& one : since) {
    list.push_back({{"effect", one.effect}, {"since", outcomes[one.first].name}});
    if (outcomes[one.first].date) list.back()["date"] = date_text(outcomes[one.first]);
  }
  return list;
}

}  // namespace plumbline::campaign
