#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/usage/usage.hpp"

namespace plumbline::app {
namespace {

/// Text within single quotes of the shell, where brackets and colons are _arguments' own.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      result += std::string("\\") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string zsh_action(const CLI::Option& option) {
  if (const auto listed = choices(option); !listed.empty())
    return fmt::format("({})", fmt::join(listed, " "));
  if (is_folder(option)) return "_files -/";
  if (is_file(option)) return "_files";
  return " ";
}

/// A line for _arguments.
std::string specification(const CLI::Option& option, const std::string& flag) {
  const std::string value = fmt::format(
      "{}:{}", quoted(flag.empty() ? option.get_name() : option.get_type_name()), zsh_action(option));
  if (flag.empty()) return fmt::format("'{}:{}'", option.get_required() ? "" : ":", value);
  const std::string described = fmt::format("{}[{}]", flag, quoted(option.get_description()));
  if (!takes_value(option)) return fmt::format("'{}'", described);
  return fmt::format("'{}{}{}'", described, option.get_expected_min() == 0 ? "::" : ":", value);
}

std::string zsh_case(const CLI::App& verb) {
  std::string text = fmt::format("    {})\n      _arguments", verb.get_name());
  for (const CLI::Option* option : verb.get_options()) {
    const std::vector<std::string> names = flags(*option);
    if (names.empty()) text += " \\\n        " + specification(*option, "");
    for (const std::string& flag : names) text += " \\\n        " + specification(*option, flag);
  }
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& command) {
  std::string text = "#compdef plumbline\n_plumbline() {\n  local -a verbs=(\n";
  for (const CLI::App* verb : verbs(command))
    text += fmt::format("    '{}:{}'\n", verb->get_name(), quoted(verb->get_description()));
  text +=
      "  )\n  if (( CURRENT == 2 )); then _describe verb verbs; return; fi\n"
      "  local verb=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $verb in\n";
  for (const CLI::App* verb : verbs(command)) text += zsh_case(*verb);
  return text + "  esac\n}\n_plumbline \"$@\"\n";
}

}  // namespace plumbline::app
