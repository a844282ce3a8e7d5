#include "verify/report/report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include <cctype>
#include <map>
#include <sstream>

#include "proofs/coq/machine_checked.hpp"
#include "verify/report/errata.hpp"
#include "verify/report/markup.hpp"

namespace plumbline::verify {
namespace {

constexpr std::size_t width = 80;  // of what is wrapped

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

/// The print in the reading that was judged.
const Printed& as_judged(const Judged& judged) {
  const bool favoured = judged.judgement && !judged.judgement->favoured.empty();
  return favoured ? judged.judgement->favoured : judged.claim.printed;
}

std::string bold(const std::string& text, bool colour) {
  return colour ? "\033[1m" + text + "\033[0m" : text;
}

/// One line a claim; the reading is cut where the terminal ends, and whole where there is none.
std::string line(const Judged& judged, const Style& style) {
  const std::string verdict = verdict_of(judged);
  const std::string& reading = judged.claim.reading;
  return fmt::format(
      "  {} {} {} {}\n", fitted(judged.claim.id, 23), painted(fitted(verdict, 10), verdict, style.colour),
      fitted(strongest(judged), 15),
      style.columns == 0 ? reading : fitted(reading, std::max<std::size_t>(style.columns, 73) - 53));
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

std::string erratum(const Paper& paper, const JudgedErratum& one, bool colour) {
  std::string text =
      fmt::format("  {} ({}{})\n", bold(one.id, colour), name(one.severity), one.remark ? ", a remark" : "");
  for (const Correction& correction : one.corrections)
    text += wrapped(
        fmt::format("{} ({}): for “{}” read “{}”", correction.claim, place_of(paper.claim(correction.claim)),
                    as_plain(correction.printed), as_plain(correction.read)),
        4);
  for (const Judged& judged : one.claims) {
    const bool corrected = std::any_of(one.corrections.begin(), one.corrections.end(),
                                       [&](const Correction& c) { return c.claim == judged.claim.id; });
    if (!corrected) text += wrapped(judged.claim.id + ": " + judged.judgement->truth, 4);
  }
  return text;
}

std::string heading(const Paper& paper, const std::string& section) {
  const std::string title = paper.section_title(section);
  if (title.empty()) return "Properties " + section;
  const bool number = std::isdigit(static_cast<unsigned char>(section[0])) != 0;
  return (number ? "Section " : "") + section + ": " + title;
}

}  // namespace

std::string proofs_checked() {
  if (proofs::coq_version().empty()) return "not in this build";
  return fmt::format("{} theorems, by Coq {}, without axioms", proofs::machine_checked().size(),
                     proofs::coq_version());
}

std::string as_table(const Paper& paper, const std::vector<Judged>& judged, const Style& style) {
  std::string text;
  std::string section;
  for (const Judged& j : judged) {
    if (section_of(j.claim) != section) {
      section = section_of(j.claim);
      text += (text.empty() ? "" : "\n") + bold(heading(paper, section), style.colour) + "\n";
    }
    text += line(j, style);
  }
  text += "\n" + summary(judged, style.colour) + "proofs checked: " + proofs_checked() + "\n";
  for (const Judged& j : judged) {
    if (!j.judgement) text += fmt::format("  {}: {}\n", j.claim.id, j.problem);
  }
  const Errata list = errata(paper, judged);
  for (const std::string& problem : list.problems()) text += "  not held: " + problem + "\n";
  if (list.items.empty()) return text;
  text += fmt::format("{}\n\n{}\n", count_of(list), bold("Errata", style.colour));
  for (const JudgedErratum& one : list.items) text += erratum(paper, one, style.colour);
  return text;
}

std::string as_detail(const Judged& judged, bool colour) {
  const std::string verdict = verdict_of(judged);
  const Claim& claim = judged.claim;
  std::string text = fmt::format("{}  ({})\n", bold(claim.id, colour), claim.where);
  if (!claim.also.empty()) text += wrapped(fmt::format("also: {}", fmt::join(claim.also, "; ")), 2);
  text += wrapped("quote: “" + claim.quote + "”", 2);
  text += wrapped(fmt::format("reading{}: {}", claim.charitable ? ", charitable" : "", claim.reading), 2);
  text += wrapped(fmt::format("judged as: {}", fmt::join(as_judged(judged), " | ")), 2);
  for (const Premise& premise : claim.given.list())
    text += wrapped(fmt::format("given: “{}”{}", premise.quote,
                                premise.where.empty() ? ", taken so" : " (" + premise.where + ")"),
                    2);
  text += "  verdict: " + painted(verdict, verdict, colour) + "\n";
  if (!judged.judgement) return text + wrapped("problem: " + judged.problem, 2);
  if (const auto grave = severity(claim, judged.judgement->verdict))
    text += fmt::format("  severity: {}\n  cause: {}\n", name(*grave), claim.cause);
  if (!judged.judgement->truth.empty()) text += wrapped("true: " + judged.judgement->truth, 2);
  if (!judged.judgement->value.empty()) text += wrapped("value: " + judged.judgement->value, 2);
  for (const Evidence& e : judged.judgement->evidence) {
    const std::string theorem = e.theorem.empty() ? "" : " “" + e.theorem + "”";
    const std::string coq = e.coq.empty() ? "" : fmt::format(" ({})", fmt::join(e.coq, ", "));
    text += wrapped(fmt::format("evidence, {}{}{}: {}", name(e.kind), theorem, coq, e.detail), 2);
  }
  if (!claim.source.file.empty())
    text += wrapped(fmt::format("checked at {}:{}", claim.source.file, claim.source.line), 2);
  return text;
}

nlohmann::ordered_json as_json(const std::vector<Judged>& judged) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Judged& j : judged) {
    nlohmann::ordered_json evidence = nlohmann::ordered_json::array();
    const Judgement judgement = j.judgement.value_or(Judgement{Verdict::refuted, j.problem, {}, ""});
    for (const Evidence& e : judgement.evidence) {
      nlohmann::ordered_json one{{"kind", std::string(name(e.kind))}, {"detail", e.detail}};
      if (!e.theorem.empty()) one["theorem"] = e.theorem;
      if (!e.coq.empty()) one["coq"] = e.coq;
      evidence.push_back(std::move(one));
    }
    const auto grave = j.judgement ? severity(j.claim, judgement.verdict) : std::nullopt;
    nlohmann::ordered_json one;
    one["id"] = j.claim.id;
    one["where"] = j.claim.where;
    one["also"] = j.claim.also;
    one["quote"] = j.claim.quote;
    one["reading"] = j.claim.reading;
    one["charity"] = j.claim.charitable ? "charitable" : "literal";
    one["printed"] = j.claim.printed;
    one["favoured"] = judgement.favoured;
    one["given"] = nlohmann::ordered_json::array();
    for (const Premise& premise : j.claim.given.list()) one["given"].push_back(premise.id);
    one["verdict"] = verdict_of(j);
    one["severity"] =
        grave ? nlohmann::ordered_json(std::string(name(*grave))) : nlohmann::ordered_json(nullptr);
    one["cause"] = grave ? nlohmann::ordered_json(j.claim.cause) : nlohmann::ordered_json(nullptr);
    one["truth"] = judgement.truth;
    one["evidence"] = std::move(evidence);
    one["value"] = judgement.value;
    one["check"] = nullptr;
    if (!j.claim.source.file.empty())
      one["check"] = {{"file", j.claim.source.file}, {"line", j.claim.source.line}};
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace plumbline::verify
