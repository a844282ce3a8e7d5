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

/// Many causes, none of them worth naming, can be as probable together as one that is.
void name_the_next(const Posterior& posterior, Verdict& verdict) {
  if (posterior.causes.size() > 1 && posterior.causes[1].probability > posterior.outside)
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
  if (names() == 1 && posterior.causes.front().probability < (1 - ratio) * (1 - posterior.no_gap))
    name_the_next(posterior, verdict);
  verdict.verdict = names() > 1 ? CauseVerdict::ambiguous : CauseVerdict::identified;
  return verdict;
}

}  // namespace plumbline::diagnose
