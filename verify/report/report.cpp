#include "verify/report/report.hpp"

#include <fmt/core.h>

#include <cctype>
#include <map>
#include <sstream>

namespace plumbline::verify {
namespace {

constexpr std::size_t width = 80;

std::string verdict_of(const Judged& judged) {
  return judged.judgement ? std::string(name(judged.judgement->verdict)) : "unjudged";
}

std::string strongest(const Judged& judged) {
  return judged.judgement && !judged.judgement->evidence.empty()
             ? std::string(name(judged.judgement->evidence.front().kind))
             : "";
}

/// The number of characters of UTF-8 text.
std::size_t length(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
  return count;
}

/// The first so many characters of UTF-8 text.
std::string first(const std::string& text, std::size_t characters) {
  std::string cut;
  std::size_t count = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U && ++count > characters) break;
    cut += c;
  }
  return cut;
}

/// The text in so many columns: filled up with spaces, or cut with an ellipsis.
std::string fitted(const std::string& text, std::size_t columns) {
  if (length(text) <= columns) return text + std::string(columns - length(text), ' ');
  return first(text, columns - 1) + "…";
}

/// Words in lines of at most `width` columns, each line indented; a longer word is broken.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  std::string line(indent, ' ');
  const auto finish_line = [&] {
    result += line + "\n";
    line = std::string(indent, ' ');
  };
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > indent && length(line) + 1 + length(word) > width) finish_line();
    if (line.size() > indent) line += ' ';
    while (length(line) + length(word) > width) {
      const std::string part = first(word, width - length(line));
      line += part;
      word.erase(0, part.size());
      finish_line();
    }
    line += word;
  }
  return result + line + "\n";
}

std::string painted(const std::string& text, const std::string& verdict, bool colour) {
  static const std::map<std::string, const char*> codes{
      {"confirmed", "32"}, {"refuted", "31"}, {"imprecise", "33"}, {"convention", "36"}, {"unjudged", "35"}};
  return colour ? fmt::format("\033[{}m{}\033[0m", codes.at(verdict), text) : text;
}

std::string bold(const std::string& text, bool colour) {
  return colour ? "\033[1m" + text + "\033[0m" : text;
}

std::string line(const Judged& judged, bool colour) {
  const std::string verdict = verdict_of(judged);
  return fmt::format("  {} {} {} {}\n", fitted(judged.claim.id, 23),
                     painted(fitted(verdict, 10), verdict, colour), fitted(strongest(judged), 8),
                     fitted(judged.claim.statement, width - 46));
}

std::string summary(const std::vector<Judged>& judged, bool colour) {
  std::string parts;
  for (const char* verdict : {"confirmed", "refuted", "imprecise", "convention", "unjudged"}) {
    const auto count = std::count_if(judged.begin(), judged.end(),
                                     [&](const Judged& j) { return verdict_of(j) == verdict; });
    if (count > 0)
      parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", count, painted(verdict, verdict, colour));
  }
  return fmt::format("{} claims: {}\n", judged.size(), parts);
}

std::string erratum(const Judged& judged, bool colour) {
  const std::string verdict = verdict_of(judged);
  const std::string truth = judged.judgement ? judged.judgement->truth : judged.problem;
  return fmt::format("  {} ({}, {})\n", bold(judged.claim.id, colour), judged.claim.where,
                     painted(verdict, verdict, colour)) +
         wrapped("printed: " + judged.claim.statement, 4) + wrapped("true: " + truth, 4);
}

}  // namespace

std::string as_table(const std::vector<Judged>& judged, bool colour) {
  std::string text;
  std::string section;
  for (const Judged& j : judged) {
    if (section_of(j.claim) != section) {
      section = section_of(j.claim);
      text += (text.empty() ? "" : "\n") +
              bold((std::isdigit(static_cast<unsigned char>(section[0])) != 0 ? "Section " : "Properties ") +
                       section,
                   colour) +
              "\n";
    }
    text += line(j, colour);
  }
  text += "\n" + summary(judged, colour);
  std::string errata;
  for (const Judged& j : judged) {
    if (verdict_of(j) != "confirmed") errata += erratum(j, colour);
  }
  return errata.empty() ? text : text + "\n" + bold("Errata", colour) + "\n" + errata;
}

std::string as_detail(const Judged& judged, bool colour) {
  const std::string verdict = verdict_of(judged);
  std::string text = fmt::format("{}  ({})\n", bold(judged.claim.id, colour), judged.claim.where);
  text += wrapped("statement: " + judged.claim.statement, 2);
  std::string printed;
  for (const std::string& part : judged.claim.printed) printed += (printed.empty() ? "" : " | ") + part;
  text += wrapped("printed: " + printed, 2);
  text += "  verdict: " + painted(verdict, verdict, colour) + "\n";
  if (!judged.judgement) return text + wrapped("problem: " + judged.problem, 2);
  if (!judged.judgement->truth.empty()) text += wrapped("true: " + judged.judgement->truth, 2);
  if (!judged.judgement->value.empty()) text += wrapped("value: " + judged.judgement->value, 2);
  for (const Evidence& e : judged.judgement->evidence) {
    text += wrapped(fmt::format("evidence, {}: {}", name(e.kind), e.detail), 2);
  }
  return text;
}

nlohmann::ordered_json as_json(const std::vector<Judged>& judged) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Judged& j : judged) {
    nlohmann::ordered_json evidence = nlohmann::ordered_json::array();
    const Judgement judgement = j.judgement.value_or(Judgement{Verdict::refuted, j.problem, {}, ""});
    for (const Evidence& e : judgement.evidence) {
      evidence.push_back({{"kind", std::string(name(e.kind))}, {"detail", e.detail}});
    }
    list.push_back({{"id", j.claim.id},
                    {"where", j.claim.where},
                    {"statement", j.claim.statement},
                    {"verdict", verdict_of(j)},
                    {"truth", judgement.truth},
                    {"evidence", evidence},
                    {"value", judgement.value}});
  }
  return list;
}

}  // namespace plumbline::verify
