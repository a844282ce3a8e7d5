#include <fmt/format.h>

#include "app/usage/usage.hpp"

namespace plumbline::app {
namespace {

/// Text escaped for roff.
std::string plain(const std::string& text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    begins_line = c == '\n';
  }
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + plain(text) + "\\fR";
}

/// How an option is typed.
std::string form(const CLI::Option& option) {
  std::string names;
  for (const std::string& flag : flags(option)) names += (names.empty() ? "" : ", ") + bold(flag);
  if (names.empty()) return italic(option.get_name());
  return takes_value(option) ? names + " " + italic(option.get_type_name()) : names;
}

std::string entry(const CLI::Option& option) {
  std::string text = ".TP\n" + form(option) + "\n" + plain(option.get_description()) + "\n";
  const std::string standard = option.get_default_str();
  if (!standard.empty() && standard != "-") text += "Default: " + plain(standard) + ".\n";
  return text;
}

std::string synopsis(const CLI::App& verb) {
  std::string line = bold("plumbline " + verb.get_name()) + " [" + italic("options") + "]";
  for (const CLI::Option* option : verb.get_options()) {
    if (!flags(*option).empty()) continue;
    const std::string name = italic(option->get_name());
    line += option->get_required() ? " " + name : " [" + name + "]";
  }
  return line;
}

std::string verb_section(const CLI::App& verb) {
  std::string text = ".SS " + synopsis(verb) + "\n" + plain(verb.get_description()) + ".\n";
  for (const CLI::Option* option : verb.get_options()) text += entry(*option);
  if (const std::string footer = verb.get_footer(); !footer.empty()) text += ".PP\n" + plain(footer) + "\n";
  return text;
}

}  // namespace

std::string man_page(const CLI::App& command, const std::string& version) {
  std::string text = fmt::format(
      ".TH PLUMBLINE 1 \"\" \"plumbline {}\" \"User Commands\"\n.SH NAME\nplumbline \\- {}\n.SH SYNOPSIS\n"
      ".B plumbline\n.I verb\n[\\fIoptions\\fR]\n.SH DESCRIPTION\n{}\n.SH VERBS\n",
      version, "what is true of elastic serial chains under load", plain(command.get_description()));
  for (const CLI::App* verb : verbs(command)) text += verb_section(*verb);
  return text + ".SH EXIT STATUS\n" + plain(command.get_footer()) + "\n";
}

}  // namespace plumbline::app
