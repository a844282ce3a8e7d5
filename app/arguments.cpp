#include "app/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

/// Whether all of the text is a number of this type; a sign is taken for what it is.
template <class Number>
bool reads(const std::string& text, Number& value) {
  const char* const first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last && end != first;
}

std::string refusal(const std::string& found, const std::string& expected) {
  return fmt::format("found {}, expected {}", found.empty() ? "nothing" : files::shown(found), expected);
}

/// The option that a message of the parser is about.
std::string option_in(const std::string& message) {
  const std::size_t at = message.find("--");
  const std::size_t start = at == std::string::npos ? 0 : at;
  return message.substr(start, message.find_first_of(" :,", start) - start);
}

std::string behind(const std::string& message, const std::string& words) {
  const std::size_t at = message.find(words);
  return at == std::string::npos ? "" : message.substr(at + words.size());
}

constexpr const char* output_group = "Output";

/// A word as a shell takes it.
std::string in_shell(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c >= 0x80 ||
           std::string_view("_@%+=:,./-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted;
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return "'" + quoted + "'";
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const bool bounded = high < std::numeric_limits<std::uint64_t>::max();
  const std::string range = bounded ? fmt::format("{} to {}", low, high) : fmt::format("{} or more", low);
  return {[=](std::string& text) {
            std::uint64_t value = 0;
            const bool good = reads(text, value) && low <= value && value <= high;
            return good ? "" : refusal(text, "a whole number, " + range);
          },
          range};
}

CLI::Validator number(double low, double high) {
  const bool bounded = high < std::numeric_limits<double>::max();
  const std::string range = bounded ? fmt::format("{:g} to {:g}", low, high) : "";
  return {[=](std::string& text) {
            double value = 0;
            const bool good = reads(text, value) && std::isfinite(value) && low <= value && value <= high;
            return good ? "" : refusal(text, bounded ? "a number, " + range : "a finite number");
          },
          range};
}

CLI::Validator something() {
  return {[](std::string& text) {
            return text.empty() ? "found an empty text, expected a value, or nothing at all" : "";
          },
          ""};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const std::string list = fmt::format("{}", fmt::join(words, " or "));
  return {[=](std::string& text) {
            return std::find(words.begin(), words.end(), text) != words.end() ? "" : refusal(text, list);
          },
          list};
}

CLI::Option* as_pair(CLI::Option* option, const std::string& names) {
  // a word behind them is no value, but the verb's file
  return option->type_name(names)->delimiter(',')->expected(2)->allow_extra_args(false);
}

std::vector<std::string> names_in(const std::string& list) {
  return list.empty() ? std::vector<std::string>{} : CLI::detail::split(list, ',');
}

CLI::Option* add_output(CLI::App& verb, const std::string& name, std::string& path, const std::string& what,
                        const std::string& type) {
  return verb.add_option(name, path, what)->type_name(type)->group(output_group);
}

CLI::Option* add_printed_output(CLI::App& verb, const std::string& name, std::string& path,
                                const std::string& what) {
  return add_output(verb, name, path, what, "[FILE]")->expected(0, 1)->default_str("-");
}

std::string asked(const CLI::App& verb, const std::vector<std::filesystem::path>& inputs) {
  std::string command = "plumbline " + verb.get_name();
  std::vector<const CLI::Option*> told;
  for (const CLI::Option* option : verb.parse_order()) {
    if (std::find(told.begin(), told.end(), option) != told.end()) continue;
    told.push_back(option);
    const std::vector<std::string>& values = option->results();
    const bool is_input = std::find(inputs.begin(), inputs.end(), values.front()) != inputs.end();
    if (option->get_group() == output_group && !is_input) continue;
    if (!option->get_positional()) command += " " + option->get_name();
    if (option->get_items_expected_max() == 0) continue;  // a flag
    if (option->get_delimiter() != '\0')
      command += " " + fmt::format("{}", fmt::join(values, std::string(1, option->get_delimiter())));
    else
      for (const std::string& value : values) command += " " + in_shell(value);
  }
  return command;
}

std::string in_our_words(const CLI::ParseError& error) {
  const std::string said = error.what();
  // Its name may be that of the verb.
  const auto is = [&](CLI::ExitCodes kind) { return error.get_exit_code() == static_cast<int>(kind); };
  if (is(CLI::ExitCodes::ValidationError)) return said;
  if (is(CLI::ExitCodes::ExtrasError))
    return fmt::format("command line: {}", refusal(behind(said, "not expected: "), "what --help lists"));
  if (is(CLI::ExitCodes::RequiredError)) return option_in(said) + ": found nothing, expected a value";
  if (is(CLI::ExitCodes::ExcludesError))
    return fmt::format("{}: found it beside {}, expected one of the two", option_in(said),
                       behind(said, "excludes "));
  if (is(CLI::ExitCodes::ArgumentMismatch))
    return option_in(said) + ": found too few or too many values, expected as many as --help says";
  return fmt::format("{}: found what cannot be read, expected what --help says", option_in(said));
}

}  // namespace plumbline::app
