#include "verify/report/errata.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <regex>

#include "verify/judging/notation.hpp"

namespace plumbline::verify {
namespace {

/// KnownVerdicts on whatever an erratum names.
class KnownVerdicts {
 public:
  KnownVerdicts(const Paper& paper, const std::vector<Judged>& judged) : paper_(paper) {
    for (const Judged& one : judged) known_.emplace(one.claim.id, one);
  }

  const Judged& of(const std::string& id) {
    const auto found = known_.find(id);
    if (found != known_.end()) return found->second;
    return known_.emplace(id, judge({paper_.claim(id)}, digits).front()).first->second;
  }
  bool confirmed(const std::string& id) {
    const Judged& one = of(id);
    return one.judgement && one.judgement->verdict == Verdict::confirmed;
  }
  /// What a claim's own check says of another print; the reason where it is not confirmed.
  std::string against(const std::string& id, const Printed& print) {
    try {
      const Judgement judgement = judge_print(paper_.claim(id), print, digits);
      return judgement.verdict == Verdict::confirmed
                 ? ""
                 : fmt::format("{}: {}", name(judgement.verdict), judgement.truth);
    } catch (const std::exception& error) {
      return error.what();
    }
  }

 private:
  static constexpr int digits = 20;
  const Paper& paper_;
  std::map<std::string, Judged> known_;
};

/// A passage of the paper: an equation by its number, of a table what is read there, a sentence by its words.
std::string passage(const Claim& claim) {
  static const std::regex equation("[^,]+, (\\([0-9]+\\)( to \\([0-9]+\\))?)"),
      table("[^,]+, (Table [0-9]+)");
  std::smatch place;
  if (std::regex_match(claim.where, place, equation)) return place[1];
  if (std::regex_match(claim.where, place, table))
    return fmt::format("{} ({})", claim.reading, place[1].str());
  return fmt::format("“{}” ({})", claim.quote, claim.where);
}

/// What an erratum names, held against the verdicts.
class Examination {
 public:
  Examination(const Erratum& said, KnownVerdicts& verdicts, JudgedErratum& holds)
      : said_(said), verdicts_(verdicts), holds_(holds) {
    for (const Correction& one : said.corrections) examine(one);
    for (const std::string& id : said.reason) examine_reason(id);
    for (const std::string& id : said.stands)
      keep(id, verdicts_.confirmed(id), "said to stand, not confirmed", holds_.stands);
    for (const std::string& id : said.changes)
      keep(id, !verdicts_.confirmed(id), "said to change, confirmed", holds_.changes);
  }

 private:
  void problem(const std::string& what) { holds_.problems.push_back(said_.id + ": " + what); }

  void keep(const std::string& id, bool right, const std::string& wrong, std::vector<std::string>& list) {
    if (right)
      list.push_back(passage(verdicts_.of(id).claim));
    else
      problem(fmt::format("{} is {}", id, wrong));
  }

  void examine(const Correction& one) {
    const std::string wrong = verdicts_.against(one.claim, one.print);
    if (!wrong.empty())
      problem(
          fmt::format("the correction of {} to “{}” is {}", one.claim, fmt::join(one.print, " | "), wrong));
    else if (verdicts_.confirmed(one.claim))
      problem(fmt::format("{} is corrected, and confirmed as printed", one.claim));
    else
      holds_.corrections.push_back(one);
  }

  void examine_reason(const std::string& id) {
    const std::optional<Judgement>& found = verdicts_.of(id).judgement;
    const bool confirmed = verdicts_.confirmed(id);
    const std::string sentence = !found ? "" : confirmed ? found->statement : found->truth;
    const bool fact = verdicts_.of(id).claim.quote.empty();
    const std::string subject = found && confirmed ? found->subject : "";
    if (sentence.empty())
      problem(fmt::format("the reason {} says nothing", id));
    else if (fact && !confirmed)
      problem(fmt::format("the fact {} is {}", id, name(found->verdict)));
    else
      holds_.reason.push_back(as_sentence(subject.empty()       ? sentence
                                          : subject == subject_ ? "it " + sentence
                                                                : subject + " " + sentence));
    subject_ = subject;
  }

  const Erratum& said_;
  KnownVerdicts& verdicts_;
  JudgedErratum& holds_;
  std::string subject_;  ///< of the reason before
};

Severity severity_of(const Erratum& erratum, const std::vector<Judged>& claims) {
  if (!erratum.changes.empty()) return Severity::result;
  Severity gravest = Severity::convention;
  for (const Judged& one : claims)
    gravest = std::min(gravest, severity(one.claim, one.judgement->verdict).value_or(Severity::convention));
  return gravest;
}

bool is_wrong(const Judged& judged) {
  return judged.judgement && judged.judgement->verdict != Verdict::confirmed;
}

}  // namespace

std::vector<std::string> Errata::problems() const {
  std::vector<std::string> all;
  for (const JudgedErratum& one : items) all.insert(all.end(), one.problems.begin(), one.problems.end());
  return all;
}

Errata errata(const Paper& paper, const std::vector<Judged>& judged) {
  Errata list;
  KnownVerdicts verdicts(paper, judged);
  for (const Erratum& erratum : paper.errata) {
    std::vector<Judged> claims;
    for (const Judged& one : judged) {
      if (one.claim.cause == erratum.id && is_wrong(one)) claims.push_back(one);
    }
    if (claims.empty()) continue;
    const Severity severity = severity_of(erratum, claims);
    JudgedErratum& item = list.items.emplace_back(
        JudgedErratum{erratum.id, erratum.remark, severity, claims, {}, {}, {}, {}, {}});
    const Examination examination(erratum, verdicts, item);
  }
  for (const Judged& one : judged) {
    const bool known = std::any_of(paper.errata.begin(), paper.errata.end(),
                                   [&](const Erratum& e) { return e.id == one.claim.cause; });
    if (is_wrong(one) && !known) list.open.push_back(one);
  }
  std::stable_sort(list.items.begin(), list.items.end(), [](const JudgedErratum& a, const JudgedErratum& b) {
    return std::pair(a.remark, a.severity) < std::pair(b.remark, b.severity);
  });
  return list;
}

std::string place_of(const Claim& claim) {
  return claim.also.empty() ? claim.where
                            : fmt::format("{}; also {}", claim.where, fmt::join(claim.also, "; "));
}

std::string count_of(const Errata& errata) {
  const auto number = [&](auto&& is) { return std::count_if(errata.items.begin(), errata.items.end(), is); };
  const auto of = [&](Severity severity) {
    return number([&](const JudgedErratum& e) { return !e.remark && e.severity == severity; });
  };
  const auto remarks = number([](const JudgedErratum& e) { return e.remark; });
  std::string parts;
  for (const auto& [severity, what] : {std::pair{Severity::result, "of a result"},
                                       {Severity::formula, "of a formula or number"},
                                       {Severity::statement, "of a statement"},
                                       {Severity::wording, "of a wording"}}) {
    if (of(severity) > 0) parts += fmt::format("{}{} {}", parts.empty() ? ": " : ", ", of(severity), what);
  }
  return fmt::format("{} errata{}; {} remarks; {} more claims fix a convention or lack a condition",
                     static_cast<std::ptrdiff_t>(errata.items.size()) - remarks, parts, remarks,
                     errata.open.size());
}

}  // namespace plumbline::verify
