#include "diagnose/draft/json_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <plumbline/base/error.hpp>
#include <sstream>
#include <vector>

#include "support/files/csv_file.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;
using Fields = std::map<std::string, std::string>;

/// The values of a reading by their names, and the names in their order.
void flatten(const Json& value, const std::string& name, Fields& fields, std::vector<std::string>& names) {
  if (value.is_object()) {
    for (const auto& [key, part] : value.items())
      flatten(part, name.empty() ? key : name + "." + key, fields, names);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      flatten(value[i], fmt::format("{}{}", name, i + 1), fields, names);
  } else {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    if (!value.is_null()) fields[name] = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

Json parsed(const std::string& text, const std::string& place) {
  Json value = Json::parse(text, nullptr, false);
  if (value.is_discarded() || !value.is_structured())
    throw Error(place, files::shown(text.substr(0, 40)), "an object of JSON, a reading a line");
  return value;
}

std::vector<Json> readings_in(const std::string& text, const std::string& source) {
  if (text[text.find_first_not_of(" \t\r\n")] == '[') {
    const Json list = parsed(text, source);
    return {list.begin(), list.end()};
  }
  std::vector<Json> all;
  std::istringstream in(text);
  std::size_t number = 1;
  for (std::string line; std::getline(in, line); ++number)
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      all.push_back(parsed(line, fmt::format("{}:{}", source, number)));
  return all;
}

}  // namespace

bool is_json_lines(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  const std::size_t second = text.find_first_not_of(" \t\r\n", first + 1);
  if (second == std::string::npos) return false;
  return (text[first] == '{' && text[second] == '"') || (text[first] == '[' && text[second] == '{');
}

std::string csv_of_json_lines(const std::string& text, const std::string& source) {
  std::vector<std::string> names;
  std::vector<Fields> rows;
  for (const Json& reading : readings_in(text, source)) flatten(reading, "", rows.emplace_back(), names);
  std::vector<std::string> header;
  for (const std::string& name : names) header.push_back(files::csv_field(name));
  std::string csv = fmt::format("{}\n", fmt::join(header, ","));
  for (const Fields& row : rows) {
    std::vector<std::string> fields;
    for (const std::string& name : names)
      fields.push_back(row.contains(name) ? files::csv_field(row.at(name)) : "");
    csv += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return csv;
}

}  // namespace plumbline::diagnose
