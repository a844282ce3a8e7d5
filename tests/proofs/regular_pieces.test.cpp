#include "proofs/regular_pieces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/branch/branch_tree.hpp>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("the pieces of a closed branch lead all the way round") {
  // five equal links that look the same from both ends: a branch leaves their symmetric one and comes back
  const std::vector<double> theta{-0.8, 0.1, -0.3, 0.1, -0.8};
  std::vector<double> rest(theta.size());
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = theta[i] - (i > 0 ? theta[i - 1] : 0);
  const std::vector<double> length(5, 1), stiffness{0, 1, 1, 1, 1};
  const auto p = end_point(Chain<double>(length, stiffness, rest), rest);
  const double reach = std::hypot(p.x, p.y);
  rest[0] -= std::atan2(p.y, p.x);
  const NominalModel<double> model(Chain<double>(length, stiffness, rest));
  const auto shape = absolute_angles(rest);
  Brancher<NominalModel<double>> brancher(model, {Control::end_point, {reach, 0}, {-1, 0}}, shape);
  const auto tree = branch_tree(brancher, {brancher.start(0, shape)}, {0, 0.8 * reach});
  const auto closed = std::find_if(tree.begin(), tree.end(),
                                   [](const auto& branch) { return branch.end == BranchEnd::closed; });
  REQUIRE(closed != tree.end());
  const RegularPieces pieces = regular_pieces(brancher, *closed, 1e-5);
  CHECK(pieces.crossings.size() == 2);
  REQUIRE(pieces.points.size() == 3);
  const auto &first = pieces.points.front().front(), &last = pieces.points.back().back();
  CHECK((first.theta - last.theta).norm() < same_point);
}
