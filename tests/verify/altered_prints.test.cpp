/// \file
/// Every claim is judged again on every altered print (altered_prints.hpp): its check must not take one for
/// what is true. One in twenty by default; all with PLUMBLINE_PRINTS=all, and then a table of how many were
/// tried.
#include "tests/verify/altered_prints.hpp"

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <map>

#include "tests/verify/true_prints.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/judge.hpp"

using namespace plumbline::verify;

namespace {

/// What a check makes of a print; "error" for what cannot be judged.
std::string verdict_or_error(const Claim& claim, const Printed& printed) {
  try {
    return std::string(name(judge_print(claim, printed, 10).verdict));
  } catch (const std::exception&) {
    return "error";
  }
}

bool is_correction(const std::string& id, const AlteredPrint& altered) {
  static const auto corrected = corrected_claims();
  const auto [first, last] = corrected.equal_range(id);
  return std::any_of(first, last, [&](const auto& one) { return one.second == altered.printed; });
}

/// Whether a print of that claim is what the list means.
bool is_meant(const Survivor& one, const std::string& id, const AlteredPrint& altered) {
  const Printed& printed = altered.printed;
  return one.id == id && one.what == altered.what &&
         (one.entry.empty() || std::find(printed.begin(), printed.end(), one.entry) != printed.end());
}

/// A correction, or a survivor that is listed with its reason.
bool known_to_be_true(const std::string& id, const AlteredPrint& altered) {
  static const auto listed = survivors();
  return is_correction(id, altered) || std::any_of(listed.begin(), listed.end(), [&](const Survivor& one) {
           return is_meant(one, id, altered);
         });
}

/// Whether the check takes an altered print for as true as the claim's own, on which the verdict is `own`:
/// imprecise and convention are no worse where it is that too.
bool survives(const Claim& claim, const std::string& own, const AlteredPrint& altered) {
  const std::string verdict = verdict_or_error(claim, altered.printed);
  return verdict == "confirmed" || (verdict == own && own != "refuted" && own != "error");
}

struct Count {
  std::size_t tried = 0, caught = 0, true_too = 0;
};

}  // namespace

TEST_CASE("an altered print is not taken for what is true") {
  const char* const size = std::getenv("PLUMBLINE_PRINTS");
  const bool all = size != nullptr && std::string(size) == "all";
  std::map<std::string, Count> counts;
  std::size_t number = 0;
  for (const Claim& claim : all_claims()) {
    const std::string own = verdict_or_error(claim, claim.printed);
    for (const AlteredPrint& altered : altered_prints(claim)) {
      if (!all && ++number % 20 != 1) continue;
      Count& count = counts[altered.what];
      ++count.tried;
      if (!survives(claim, own, altered)) {
        ++count.caught;
        continue;
      }
      const bool known = known_to_be_true(claim.id, altered);
      count.true_too += known ? 1 : 0;
      CHECK_MESSAGE(known, claim.id << ": " << fmt::format("{}", fmt::join(altered.printed, " | "))
                                    << " is taken for true too");
    }
  }
  if (!all) return;
  for (const auto& [what, count] : counts)
    MESSAGE(fmt::format("{:12} tried {:5} caught {:5} true as well {:3}", what, count.tried, count.caught,
                        count.true_too));
}

TEST_CASE("what is listed as a survivor survives, and is no correction") {
  for (const Survivor& one : survivors()) {
    INFO(one.id, ", ", one.what, " ", one.entry, ": ", one.reason);
    const Claim claim = with_id(all_claims(), one.id).front();
    const std::string own = verdict_or_error(claim, claim.printed);
    const auto prints = altered_prints(claim);
    CHECK(std::any_of(prints.begin(), prints.end(), [&](const AlteredPrint& altered) {
      return is_meant(one, one.id, altered) && !is_correction(one.id, altered) &&
             survives(claim, own, altered);
    }));
  }
}

namespace {

/// A number, or a symbol, altered: its first digit, its sign, to nought, its letter.
std::vector<std::string> altered_number(const std::string& text) {
  std::vector<std::string> all;
  const std::size_t digit = text.find_first_of("0123456789");
  const auto first = static_cast<unsigned char>(text[0]);
  const bool symbol = (std::isalpha(first) != 0 || first >= 0x80) && !text.starts_with("pi");
  if (!symbol && digit != std::string::npos) {
    for (const char other : {text[digit] == '9' ? '1' : '9', '0'}) {
      all.push_back(text);
      all.back()[digit] = other;
    }
    all.push_back(text[0] == '-' ? text.substr(1) : "-" + text);
  }
  if (symbol) all.push_back("x" + text);
  return all;
}

/// The premises of a claim with one number of one of them altered.
std::vector<Premises> altered_premises(const Premises& given, std::size_t which) {
  std::vector<Premises> all;
  for (const auto& [name, part] : given.list()[which].parts) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (const std::string& other : altered_number(part[i])) {
        std::vector<Premise> list = given.list();
        list[which].parts[name][i] = other;
        all.emplace_back(std::move(list));
      }
    }
  }
  return all;
}

/// Everything that a claim is judged to be.
std::string whole_judgement(const Claim& claim) {
  try {
    const Judgement judgement = judge_print(claim, claim.printed, 10);
    std::string text = fmt::format("{} {} {}", name(judgement.verdict), judgement.truth, judgement.value);
    for (const Evidence& one : judgement.evidence) text += " " + one.detail;
    return text;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("every premise is read: with another the claim is judged otherwise" * doctest::test_suite("long")) {
  const char* const size = std::getenv("PLUMBLINE_PRINTS");
  const bool all = size != nullptr && std::string(size) == "all";
  std::size_t number = 0, tried = 0;
  for (const Claim& claim : all_claims()) {
    for (std::size_t which = 0; which < claim.given.list().size(); ++which) {
      if (!all && ++number % 8 != 1) continue;
      const std::string own = whole_judgement(claim);
      const std::vector<Premises> others = altered_premises(claim.given, which);
      ++tried;
      CHECK_MESSAGE(std::any_of(others.begin(), others.end(),
                                [&](const Premises& other) {
                                  Claim altered = claim;
                                  altered.given = other;
                                  return whole_judgement(altered) != own;
                                }),
                    claim.id << ": " << claim.given.list()[which].id);
    }
  }
  if (all) MESSAGE(tried << " premises of claims altered");
}

TEST_CASE("what the paper says of Fig. 8 is not said of a chain with other rest angles") {
  Claim claim = with_id(all_claims(), "fig-8-smooth").front();
  REQUIRE(verdict_or_error(claim, claim.printed) == "confirmed");
  std::vector<Premise> list = claim.given.list();
  list.front().parts["rest"] = {"0", "pi/10", "-0.32"};
  claim.given = Premises(list);
  CHECK(verdict_or_error(claim, claim.printed) != "confirmed");
}
