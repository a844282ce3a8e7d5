#include "support/page/markup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <kainjow/mustache.hpp>
#include <plumbline/base/error.hpp>

#include "support/page/frame_texts.hpp"

namespace plumbline::page {
namespace {

namespace mustache = kainjow::mustache;
using Json = nlohmann::ordered_json;

/// "1.2e-07" as "1.2 × 10⁻⁷", with a true minus sign.
std::string typeset(const std::string& number) {
  static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t e = number.find('e');
  std::string text = number.substr(0, e);
  if (text[0] == '-') text.replace(0, 1, "−");
  if (e == std::string::npos) return text;
  const int exponent = std::stoi(number.substr(e + 1));
  text += exponent < 0 ? " × 10⁻" : " × 10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[digit - '0'];
  return text;
}

std::string percent(double share) {
  const double hundredth = 100 * share;
  if (hundredth > 0 && hundredth < 0.01) return "< 0.01 %";
  if (hundredth >= 99.95 && hundredth <= 100) return "> 99.9 %";
  return typeset(hundredth > 100 ? fmt::format("{:.0f}", hundredth) : fmt::format("{:.3g}", hundredth)) +
         " %";
}

std::string odds(double logarithm) {
  if (logarithm > std::log(1e6)) return "over a million to 1";
  return typeset(fmt::format("{:.3g}", std::exp(logarithm))) + " to 1";
}

/// Of a smaller one the digits say how far a distribution's tail was followed, not how sure anything is.
constexpr double least_chance = 1e-12;

mustache::data converted(const Json& value) {
  if (value.is_object()) {
    mustache::data object(mustache::data::type::object);
    for (const auto& [key, part] : value.items()) object.set(key, converted(part));
    return value.empty() ? mustache::data(false) : object;
  }
  if (value.is_array()) {
    mustache::data list(mustache::data::type::list);
    for (const Json& part : value) list << converted(part);
    return list;
  }
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.dump();
  return value.is_boolean() && value.get<bool>();
}

}  // namespace

std::string escaped(std::string_view text) {
  return mustache::html_escape(std::string(text));
}

std::string written(double value, NumberStyle style) {
  switch (style) {
    case NumberStyle::figures:
      break;
    case NumberStyle::precise:
      return typeset(fmt::format("{:.4g}", value));
    case NumberStyle::count:
      return fmt::format("{:.0f}", value);
    case NumberStyle::percent:
      return percent(value);
    case NumberStyle::share:
      return value < 0.01 ? "< 1 %" : fmt::format("{:.{}f} %", 100 * value, value < 0.0995 ? 1 : 0);
    case NumberStyle::chance:
      return value < least_chance ? "< 10⁻¹²" : typeset(fmt::format("{:.3g}", value));
    case NumberStyle::odds:
      return odds(value);
  }
  return typeset(fmt::format("{:.3g}", value));
}

std::string p_value(double chance) {
  return chance < least_chance ? fmt::format("p < {:.0e}", least_chance) : fmt::format("p = {:.2g}", chance);
}

std::string marked(double value, const std::string& key, NumberStyle style) {
  return fmt::format(R"(<data value="{}" data-key="{}">{}</data>)", Json(value).dump(), escaped(key),
                     escaped(written(value, style)));
}

Json with_marked_numbers(const Json& report, const std::function<NumberStyle(const std::string&)>& style) {
  const std::function<Json(const Json&, const Json::json_pointer&)> walk =
      [&](const Json& value, const Json::json_pointer& at) -> Json {
    if (value.is_number()) {
      const std::string key = at.to_string();
      return marked(value.get<double>(), key, style(key));
    }
    if (!value.is_structured()) return value;
    Json result = value;
    for (const auto& [key, part] : value.items()) {
      if (value.is_object()) result[key] = walk(part, at / key);
      if (value.is_array()) result[std::stoul(key)] = walk(part, at / std::stoul(key));
    }
    return result;
  };
  return walk(report, Json::json_pointer());
}

std::string filled(const std::string& text, const Json& view) {
  mustache::mustache page(text);
  if (!page.is_valid()) throw Error("page template", page.error_message(), "a mustache template");
  return page.render(converted(view));
}

std::string document(const std::string& title, const std::string& description, const std::string& body) {
  return filled(frame_template, {{"title", title},
                                 {"description", description},
                                 {"style", std::string(chart_style) + style_sheet},
                                 {"body", body}});
}

}  // namespace plumbline::page
