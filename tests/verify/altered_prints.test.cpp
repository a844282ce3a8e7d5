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
