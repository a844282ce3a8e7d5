#include "verify/report/errata.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <regex>

#include "proofs/exact/decimal.hpp"

namespace plumbline::verify {
namespace {

/// Verdicts on whatever an erratum names.
class Verdicts {
 public:
  Verdicts(const Paper& paper, const std::vector<Judged>& judged) : paper_(paper) {
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

/// Whether a decimal is that with which an entry begins, signs aside, rounded to its places.
bool is_rounded(const std::string& decimal, const std::string& entry) {
  const std::string bare =
      entry.substr(entry.find_first_not_of('-') == std::string::npos ? 0 : entry.find_first_not_of('-'));
  const auto value = proofs::parse_decimal(bare.substr(0, bare.find_first_not_of("0123456789.")));
  return value &&
         proofs::to_fixed(*value, static_cast<int>(decimal.size() - decimal.find('.') - 1)) == decimal;
}

/// What an erratum says, held against the verdicts.
class Examination {
 public:
  Examination(const Erratum& said, Verdicts& verdicts) : said_(said), verdicts_(verdicts) {
    holds_ = {said.id, said.title, {}, {}, {}, {}, said.remark};
    for (const Correction& one : said.corrections) examine(one);
    for (const Sentence& one : said.reason) examine(one);
    for (const Named& one : said.stands)
      keep(one, verdicts_.confirmed(one.id), "said to stand, not confirmed", holds_.stands);
    for (const Named& one : said.changes)
      keep(one, !verdicts_.confirmed(one.id), "said to change, confirmed", holds_.changes);
  }

  [[nodiscard]] const Erratum& holds() const { return holds_; }
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  void problem(const std::string& what) { problems_.push_back(said_.id + ": " + what); }

  void keep(const Named& one, bool right, const std::string& wrong, std::vector<Named>& list) {
    if (right)
      list.push_back(one);
    else
      problem(fmt::format("{} is {}", one.id, wrong));
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

  /// The numbers that hold a sentence: prints and values of confirmed claims and facts, and prints of
  /// corrections; nothing where one of them fails.
  std::optional<std::vector<Printed>> prints_behind(const Sentence& sentence) {
    std::vector<Printed> prints;
    for (const std::string& id : sentence.held_by) {
      if (verdicts_.confirmed(id)) {
        const Judged& one = verdicts_.of(id);
        prints.push_back(one.claim.printed);
        prints.push_back({one.judgement->value});
        for (const Premise& premise : one.claim.given.list())
          for (const auto& [part, numbers] : premise.parts) prints.push_back(numbers);
        continue;
      }
      const auto corrected = std::find_if(holds_.corrections.begin(), holds_.corrections.end(),
                                          [&](const Correction& one) { return one.claim == id; });
      if (corrected == holds_.corrections.end()) return std::nullopt;
      prints.push_back(corrected->print);
      prints.push_back({verdicts_.of(id).judgement->value});
    }
    return prints;
  }

  void examine(const Sentence& sentence) {
    const auto prints = prints_behind(sentence);
    if (!prints) {
      problem(fmt::format("“{}” is not held by {}", sentence.text, fmt::join(sentence.held_by, ", ")));
      return;
    }
    static const std::regex numbers(R"(\d+\.\d+)");
    for (std::sregex_iterator one(sentence.text.begin(), sentence.text.end(), numbers), end; one != end;
         ++one) {
      const std::string number = one->str();
      const bool printed = std::any_of(prints->begin(), prints->end(), [&](const Printed& print) {
        return std::any_of(print.begin(), print.end(),
                           [&](const std::string& entry) { return is_rounded(number, entry); });
      });
      if (printed) continue;
      problem(fmt::format("the number {} of “{}” is no print of {}", number, sentence.text,
                          fmt::join(sentence.held_by, ", ")));
      return;
    }
    holds_.reason.push_back(sentence);
  }

  const Erratum& said_;
  Verdicts& verdicts_;
  Erratum holds_;
  std::vector<std::string> problems_;
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
  Verdicts verdicts(paper, judged);
  for (const Erratum& erratum : paper.errata) {
    std::vector<Judged> claims;
    for (const Judged& one : judged) {
      if (one.claim.cause == erratum.id && is_wrong(one)) claims.push_back(one);
    }
    if (claims.empty()) continue;
    const Examination examination(erratum, verdicts);
    list.items.push_back(
        {examination.holds(), severity_of(examination.holds(), claims), claims, examination.problems()});
  }
  for (const Judged& one : judged) {
    const bool known = std::any_of(paper.errata.begin(), paper.errata.end(),
                                   [&](const Erratum& e) { return e.id == one.claim.cause; });
    if (is_wrong(one) && !known) list.open.push_back(one);
  }
  std::stable_sort(list.items.begin(), list.items.end(), [](const JudgedErratum& a, const JudgedErratum& b) {
    return std::pair(a.erratum.remark, a.severity) < std::pair(b.erratum.remark, b.severity);
  });
  return list;
}

std::string count_of(const Errata& errata) {
  const auto number = [&](auto&& is) { return std::count_if(errata.items.begin(), errata.items.end(), is); };
  const auto of = [&](Severity severity) {
    return number([&](const JudgedErratum& e) { return !e.erratum.remark && e.severity == severity; });
  };
  const auto remarks = number([](const JudgedErratum& e) { return e.erratum.remark; });
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
