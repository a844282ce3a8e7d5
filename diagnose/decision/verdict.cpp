#include "diagnose/decision/verdict.hpp"

#include <algorithm>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {

std::string verdict_word(CauseVerdict verdict) {
  switch (verdict) {
    case CauseVerdict::none:
      return "none";
    case CauseVerdict::identified:
      return "identified";
    case CauseVerdict::ambiguous:
      return "ambiguous";
    case CauseVerdict::partial:
      return "partial";
    case CauseVerdict::unknown:
      break;
  }
  return "unknown";
}

namespace {

/// A cause in the catalogue, or one outside of it, that is named beside the only one where that costs less:
/// many causes, none of them worth naming by itself, can be as probable together as one that is.
void name_another(const Posterior& posterior, Verdict& verdict) {
  double others = posterior.outside;
  for (std::size_t i = 1; i < posterior.causes.size(); ++i) others += posterior.causes[i].probability;
  const double next_listed = posterior.causes.size() > 1 ? posterior.causes[1].probability : 0,
               next = std::max(posterior.outside, next_listed);
  if (priors::wrong_alone_over_further_name * others <= 1 + priors::wrong_over_further_name * (others - next))
    return;
  if (next_listed > posterior.outside)
    ++verdict.named;
  else
    verdict.or_outside = true;
}

}  // namespace

Verdict decide(const Posterior& posterior) {
  if (posterior.no_gap > 0.5) return {};
  constexpr double ratio = 1 / priors::wrong_over_further_name;
  Verdict verdict{CauseVerdict::unknown, 0, posterior.outside >= ratio};
  double listed = 0;
  for (const CauseProbability& one : posterior.causes) listed += one.probability;
  if (posterior.causes.empty()) return verdict;
  const bool outside_leads = posterior.outside > listed;
  if (outside_leads && (listed < ratio || !posterior.leaves_nothing)) return verdict;
  verdict.too_few_readings = outside_leads;
  const double worth_naming = ratio * (outside_leads ? listed : 1);
  const auto names = [&] { return verdict.named + (verdict.or_outside ? 1 : 0); };
  for (const CauseProbability& one : posterior.causes)
    if (verdict.named == 0 || (one.probability >= worth_naming && names() < priors::largest_class))
      ++verdict.named;
  if (names() == 1) name_another(posterior, verdict);
  verdict.verdict = names() > 1 ? CauseVerdict::ambiguous : CauseVerdict::identified;
  return verdict;
}

}  // namespace plumbline::diagnose
