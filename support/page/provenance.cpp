#include "support/page/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <sstream>

#include "support/page/markup.hpp"

namespace plumbline::page {
namespace {

/// "; of inputs with the SHA-256 …", or nothing.
std::string words_for_inputs(const Provenance& from) {
  return from.inputs.empty() ? "" : "; SHA-256 of its inputs: " + from.inputs;
}

/// Of a fleet the folders would fill the page.
std::string brief(const std::string& command) {
  constexpr std::size_t most = 400;
  return command.size() <= most ? command : command.substr(0, command.rfind(' ', most)) + " …";
}

/// Files by their names: a page that is handed on tells nobody whose folders they were in.
std::string without_folders(const std::string& command) {
  std::string result, word;
  std::istringstream in(command);
  while (in >> word) {
    const std::size_t last = word.find_last_not_of('/'), slash = word.rfind('/', last);
    if (slash != std::string::npos && last != std::string::npos) word = word.substr(slash + 1, last - slash);
    result += (result.empty() ? "" : " ") + word;
  }
  return result;
}

/// As reproducible builds have it: https://reproducible-builds.org/specs/source-date-epoch/
std::string date() {
  const char* const set = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = set == nullptr ? std::time(nullptr) : std::strtoll(set, nullptr, 10);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(seconds));
}

}  // namespace

std::string json_text(nlohmann::ordered_json object, const Provenance& provenance) {
  nlohmann::ordered_json inputs;
  if (!provenance.inputs.empty()) inputs = provenance.inputs;
  object["provenance"] = {
      {"program", provenance.program}, {"command", provenance.command}, {"inputs_sha256", inputs}};
  return object.dump(2) + "\n";
}

std::string on_page(std::string html, const Provenance& provenance) {
  const std::string line =
      fmt::format("<p class=\"quiet provenance\">Made on {} by {}: <code>{}</code>{}.</p>\n", date(),
                  escaped(provenance.program), escaped(brief(without_folders(provenance.command))),
                  words_for_inputs(provenance));
  const std::size_t footer = html.rfind("</footer>");
  if (footer != std::string::npos) return html.insert(footer, line);
  return html.insert(html.rfind("</body>"), "<footer>\n" + line + "</footer>\n");
}

std::string in_drawing(std::string svg, const Provenance& provenance) {
  const std::string element = fmt::format("<metadata>{}: {}{}</metadata>\n", escaped(provenance.program),
                                          escaped(provenance.command), words_for_inputs(provenance));
  return svg.insert(svg.rfind("</svg>"), element);
}

std::string in_markdown(const std::string& markdown, const Provenance& provenance) {
  return fmt::format("{}\nMade by {}: `{}`{}.\n", markdown, provenance.program, brief(provenance.command),
                     words_for_inputs(provenance));
}

std::string in_latex(const std::string& latex, const Provenance& provenance) {
  return fmt::format("% {}: {}{}\n{}", provenance.program, brief(provenance.command),
                     words_for_inputs(provenance), latex);
}

}  // namespace plumbline::page
