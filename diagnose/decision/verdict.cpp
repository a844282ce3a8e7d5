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
    case CauseVerdict::unknown:
      break;
  }
  return "unknown";
}

Verdict decide(const Posterior& posterior) {
  const double most = posterior.causes.empty() ? 0 : posterior.causes.front().probability;
  if (posterior.no_gap >= std::max(most, posterior.outside)) return {};
  constexpr double worth_naming = 1 / priors::wrong_over_further_name;
  Verdict verdict{CauseVerdict::unknown, {}, posterior.outside >= worth_naming};
  double listed = 0;
  for (const CauseProbability& one : posterior.causes) listed += one.probability;
  if (posterior.outside > listed) return verdict;
  for (std::size_t i = 0; i < posterior.causes.size(); ++i)
    if (i == 0 || posterior.causes[i].probability >= worth_naming) verdict.named.push_back(i);
  const std::size_t others = verdict.or_outside ? 1 : 0;
  verdict.named.resize(std::min(verdict.named.size(), priors::largest_class - others));
  verdict.verdict =
      verdict.named.size() + others > 1 ? CauseVerdict::ambiguous : CauseVerdict::identified;
  return verdict;
}

}  // namespace plumbline::diagnose
