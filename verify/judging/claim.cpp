#include "verify/judging/claim.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <plumbline/base/error.hpp>

#include "proofs/coq/machine_checked.hpp"

namespace plumbline::verify {
namespace {

/// What is no row of signs and has no digit, as numbers and formulas have, is a word.
bool is_word(const std::string& text) {
  return text.find_first_not_of("+-") != std::string::npos &&
         text.find_first_of("0123456789") == std::string::npos;
}

/// Formulas with everything behind the first slash of each as the denominator: the reading that a printed
/// line such as "2kq/L sin(q)" intends.
Printed fraction_readings(Printed formulas) {
  for (std::string& formula : formulas) {
    const std::size_t slash = formula.find('/');
    if (slash != std::string::npos)
      formula = formula.substr(0, slash) + "/(" + formula.substr(slash + 1) + ")";
  }
  return formulas;
}

}  // namespace

Evidence Evidence::by_checked_theorem(std::string name, std::vector<std::string> coq, std::string says) {
  Evidence evidence = by_theorem(std::move(name), std::move(says));
  evidence.coq = std::move(coq);
  const auto checked = proofs::machine_checked();
  if (std::all_of(evidence.coq.begin(), evidence.coq.end(), [&](const std::string& one) {
        return std::find(checked.begin(), checked.end(), one) != checked.end();
      }))
    evidence.kind = EvidenceKind::machine_checked;
  return evidence;
}

Judgement judge_print(const Claim& claim, const Printed& printed, int digits) {
  if (printed.empty() || (!claim.list && printed.size() != claim.printed.size()))
    throw Error("claim", fmt::format("{} printed entries", printed.size()),
                claim.list ? "one or more" : fmt::format("{}", claim.printed.size()));
  for (const std::string& text : printed) {
    if (!claim.words.empty() && is_word(text) &&
        std::find(claim.words.begin(), claim.words.end(), text) == claim.words.end())
      throw Error("claim", "'" + text + "'", fmt::format("one of: {}", fmt::join(claim.words, ", ")));
  }
  Judgement judgement = claim.check(printed, claim.given, digits);
  if (claim.charitable && judgement.verdict != Verdict::confirmed) {
    const Printed favoured = fraction_readings(printed);
    Judgement other = favoured == printed ? judgement : claim.check(favoured, claim.given, digits);
    if (other.verdict == Verdict::confirmed) {
      judgement = std::move(other);
      judgement.favoured = favoured;
    }
  }
  std::stable_sort(judgement.evidence.begin(), judgement.evidence.end(),
                   [](const Evidence& a, const Evidence& b) { return a.kind < b.kind; });
  return judgement;
}

std::optional<Severity> severity(const Claim& claim, Verdict verdict) {
  if (verdict == Verdict::confirmed) return std::nullopt;
  if (verdict == Verdict::convention) return Severity::convention;
  if (claim.subject == Subject::name) return Severity::wording;
  return claim.subject == Subject::statement ? Severity::statement : Severity::formula;
}

std::string_view name(Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"confirmed", "refuted", "imprecise", "convention"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::string_view name(Severity severity) {
  static constexpr std::array<std::string_view, 5> names{"result", "formula", "statement", "wording",
                                                         "convention"};
  return names.at(static_cast<std::size_t>(severity));
}

std::string_view name(EvidenceKind kind) {
  static constexpr std::array<std::string_view, 8> names{"machine-checked", "theorem", "symbolic", "exact",
                                                         "interval",        "mp50",    "double",   "sampled"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace plumbline::verify
