#include "support/files/toml_file.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/nearest.hpp"
#include "support/files/printable.hpp"

namespace plumbline::files {
namespace {

std::string place_of(const toml::source_region& region, const std::string& source) {
  return source + ":" + std::to_string(region.begin.line);
}

/// Behind the string that begins at `at`, on one line or on several.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool several = text.substr(at).starts_with(std::string(3, quote));
  const std::string_view closing = text.substr(at, several ? 3 : 1);
  for (at += closing.size(); at < text.size(); ++at) {
    if (text.substr(at).starts_with(closing)) return at + closing.size();
    if (text[at] == '\n' && !several) return at;
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return text.size();
}

/// Every part of a dotted key is a table in the one before, and the parser goes down them by recursion. It
/// limits brackets itself.
/// \throws Error that names the line
void refuse_long_keys(std::string_view text, const std::string& source) {
  constexpr std::size_t most = 8;
  std::size_t dots = 0, line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const bool quoted = c == '"' || c == '\'';
    const std::size_t end = quoted     ? std::max(end_of_string(text, at), at + 1)
                            : c == '#' ? std::min(text.find('\n', at), text.size())
                                       : at + 1;
    if (c == '.' && ++dots == most)
      throw Error(source + ":" + std::to_string(line),
                  "a key of more than " + std::to_string(most) + " parts", "key = value");
    if (std::string_view(",=[]{}\n").find(c) != std::string_view::npos) dots = 0;
    line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at = end;
  }
}

std::string line_of(const std::string& text, std::size_t number) {
  std::size_t at = 0;
  for (std::size_t line = 1; line < number && at < text.size(); ++line)
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return text.substr(at, text.find('\n', at) - at);
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& source) {
  refuse_long_keys(text, source);
  try {
    return toml::parse(std::string_view(text), std::string_view(source));
  } catch (const toml::parse_error& error) {
    const std::string line = shown(line_of(text, error.source().begin.line));
    if (error.description().find("redefine") != std::string_view::npos)
      throw Error(place_of(error.source(), source), "a key or table again: " + line, "every one once");
    throw Error(place_of(error.source(), source), "text that is not TOML: " + line, "key = value");
  }
}

std::string place(const toml::node& node, const std::string& source) {
  return place_of(node.source(), source);
}

void refuse_unknown_keys(const toml::table& table, const std::vector<std::string_view>& known,
                         const std::string& source, const std::vector<std::string_view>& synonyms) {
  const auto among = [](const std::vector<std::string_view>& keys, const toml::key& key) {
    return std::find(keys.begin(), keys.end(), key.str()) != keys.end();
  };
  for (const auto& [key, value] : table) {
    if (!among(known, key) && !among(synonyms, key))
      throw Error(place_of(key.source(), source), "the unknown key " + shown(key.str()),
                  expected_word(key.str(), {known.begin(), known.end()}));
  }
}

}  // namespace plumbline::files
