#include "proofs/found_equilibria.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

CensusTask under(const std::vector<Rational>& stiffness, const Rational& force) {
  const std::vector<Rational> ones(stiffness.size(), Rational(1));
  CensusTask task{"", Chain<Rational>(ones, stiffness), false, Given::force, {force, 0}, 0};
  return task;
}

}  // namespace

TEST_CASE("what floating point finds of a small chain is all that a census proves") {
  // the first: all links in line and the last two folded back, which share q_1 = 0
  for (const CensusTask& task :
       {under({1, 0, 1}, Rational(-1, 2)), under({1, 1}, Rational(-1, 5)), under({1, 1}, -4)}) {
    const Census census = take_census(task);
    REQUIRE(census.complete());
    const FoundEquilibria found = find_equilibria(task);
    CHECK(found.exhausted);
    REQUIRE(found.equilibria.size() == census.equilibria.size());
    for (const FoundEquilibrium& one : found.equilibria) {
      const auto same = std::count_if(
          census.equilibria.begin(), census.equilibria.end(), [&](const CertifiedEquilibrium& other) {
            for (std::size_t i = 0; i < one.q.size(); ++i) {
              const double apart = one.q[i] - static_cast<double>(other.q[i].middle());
              const bool passive = task.chain.stiffness()[i] == 0;
              if (std::abs(passive ? std::remainder(apart, 2 * M_PI) : apart) > 1e-6) return false;
            }
            return other.negative_directions == one.negative_directions;
          });
      CHECK(same == 1);
    }
  }
}
