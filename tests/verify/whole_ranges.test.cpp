/// \file
/// Proofs over whole ranges of deflections against censuses and located states at some of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/three_link_plane.hpp"
#include "verify/paper/paper.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

HeldChain chain_of(const std::string& premise) {
  return held(paper().given({premise}), premise);
}
const PlaneProof& fig7_plane() {
  return prove_in_plane(chain_of("fig-7-chain"), 0, Rational(1135, 1000));
}

bool meet(const Interval& a, const Interval& b) {
  return intersection(a, b).has_value();
}

}  // namespace

TEST_CASE("the plane of both joint angles has every equilibrium of a census in a piece of its shape") {
  REQUIRE(fig7_plane().whole);
  for (const Rational& d : {Rational(1, 50), Rational(1, 2), Rational(1135, 1000)}) {
    const proofs::Census& census = chain_of("fig-7-chain").at(d);
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
  const HeldChain chain = chain_of("fig-7-chain");
  CHECK(chain.at(Rational(1140, 1000)).equilibria.size() > 4);
  CHECK_FALSE(prove_in_plane(chain, Rational(1, 2), Rational(1140, 1000)).whole);
  // and where the straight chain buckles
  CHECK_FALSE(prove_in_plane(chain_of("three-links"), 0, Rational(1, 10)).whole);
}

TEST_CASE("what has less of something in the plane has it in every census") {
  CHECK(fig7_plane().least("--", &PlanePiece::energy));
  CHECK_FALSE(fig7_plane().least("++", &PlanePiece::energy));
  CHECK_FALSE(fig7_plane().least("+-", &PlanePiece::compression));
}

TEST_CASE("enclosures of all states of a proved path hold the located ones") {
  for (const char* const premise : {"fig-7-chain", "u-chain", "z-chain"}) {
    const SlowPath* const path = &chain_of(premise).compressed(far);
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

TEST_CASE("the force that is said of a state is that of (6): J^T F + K (q - q0) = 0, row by row") {
  for (const char* const premise : {"fig-7-chain", "fig-8-chain", "u-chain", "z-chain"}) {
    const HeldChain held = chain_of(premise);
    for (const proofs::CertifiedEquilibrium& one : held.at(Rational(1, 5)).equilibria) {
      const PaperForce<Interval> force = paper_force(one);
      const Matrix<Interval> J = jacobian(held.chain, one.q);
      for (std::size_t i = 0; i < one.q.size(); ++i) {
        const auto joint = static_cast<Eigen::Index>(i);
        const Interval row = J(0, joint) * force.x + J(1, joint) * force.y +
                             held.chain.stiffness()[i] * (one.q[i] - held.chain.rest()[i]);
        CHECK_MESSAGE(row.contains_zero(), premise << ", row " << i + 1);
      }
    }
  }
  // the end point of an elastic base is held by F_y = -k_1 (q_1 - q_1^0) / x
  const HeldChain u = chain_of("u-chain");
  for (const proofs::CertifiedEquilibrium& one : u.at(Rational(2, 5)).equilibria)
    CHECK((paper_force(one).y * one.x + one.q[0] - u.chain.rest()[0]).contains_zero());
}

TEST_CASE("what does not hold of every state, or beyond the path, is not said") {
  const auto any = [](const proofs::CertifiedEquilibrium&) { return true; };
  const auto bent = [](const proofs::CertifiedEquilibrium& one) { return signs(one) == "-+-+"; };
  const SlowPath& z_path = chain_of("z-chain").compressed(far);
  CHECK(z_path.everywhere(0, Rational(3, 2), any));
  CHECK_FALSE(z_path.everywhere(0, Rational(8, 5), any));
  CHECK(z_path.everywhere(0, Rational(7, 5), bent));
  CHECK_FALSE(z_path.everywhere(0, Rational(3, 2), bent));
}
