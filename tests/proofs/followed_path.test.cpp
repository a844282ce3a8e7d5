#include "proofs/followed_path.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

PathReport all_branches(std::size_t links) {
  const std::vector<double> ones(links, 1);
  std::vector<double> rest(links, 0.2);
  rest[0] = -0.3;
  return follow_all({Chain<double>(ones, ones, rest), {Control::force, {0, 0}, {-1, 0}}, 0.1, 0.2});
}

}  // namespace

TEST_CASE("branches apart from the unloaded shape are looked for up to five links, and beyond it is said") {
  CHECK(all_branches(2).warnings.empty());
  const PathReport six = all_branches(6);
  REQUIRE(six.warnings.size() == 1);
  CHECK(six.warnings[0].find("more than five links") != std::string::npos);
}
