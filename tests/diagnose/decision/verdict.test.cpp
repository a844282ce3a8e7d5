#include "diagnose/decision/verdict.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <numeric>

#include "diagnose/priors.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

Posterior posterior_of(double no_gap, double outside, const std::vector<double>& causes) {
  Posterior posterior;
  posterior.no_gap = no_gap;
  posterior.outside = outside;
  for (std::size_t i = 0; i < causes.size(); ++i)
    posterior.causes.push_back({{"cause-" + std::to_string(i)}, causes[i], i});
  return posterior;
}

/// The same, where the first cause is a part of all others and leaves these shares of what they change.
Posterior with_parts(Posterior posterior, const std::vector<double>& left) {
  for (std::size_t i = 0; i < left.size(); ++i) posterior.causes[i + 1].left = {left[i]};
  return posterior;
}

/// The loss that is expected of naming the first causes and, if asked, one outside of the catalogue, where
/// there is a gap.
double expected_loss(const Posterior& posterior, std::size_t named, bool or_outside) {
  double missed = or_outside ? 0 : posterior.outside;
  for (std::size_t i = named; i < posterior.causes.size(); ++i)
    missed += posterior.causes[i].probability *
              (posterior.causes[i].left.empty() ? 1 : posterior.causes[i].left[0]);
  const std::size_t names = named + (or_outside ? 1 : 0);
  return static_cast<double>(names) +
         (names > 1 ? priors::wrong_over_further_name : 1.5 * priors::wrong_over_further_name) * missed;
}

}  // namespace

TEST_CASE("the verdict by hand") {
  CHECK(decide(posterior_of(0.6, 0.1, {0.3})).verdict == CauseVerdict::none);
  CHECK(decide(posterior_of(0.4, 0.35, {0.25})).verdict == CauseVerdict::unknown);
  CHECK(decide(posterior_of(0, 0.01, {0.99})).verdict == CauseVerdict::identified);
  const Verdict two = decide(posterior_of(0, 0.01, {0.6, 0.36, 0.03}));
  CHECK(two.verdict == CauseVerdict::ambiguous);
  CHECK(two.named == 2);
  CHECK_FALSE(two.or_outside);
  const Verdict hedged = decide(posterior_of(0, 0.2, {0.8}));
  CHECK(hedged.verdict == CauseVerdict::ambiguous);
  CHECK(hedged.named == 1);
  CHECK(hedged.or_outside);
  CHECK(decide(posterior_of(0.1, 0, {})).verdict == CauseVerdict::unknown);
}

TEST_CASE(
    "where a cause of the catalogue leaves nothing, one outside that is more probable means too few "
    "readings") {
  Posterior posterior = posterior_of(0.1, 0.6, {0.2, 0.09, 0.01});
  CHECK(decide(posterior).verdict == CauseVerdict::unknown);
  posterior.leaves_nothing = true;
  const Verdict verdict = decide(posterior);
  CHECK(verdict.verdict == CauseVerdict::ambiguous);
  CHECK(verdict.too_few_readings);
  CHECK(verdict.or_outside);
  CHECK(verdict.named == 2);                     // the third has less than a twentieth of what the three have
  posterior.causes = {posterior.causes.back()};  // together less than a twentieth: not worth naming
  CHECK(decide(posterior).verdict == CauseVerdict::unknown);
}

TEST_CASE("no other number of names costs less") {
  check_property("least expected loss", [] {
    // Causes from the most probable on, and what is left for one outside of the catalogue.
    std::vector<double> weights = *rc::gen::container<std::vector<double>>(
        5, rc::gen::map(rc::gen::inRange(1, 1000), [](int w) { return static_cast<double>(w * w); }));
    std::sort(weights.begin(), weights.end(), std::greater<>());
    const double other = *rc::gen::inRange(0, 100000);
    const double sum = std::accumulate(weights.begin(), weights.end(), other);
    for (double& one : weights) one /= sum;
    const Posterior posterior = posterior_of(0, other / sum, weights);
    const Verdict verdict = decide(posterior);
    if (verdict.verdict == CauseVerdict::unknown) {
      RC_ASSERT(posterior.outside > 0.5);
      return;
    }
    const double loss = expected_loss(posterior, verdict.named, verdict.or_outside);
    for (std::size_t named = 1; named <= 5; ++named)
      for (const bool or_outside : {false, true})
        RC_ASSERT(loss <= expected_loss(posterior, named, or_outside) + 1e-9);
  });
}

TEST_CASE("many causes that are not worth naming keep one from being named alone") {
  // Alone: 1 + 30 * 0.1 = 4; with the next: 2 + 20 * 0.09 = 3.8.
  const Verdict verdict =
      decide(posterior_of(0, 0, {0.9, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01}));
  CHECK(verdict.verdict == CauseVerdict::ambiguous);
  CHECK(verdict.named == 2);
  const Verdict outside = decide(posterior_of(0, 0.04, {0.93, 0.03}));
  CHECK(outside.named == 1);
  CHECK(outside.or_outside);
}

TEST_CASE("a cause of which the first name is nearly all is not named beside it") {
  const Posterior posterior = posterior_of(0, 0, {0.7, 0.3});
  CHECK(decide(posterior).verdict == CauseVerdict::ambiguous);
  // Alone 1 + 30 * 0.3 left, with the other 2: less below a ninth.
  CHECK(decide(with_parts(posterior, {0.1})).verdict == CauseVerdict::identified);
  CHECK(decide(with_parts(posterior, {0.12})).verdict == CauseVerdict::ambiguous);
  const Verdict other = decide(with_parts(posterior_of(0, 0, {0.6, 0.25, 0.15}), {0.01, 1}));
  CHECK(other.named == 3);  // the third is no form of the first, and the second stands before it
}

TEST_CASE("a name that is more probably a part than the whole has company") {
  const Posterior posterior = posterior_of(0, 0, {0.45, 0.3, 0.25});
  CHECK(decide(with_parts(posterior, {0.01, 0.01})).named == 2);
  CHECK(decide(with_parts(posterior_of(0, 0, {0.55, 0.25, 0.2}), {0.01, 0.01})).named == 1);
}

TEST_CASE("a class is never larger than helps") {
  const Verdict verdict = decide(posterior_of(0, 0.1, std::vector<double>(12, 0.9 / 12)));
  CHECK(verdict.named + (verdict.or_outside ? 1 : 0) == priors::largest_class);
}
