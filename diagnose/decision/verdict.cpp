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

/// Loss of a cause that is not named where one alone is, over that of naming one more.
constexpr double wrong_alone = 1.5 * priors::wrong_over_further_name;

/// Probability of a cause, times the share of what it changes that the causes named leave of it.
double probability_left(const CauseProbability& one, std::size_t named) {
  double left = 1;
  for (std::size_t k = 0; k < std::min(named, one.left.size()); ++k) left = std::min(left, one.left[k]);
  return left * one.probability;
}

/// A cause in the catalogue, or one outside of it, that is named beside the only one where that costs less:
/// many causes, none of them worth naming by itself, can be as probable together as one that is.
void name_another(const Posterior& posterior, Verdict& verdict) {
  const auto lost = [&](std::size_t named, bool or_outside) {
    double sum = or_outside ? 0 : posterior.outside;
    for (std::size_t i = named; i < posterior.causes.size(); ++i)
      sum += probability_left(posterior.causes[i], named);
    return sum;
  };
  const double with_outside = lost(1, true),
               with_next = posterior.causes.size() > 1 ? lost(2, false) : lost(1, false),
               least = std::min(with_outside, with_next);
  if (wrong_alone * lost(1, false) <= 1 + priors::wrong_over_further_name * least) return;
  if (with_next < with_outside)
    ++verdict.named;
  else
    verdict.or_outside = true;
}

/// Causes of which the only name is a part are named from the most probable on where they are more probable
/// together than that name: a further effect is then more probable than none.
void name_whole(const Posterior& posterior, Verdict& verdict) {
  double whole = 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < posterior.causes.size(); ++i)
    if (probability_left(posterior.causes[i], 1) < posterior.causes[i].probability) {
      whole += posterior.causes[i].probability;
      if (first == 0) first = i;
    }
  if (whole > posterior.causes.front().probability) verdict.named = first + 1;
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
  const std::size_t most = priors::largest_class - (verdict.or_outside ? 1 : 0);
  verdict.named = 1;
  for (std::size_t i = 1; i < std::min(most, posterior.causes.size()); ++i)
    if (probability_left(posterior.causes[i], verdict.named) >= worth_naming) verdict.named = i + 1;
  if (names() == 1) name_another(posterior, verdict);
  if (names() == 1) name_whole(posterior, verdict);
  verdict.verdict = names() > 1 ? CauseVerdict::ambiguous : CauseVerdict::identified;
  return verdict;
}

}  // namespace plumbline::diagnose
