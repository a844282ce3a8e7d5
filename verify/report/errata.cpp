#include "verify/report/errata.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace plumbline::verify {
namespace {

Cause cause_of(const Claim& claim) {
  for (const Cause& cause : paper().causes) {
    if (cause.id == claim.cause) return cause;
  }
  return {claim.cause, "", "", "", {}};
}

Severity severity_of(const Judged& judged) {
  return severity(judged.claim, judged.judgement->verdict).value();
}

bool is_erratum(const Judged& judged) {
  return judged.judgement && judged.judgement->verdict != Verdict::confirmed;
}

std::size_t number(const std::vector<Erratum>& errata, Severity severity) {
  return static_cast<std::size_t>(
      std::count_if(errata.begin(), errata.end(), [&](const Erratum& e) { return e.severity == severity; }));
}

}  // namespace

std::vector<Erratum> errata(const std::vector<Judged>& judged) {
  std::vector<Erratum> list;
  for (const Judged& one : judged) {
    if (!is_erratum(one)) continue;
    const auto known = std::find_if(list.begin(), list.end(),
                                    [&](const Erratum& e) { return e.cause.id == one.claim.cause; });
    Erratum& erratum = known != list.end()
                           ? *known
                           : list.emplace_back(Erratum{cause_of(one.claim), severity_of(one), {}, {}});
    erratum.severity = std::min(erratum.severity, severity_of(one));
    erratum.claims.push_back(one);
  }
  for (Erratum& erratum : list) {
    for (const std::string& id : erratum.cause.unchanged) {
      const auto other =
          std::find_if(judged.begin(), judged.end(), [&](const Judged& j) { return j.claim.id == id; });
      if (other != judged.end()) erratum.unchanged.push_back(*other);
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Erratum& a, const Erratum& b) { return a.severity < b.severity; });
  return list;
}

std::string count_of(const std::vector<Erratum>& errata) {
  return fmt::format("{} errata: {} change a result, {} a number, {} the wording, {} a convention",
                     errata.size(), number(errata, Severity::result), number(errata, Severity::number),
                     number(errata, Severity::wording), number(errata, Severity::convention));
}

}  // namespace plumbline::verify
