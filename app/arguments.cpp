#include "app/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "files/printable.hpp"

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

CLI::Validator one_of(const std::vector<std::string>& words) {
  const std::string list = fmt::format("{}", fmt::join(words, " or "));
  return {[=](std::string& text) {
            return std::find(words.begin(), words.end(), text) != words.end() ? "" : refusal(text, list);
          },
          list};
}

std::string in_our_words(const CLI::ParseError& error) {
  const std::string said = error.what();
  const auto is = [&](const char* kind) { return error.get_name() == kind; };
  if (is("ValidationError")) return said;
  if (is("ExtrasError"))
    return fmt::format("command line: {}", refusal(behind(said, "not expected: "), "what --help lists"));
  if (is("RequiredError")) return option_in(said) + ": found nothing, expected a value";
  if (is("ExcludesError"))
    return fmt::format("{}: found it beside {}, expected one of the two", option_in(said),
                       behind(said, "excludes "));
  if (is("ArgumentMismatch"))
    return option_in(said) + ": found too few or too many values, expected as many as --help says";
  return fmt::format("{}: found what cannot be read, expected what --help says", option_in(said));
}

}  // namespace plumbline::app
