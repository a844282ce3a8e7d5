#pragma once
/// \file
/// JSON, with errors in our form.

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::files {

/// \throws Error that names the source and the line
nlohmann::json parse_json(const std::string& text, const std::string& source);

/// A value of a JSON file, with the words that an error about it begins with. What a member throws is an
/// Error that names the place, what stands there and what was expected.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  [[nodiscard]] const nlohmann::json& json() const { return *json_; }
  [[nodiscard]] const std::string& place() const { return place_; }

  /// Whether this is an object with the key, and something other than null there.
  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] JsonValue at(const std::string& key, const std::string& expected) const;
  /// The entries of a list.
  [[nodiscard]] std::vector<JsonValue> list(const std::string& expected) const;
  /// The values of an object by key.
  [[nodiscard]] std::vector<std::pair<std::string, JsonValue>> members(const std::string& expected) const;
  [[nodiscard]] std::string text(const std::string& expected) const;
  [[nodiscard]] double number(const std::string& expected) const;
  /// Of an object's key; what `otherwise` says without it.
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double number_or(const std::string& key, double otherwise) const;

  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  const nlohmann::json* json_;
  std::string place_;
};

}  // namespace plumbline::files
