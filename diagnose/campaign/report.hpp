#pragma once
/// \file
/// The comparison of many diagnoses as text, JSON and HTML.

#include <string>

#include "diagnose/campaign/comparison.hpp"

namespace plumbline::campaign {

std::string as_text(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// Format "gap-campaign/1": docs/reference.md.
nlohmann::ordered_json as_json(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// The page: the answer, a table, each parameter over its experiments.
std::string as_html(const std::vector<Outcome>& outcomes, const Comparison& comparison);

/// "Yes: joint_friction in all 5", for text and page.
std::string same_cause(const std::vector<Outcome>& outcomes, const Comparison& comparison);
/// "identified joint_friction", "ambiguous a | b", or the reason of a failure.
std::string said(const Outcome& outcome);
/// A parameter in words: "0.035 N m (95 %: …); spread between sessions 0.002 …; drift …".
std::string words(const Parameter& parameter, bool by_date);
std::string date_text(const Outcome& outcome);

}  // namespace plumbline::campaign
