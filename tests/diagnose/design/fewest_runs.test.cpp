#include "diagnose/design/fewest_runs.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline::diagnose;

namespace {

using Runs = std::vector<std::size_t>;

/// One row a run, and no parameter that could imitate: the leads of runs add up.
Contrast additive(const std::vector<double>& leads) {
  Contrast contrast;
  for (const double one : leads)
    contrast.push_back({Eigen::VectorXd::Constant(1, std::sqrt(2 * one)), Eigen::MatrixXd(1, 0)});
  return contrast;
}

bool suffice(const std::vector<Contrast>& contrasts, const Runs& runs, double enough) {
  return std::all_of(contrasts.begin(), contrasts.end(),
                     [&](const Contrast& one) { return expected_log_likelihood_ratio(one, runs) > enough; });
}

/// The size of the smallest set that does, by trying every set.
std::size_t optimum(const std::vector<Contrast>& contrasts, std::size_t count, double enough) {
  std::size_t best = count + 1;
  for (std::size_t set = 0; set < std::size_t{1} << count; ++set) {
    Runs runs;
    for (std::size_t r = 0; r < count; ++r)
      if ((set >> r & 1U) != 0) runs.push_back(r);
    if (runs.size() < best && suffice(contrasts, runs, enough)) best = runs.size();
  }
  return best;
}

}  // namespace

TEST_CASE("two sufficient runs are found where the greedy choice needs three") {
  // Six contrasts; the first run shows four of them, the other two runs three each.
  std::vector<Contrast> contrasts;
  for (int c = 0; c < 6; ++c)
    contrasts.push_back(additive({c % 3 < 2 ? 4.0 : 0.0, c < 3 ? 4.0 : 0.0, c < 3 ? 0.0 : 4.0}));
  const FewestRuns found = fewest_runs(contrasts, 3, 3);
  CHECK(found.runs == Runs{1, 2});
  CHECK(found.proved);
}

TEST_CASE("the most informative of the required runs comes first") {
  // The second run shows two contrasts, the first one.
  const std::vector<Contrast> contrasts{additive({0, 4}), additive({0, 4}), additive({4, 0})};
  CHECK(fewest_runs(contrasts, 2, 3).runs == Runs{1, 0});
  // So it does where the greedy choice is not taken: of the first run, which shows five of seven, and two
  // more.
  std::vector<Contrast> seven;
  for (int c = 0; c < 7; ++c)
    seven.push_back(additive({c > 0 && c < 6 ? 4.0 : 0.0, c < 3 ? 4.0 : 0.0, c < 3 ? 0.0 : 4.0}));
  CHECK(fewest_runs(seven, 3, 3).runs == Runs{2, 1});
}

TEST_CASE("two runs may detect together what neither detects alone") {
  // Each run determines the alternative's one parameter, by another value: only both together refute it.
  const Eigen::MatrixXd slope = Eigen::MatrixXd::Constant(1, 1, 1.0);
  Contrast contrast;
  for (const double difference : {4.0, -4.0})
    contrast.push_back({Eigen::VectorXd::Constant(1, difference), slope});
  CHECK(expected_log_likelihood_ratio(contrast, {0}) == doctest::Approx(0));
  CHECK(expected_log_likelihood_ratio(contrast, {0, 1}) == close_to(16));  // (4² + 4²) / 2
  CHECK(fewest_runs({contrast}, 2, 3).runs.size() == 2);
}

TEST_CASE("nothing to detect needs no run") {
  CHECK(fewest_runs({}, 5, 3).runs.empty());
}

TEST_CASE("the set of runs is minimal, by enumeration") {
  check_property("the size of the set is that of the smallest", [] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 8), pairs = *rc::gen::inRange<std::size_t>(1, 12);
    const double enough = 3;
    Runs all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<Contrast> contrasts;
    for (std::size_t c = 0; c < pairs; ++c) {
      const Eigen::Index parameters = *rc::gen::inRange(0, 2);
      Contrast one;
      for (std::size_t r = 0; r < count; ++r) {
        LinearisedAlternative rows{Eigen::VectorXd(2), Eigen::MatrixXd(2, parameters)};
        for (double& value : rows.difference) value = *rc::gen::inRange(-4, 5);
        for (double& value : rows.slope.reshaped()) value = *rc::gen::inRange(-4, 5);
        one.push_back(rows);
      }
      if (expected_log_likelihood_ratio(one, all) > enough) contrasts.push_back(one);
    }
    const FewestRuns found = fewest_runs(contrasts, count, enough);
    RC_ASSERT(found.proved);
    RC_ASSERT(suffice(contrasts, found.runs, enough));
    RC_ASSERT(found.runs.size() == optimum(contrasts, count, enough));
  });
}
