#pragma once
/// \file
/// Numbers and text as HTML, and templates that are filled with them.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace plumbline::page {

/// Text that stands for itself between tags and in attributes.
std::string escaped(std::string_view text);

/// How a reader wants to see a number.
enum class NumberStyle {
  figures,  ///< three significant figures: 0.0351, 1.2 × 10⁻⁷
  precise,  ///< four
  count,    ///< all digits of an integer
  percent,  ///< of a ratio: 10.5 %
  share,    ///< of a whole: 81 %, 3.2 %, < 1 %
  chance,   ///< a p-value: three figures, but nothing below 10⁻¹²
  odds      ///< of a natural logarithm: 340 to 1
};
std::string written(double value, NumberStyle style);
/// Of a p-value in plain text: "p = 0.042", "p < 1e-12".
std::string p_value(double chance);

/// The number as a reader sees it, which also says exactly what it is and where it stands in the report:
/// <data value="0.03501" data-key="/cause/effects/0/...">0.0350</data>.
std::string marked(double value, const std::string& key, NumberStyle style);

/// A report in which every number is marked, its key being its JSON pointer; everything else as it was.
/// \param style  by the JSON pointer
nlohmann::ordered_json with_marked_numbers(const nlohmann::ordered_json& report,
                                           const std::function<NumberStyle(const std::string&)>& style);

/// A mustache template filled with a view. {{text}} is escaped; {{{markup}}} is not. An empty list, an empty
/// object, null and false are no section.
/// \throws Error where the template is wrong
std::string filled(const std::string& mustache, const nlohmann::ordered_json& view);

/// The whole document around its content, with the style sheet in it.
/// \param body  markup
std::string document(const std::string& title, const std::string& description, const std::string& body);

}  // namespace plumbline::page
