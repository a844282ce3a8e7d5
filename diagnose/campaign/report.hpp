#pragma once
/// \file
/// The comparison of many diagnoses as text, JSON and HTML.

#include <string>

#include "diagnose/campaign/comparison.hpp"
#include "diagnose/campaign/since.hpp"

namespace plumbline::campaign {

std::string as_text(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// Format "gap-campaign/1": docs/schemas/gap-campaign.schema.json.
nlohmann::ordered_json as_json(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// The page: the answer, a table, each parameter over its experiments.
/// \param since  of outcomes in the order of time; else none
std::string as_html(const std::vector<Outcome>& outcomes, const Comparison& comparison,
                    const std::vector<Since>& since = {});

/// "Since when?", an effect a line.
std::string as_text(const std::vector<Since>& since, const std::vector<Outcome>& outcomes);
nlohmann::ordered_json as_json(const std::vector<Since>& since, const std::vector<Outcome>& outcomes);

/// "Yes: joint_friction in all 5", for text and page.
std::string same_cause(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// "identified joint_friction", "ambiguous a | b", or the reason of a failure.
std::string said(const Outcome& outcome);
/// A parameter in words: "0.035 N m (95 %: …); spread between sessions 0.002 …; drift …".
std::string words(const Parameter& parameter, bool by_date);
std::string date_text(const Outcome& outcome);
/// "since day-3 (2026-05-03), 2 of 4: tau_c 0.05 N m (95 %: …), then 0.06 …".
std::string words(const Since& since, const std::vector<Outcome>& outcomes);

}  // namespace plumbline::campaign
