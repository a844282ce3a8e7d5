#include "proofs/paths/regular_pieces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/branch/branch_tree.hpp>

#include "tests/close_to.hpp"

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

TEST_CASE(
    "a branch is cut at a crossing, with a point at the edge of the gap on either side and none within") {
  const std::vector<double> ones(2, 1);
  const NominalModel<double> model(Chain<double>(ones, ones));
  const Vector<double> straight = Vector<double>::Zero(2);
  Brancher<NominalModel<double>> brancher(model, {Control::force, {0, 0}, {-1, 0}}, straight);
  const auto branch = Tracer<NominalModel<double>>(brancher, {0, 1, 0.01}).run(brancher.start(0, straight));
  REQUIRE(branch.events.size() == 1);
  const double crossing = branch.events[0].point.load, unit = brancher.load_scale();
  CHECK(crossing == close_to((3 - std::sqrt(5)) / 2).epsilon(1e-12));
  for (const double gap : {1e-3, 1e-2, 0.05}) {
    CAPTURE(gap);
    const RegularPieces pieces = regular_pieces(brancher, branch, gap);
    REQUIRE(pieces.crossings.size() == 1);
    REQUIRE(pieces.points.size() == 2);
    const auto &before = pieces.points[0], &behind = pieces.points[1];
    // along the straight branch the load alone changes; Newton's method, to a few roundings
    CHECK((crossing - before.back().load) / unit == close_to(gap).epsilon(1e-9));
    CHECK((behind.front().load - crossing) / unit == close_to(gap).epsilon(1e-9));
    CHECK(before.front().load == branch.points.front().load);
    CHECK(behind.back().load == branch.points.back().load);
    for (const auto& piece : pieces.points) {
      for (std::size_t i = 1; i < piece.size(); ++i) CHECK(piece[i - 1].load < piece[i].load);
    }
    // points of the branch that are two gaps away or farther are kept, nearer ones are not
    std::size_t kept = 0;
    for (const auto& point : branch.points) kept += std::abs(point.load - crossing) / unit >= 2 * gap ? 1 : 0;
    CHECK(before.size() + behind.size() == kept + 2);
    CHECK(pieces.crossings[0].point.load == crossing);
    CHECK(pieces.crossings[0].loads.low == before.back().load);
    CHECK(pieces.crossings[0].loads.high == behind.front().load);
  }
}

TEST_CASE("a branch that begins within the gap around a crossing has an empty piece before it") {
  const std::vector<double> ones(2, 1);
  const NominalModel<double> model(Chain<double>(ones, ones));
  const Vector<double> straight = Vector<double>::Zero(2);
  Brancher<NominalModel<double>> brancher(model, {Control::force, {0, 0}, {-1, 0}}, straight);
  const double gap = 0.01, unit = brancher.load_scale(),
               critical = (3 - std::sqrt(5)) / 2;  // the least root of det(K - F L)
  const auto branch = Tracer<NominalModel<double>>(brancher, {0, 1, 0.01})
                          .run(brancher.start(critical - gap * unit / 2, straight));
  REQUIRE(branch.events.size() == 1);
  const RegularPieces pieces = regular_pieces(brancher, branch, gap);
  REQUIRE(pieces.crossings.size() == 1);
  REQUIRE(pieces.points.size() == 2);
  CHECK(pieces.points[0].empty());
  REQUIRE(pieces.points[1].size() > 1);
  // along the straight branch the load alone changes; Newton's method, to a few roundings
  const Crossing& crossing = pieces.crossings[0];
  CHECK(crossing.point.load == close_to(critical).epsilon(1e-12));
  CHECK((pieces.points[1].front().load - critical) / unit == close_to(gap).epsilon(1e-9));
  CHECK(crossing.loads.low == crossing.point.load);
  CHECK(crossing.loads.high == pieces.points[1].front().load);
  CHECK(pieces.points[1].back().load == branch.points.back().load);
}
