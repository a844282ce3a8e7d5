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

using namespace plumbline::verify;

namespace {

/// What a check makes of a print; "error" for what cannot be judged.
std::string verdict_on(const Claim& claim, const Printed& printed) {
  try {
    return std::string(name(judge_print(claim, printed, 10).verdict));
  } catch (const std::exception&) {
    return "error";
  }
}

/// A correction, or a survivor that is listed with its reason.
bool known_to_be_true(const std::string& id, const AlteredPrint& altered) {
  static const auto corrected = corrected_claims();
  static const auto listed = survivors();
  const auto [first, last] = corrected.equal_range(id);
  return std::any_of(first, last, [&](const auto& one) { return one.second == altered.printed; }) ||
         std::any_of(listed.begin(), listed.end(), [&](const Survivor& one) {
           return one.id == id && one.what == altered.what &&
                  (one.entry.empty() || std::find(altered.printed.begin(), altered.printed.end(),
                                                  one.entry) != altered.printed.end());
         });
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
    const std::string own = verdict_on(claim, claim.printed);
    for (const AlteredPrint& altered : altered_prints(claim)) {
      if (!all && ++number % 20 != 1) continue;
      Count& count = counts[altered.what];
      ++count.tried;
      const std::string verdict = verdict_on(claim, altered.printed);
      // imprecise and convention are no worse than the print itself where it is that too
      const bool survives = verdict == "confirmed" || (verdict == own && own != "refuted" && own != "error");
      if (!survives) {
        ++count.caught;
        continue;
      }
      const bool known = known_to_be_true(claim.id, altered);
      count.true_too += known ? 1 : 0;
      CHECK_MESSAGE(known, claim.id << ": " << fmt::format("{}", fmt::join(altered.printed, " | ")) << " is "
                                    << verdict << " too");
    }
  }
  if (!all) return;
  for (const auto& [what, count] : counts)
    MESSAGE(fmt::format("{:12} tried {:5} caught {:5} true as well {:3}", what, count.tried, count.caught,
                        count.true_too));
}
