#include "files/toml_file.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

namespace plumbline::files {
namespace {

std::string place_of(const toml::source_region& region, const std::string& source) {
  return source + ":" + std::to_string(region.begin.line);
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& source) {
  try {
    return toml::parse(std::string_view(text), std::string_view(source));
  } catch (const toml::parse_error& error) {
    throw Error(place_of(error.source(), source),
                "text that is not TOML (" + std::string(error.description()) + ")", "key = value");
  }
}

std::string place(const toml::node& node, const std::string& source) {
  return place_of(node.source(), source);
}

void refuse_unknown_keys(const toml::table& table, const std::vector<std::string_view>& known,
                         const std::string& source) {
  std::string expected;
  for (const std::string_view key : known) expected += (expected.empty() ? "" : ", ") + std::string(key);
  for (const auto& [key, value] : table) {
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
      throw Error(place_of(key.source(), source), "the unknown key " + std::string(key.str()),
                  "only " + expected);
    }
  }
}

}  // namespace plumbline::files
