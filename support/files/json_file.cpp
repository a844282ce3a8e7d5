#include "support/files/json_file.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::files {

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto start = std::find(std::reverse_iterator(end), text.rend(), '\n').base();
    throw Error(source + ":" + std::to_string(1 + std::count(text.begin(), start, '\n')),
                end == text.end() ? "an end in the middle" : "text that is not JSON: " + shown({start, end}),
                "JSON");
  } catch (const nlohmann::json::exception&) {
    throw Error(source, "a number beyond double precision", "JSON");
  }
}

void JsonValue::refuse(const std::string& expected) const {
  throw Error(place_, shown(json_->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)), expected);
}

bool JsonValue::has(const std::string& key) const {
  return json_->is_object() && json_->contains(key) && !(*json_)[key].is_null();
}

JsonValue JsonValue::at(const std::string& key, const std::string& expected) const {
  if (!json_->is_object()) refuse("an object with \"" + key + "\"");
  if (!json_->contains(key)) throw Error(place_, "no key \"" + key + "\"", expected);
  return {(*json_)[key], place_ + ", " + shown(key)};
}

std::vector<JsonValue> JsonValue::list(const std::string& expected) const {
  if (!json_->is_array()) refuse(expected);
  std::vector<JsonValue> values;
  for (const nlohmann::json& one : *json_)
    values.emplace_back(one, place_ + "[" + std::to_string(values.size() + 1) + "]");
  return values;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members(const std::string& expected) const {
  if (!json_->is_object()) refuse(expected);
  std::vector<std::pair<std::string, JsonValue>> values;
  for (const auto& [key, value] : json_->items())
    values.emplace_back(key, JsonValue(value, place_ + ", " + shown(key)));
  return values;
}

std::string JsonValue::text(const std::string& expected) const {
  if (!json_->is_string()) refuse(expected);
  std::string text = json_->get<std::string>();
  require_printable(text, place_);
  return text;
}

double JsonValue::number(const std::string& expected) const {
  if (!json_->is_number()) refuse(expected);
  return json_->get<double>();
}

std::string JsonValue::text_or(const std::string& key, const std::string& otherwise) const {
  return has(key) ? at(key, "").text("text") : otherwise;
}

double JsonValue::number_or(const std::string& key, double otherwise) const {
  return has(key) ? at(key, "").number("a number") : otherwise;
}

}  // namespace plumbline::files
