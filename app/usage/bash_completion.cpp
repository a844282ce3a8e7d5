#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/usage/usage.hpp"

namespace plumbline::app {
namespace {

/// Completions of the word at the cursor.
std::string words(const std::vector<std::string>& list) {
  return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", fmt::join(list, " "));
}
std::string bash_action(const CLI::Option& option) {
  if (const auto listed = choices(option); !listed.empty()) return words(listed);
  if (is_folder(option)) return "COMPREPLY=($(compgen -d -- \"$cur\"))";
  if (is_file(option)) return "COMPREPLY=($(compgen -f -- \"$cur\"))";
  return "COMPREPLY=()";
}

std::string bash_case(const CLI::App& verb) {
  std::string after, positional = "COMPREPLY=()";
  std::vector<std::string> all;
  for (const CLI::Option* option : verb.get_options()) {
    const std::vector<std::string> names = flags(*option);
    all.insert(all.end(), names.begin(), names.end());
    if (names.empty()) {
      positional = bash_action(*option);
    } else if (takes_value(*option)) {
      after += fmt::format("        {}) {}; [[ $cur == -* ]] || return ;;\n", fmt::join(names, "|"),
                           bash_action(*option));
    }
  }
  return fmt::format(
      "    {})\n      case \"$prev\" in\n{}      esac\n      if [[ $cur == -* ]]; then {}; else {}; fi ;;\n",
      verb.get_name(), after, words(all), positional);
}

}  // namespace

std::string bash_completion(const CLI::App& command) {
  std::vector<std::string> first;
  for (const CLI::App* verb : verbs(command)) first.push_back(verb->get_name());
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& flag : flags(*option)) first.push_back(flag);
  }
  std::string text = fmt::format(
      "# bash completion of plumbline\n_plumbline() {{\n"
      "  local cur=\"${{COMP_WORDS[COMP_CWORD]}}\" prev=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n"
      "  if [[ $COMP_CWORD -eq 1 ]]; then {}; return; fi\n  case \"${{COMP_WORDS[1]}}\" in\n",
      words(first));
  for (const CLI::App* verb : verbs(command)) text += bash_case(*verb);
  return text + "  esac\n}\ncomplete -o filenames -F _plumbline plumbline\n";
}

}  // namespace plumbline::app
