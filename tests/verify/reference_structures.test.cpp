#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "verify/reference/structures.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

const double pi = std::acos(-1.0);

double lowest(const std::vector<StructureCase>& cases, const std::string& name) {
  for (const StructureCase& one : cases) {
    if (one.name == name) return std::stod(structure_entry(one).entry["factor"][0].get<std::string>());
  }
  FAIL("no case " << name);
  return 0;
}

}  // namespace

TEST_CASE(
    "the structures of the reference set have names of their own, and the compact ones are among the full "
    "ones" *
    doctest::test_suite("long")) {
  const auto compact = structure_cases(ReferenceSize::compact, reference_seed);
  std::set<std::string> names, all;
  for (const auto& one : compact) CHECK(names.insert(one.name).second);
  for (const auto& one : structure_cases(ReferenceSize::full, reference_seed))
    CHECK(all.insert(one.name).second);
  for (const std::string& name : names) CHECK(all.count(name) == 1);
}

TEST_CASE("their closed forms") {
  const auto cases = structure_cases(ReferenceSize::compact, reference_seed);
  for (const int n : {2, 3, 5, 10}) {
    const std::string links = std::to_string(n);
    CHECK(lowest(cases, "pinned-pinned-" + links) ==
          doctest::Approx(4 * std::pow(std::sin(pi / (2 * n)), 2)).epsilon(1e-13));
    CHECK(lowest(cases, "fixed-free-" + links) ==
          doctest::Approx(2 - 2 * std::cos(pi / (2 * n + 1))).epsilon(1e-13));
    CHECK(lowest(cases, "rod-clamped-free-" + links) ==
          doctest::Approx(4 * n * n * std::pow(std::sin(pi / (4 * n)), 2)).epsilon(1e-13));
    CHECK(lowest(cases, "rod-clamped-clamped-" + links) ==
          doctest::Approx(4 * n * n * std::pow(std::sin(pi / n), 2)).epsilon(1e-13));
  }
  CHECK(lowest(cases, "follower-ziegler") == doctest::Approx(3.5 - std::sqrt(2.0)).epsilon(1e-14));
}
