/// \file
/// Proofs over whole ranges of deflections against censuses and located states at some of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/three_link_plane.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

bool meet(const Interval& a, const Interval& b) {
  return intersection(a, b).has_value();
}

}  // namespace

TEST_CASE("the plane of both joint angles has every equilibrium of a census in a piece of its shape") {
  const Interval reach = unloaded_reach(fig7_chain());
  REQUIRE(fig7_plane().whole);
  for (const Rational& d : {Rational(1, 50), Rational(1, 2), Rational(1135, 1000)}) {
    const proofs::Census census = held_at(fig7_chain(), reach - Interval(d));
    CHECK(census.equilibria.size() == 4);
    for (const proofs::CertifiedEquilibrium& one : census.equilibria) {
      const auto& pieces = fig7_plane().pieces;
      CHECK(std::any_of(pieces.begin(), pieces.end(), [&](const PlanePiece& piece) {
        return piece.signs == signs(one, 1) && meet(piece.distance, sqr(one.x)) &&
               meet(piece.energy, one.energy) && meet(piece.compression, -one.fx);
      }));
    }
  }
}

TEST_CASE("the proof in the plane fails where equilibria begin within the range") {
  const Interval reach = unloaded_reach(fig7_chain());
  CHECK(held_at(fig7_chain(), reach - Interval(Rational(1140, 1000))).equilibria.size() > 4);
  CHECK_FALSE(prove_in_plane(fig7_chain(), reach, Rational(1, 2), Rational(1140, 1000)).whole);
  // and where the straight chain buckles
  CHECK_FALSE(prove_in_plane(three_link_chain_at(0, 0), Interval(3), 0, Rational(1, 10)).whole);
}

TEST_CASE("what has less of something in the plane has it in every census") {
  CHECK(fig7_plane().least("--", &PlanePiece::energy));
  CHECK_FALSE(fig7_plane().least("++", &PlanePiece::energy));
  CHECK_FALSE(fig7_plane().least("+-", &PlanePiece::compression));
}

TEST_CASE("enclosures of all states of a proved path hold the located ones") {
  for (const SlowPath* const path : {&fig7_path(), &u_path(), &z_path()}) {
    for (const Rational& d : {Rational(1, 100), Rational(1, 3), Rational(7, 5)}) {
      const BranchPoint<proofs::Located> state = path->at(d);
      const std::vector<proofs::Located> q = joint_angles(state.theta);
      const auto around = [](const proofs::Located& x) {
        const Interval::End slack("1e-30"), middle(x);
        return Interval(middle - slack, middle + slack);
      };
      std::size_t asked = 0;
      CHECK(path->everywhere(d, d, [&](const proofs::CertifiedEquilibrium& one) {
        ++asked;
        bool holds = meet(one.fx, around(state.force.x)) && meet(one.fy, around(state.force.y));
        for (std::size_t i = 0; i < q.size(); ++i) holds = holds && meet(one.q[i], around(q[i]));
        return holds;
      }));
      CHECK(asked > 0);
    }
  }
}

TEST_CASE("what does not hold of every state, or beyond the path, is not said") {
  const auto any = [](const proofs::CertifiedEquilibrium&) { return true; };
  const auto bent = [](const proofs::CertifiedEquilibrium& one) { return signs(one) == "-+-+"; };
  CHECK(z_path().everywhere(0, Rational(3, 2), any));
  CHECK_FALSE(z_path().everywhere(0, Rational(8, 5), any));
  CHECK(z_path().everywhere(0, Rational(7, 5), bent));
  CHECK_FALSE(z_path().everywhere(0, Rational(3, 2), bent));
}
