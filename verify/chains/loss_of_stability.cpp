#include "verify/chains/loss_of_stability.hpp"

#include <plumbline/base/error.hpp>
#include <plumbline/straight/motion.hpp>

#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "proofs/rod/critical_rod.hpp"

namespace plumbline::verify {
namespace {

constexpr int digits_of_a_loss = 10;

std::string of_follower(proofs::Motion kind) {
  return kind == proofs::Motion::flutter ? "flutter" : "divergence";
}

}  // namespace

LossOfStability loss_of_stability(const Structure<Rational>& structure) {
  if (!structure.follower()) {
    const auto found = proofs::StraightStructure(structure).enclose(1, digits_of_a_loss).front();
    return {"buckling", found.low, found.high};
  }
  const auto found = proofs::stability_loss(straight_motion(structure), digits_of_a_loss);
  if (!found.first)
    throw Error("chain", "an earlier loss of stability that is not excluded", "a proved first one");
  return {of_follower(found.kind), found.low, found.high};
}

LossOfStability loss_of_rod(const statement::PlaneChain& chain) {
  if (!chain.beam) throw Error("chain", "no rod", "one stated by the key beam");
  const auto found =
      proofs::critical_rod(proofs::rod_of_chain(chain.structure, *chain.beam), digits_of_a_loss);
  const std::string kind = chain.structure.follower() ? of_follower(found.kind) : "buckling";
  return {kind, found.factor.low, found.factor.high};
}

}  // namespace plumbline::verify
