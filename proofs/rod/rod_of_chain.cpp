#include "proofs/rod/rod_of_chain.hpp"

namespace plumbline::proofs {
namespace {

/// What is in series with half a bar where both together have this stiffness.
Restraint<Rational> beyond_half_bar(const Rational& stiffness, const Rational& half_bar) {
  if (stiffness >= half_bar) return Restraint<Rational>::held();
  return Restraint<Rational>::sprung(stiffness * half_bar / (half_bar - stiffness));
}

/// A support without the springs of the bed that stand there.
Restraint<Rational> beside_bed(Restraint<Rational> across, const Rational& bed) {
  if (!across.is_held()) across = Restraint<Rational>::sprung(across.stiffness - bed);
  return across;
}

/// Forces at joints, without the halves of weights that stand there.
void add_forces(const Structure<Rational>& chain, const StatedRod& stated, Rod& rod) {
  std::vector<Growing> dead(chain.chain.size() + 1);
  const auto add = [&](std::size_t node, const Rational& force, bool multiplied) {
    dead[node] += multiplied ? Growing{0, force} : Growing{force, 0};
  };
  for (const Load<Rational>& load : chain.loads) {
    if (load.force.y != 0) throw Error("rod", "a force across it, which bends it", "forces along it");
    if (load.kind == LoadKind::follower)
      rod.loads.push_back({stated.bar * load.node, -load.force.x, load.multiplied, load.kind});
    else
      add(load.node, -load.force.x, load.multiplied);
  }
  for (const LinkWeights& weights : stated.weights) {
    for (std::size_t node = 0; node < dead.size(); ++node) {
      if (node > 0) add(node, -weights.weight[node - 1] / 2, weights.multiplied);
      if (node < weights.weight.size()) add(node, -weights.weight[node] / 2, weights.multiplied);
    }
  }
  for (std::size_t node = 0; node < dead.size(); ++node) {
    if (dead[node].fixed != 0) rod.loads.push_back({stated.bar * node, dead[node].fixed, false});
    if (dead[node].multiplied != 0) rod.loads.push_back({stated.bar * node, dead[node].multiplied, true});
  }
}

void add_weights(const StatedRod& stated, Rod& rod) {
  for (const LinkWeights& weights : stated.weights) {
    for (std::size_t link = 0; link < weights.weight.size(); ++link)
      rod.weights.push_back({stated.bar * link, stated.bar * (link + 1), weights.weight[link] / stated.bar,
                             weights.multiplied});
  }
}

/// Stretches of the same weight in one: the rod is divided where something changes.
void join_weights(std::vector<RodWeight>& weights) {
  std::vector<RodWeight> joined;
  for (const RodWeight& weight : weights) {
    if (!joined.empty() && joined.back().to == weight.from && joined.back().multiplied == weight.multiplied &&
        joined.back().per_length == weight.per_length)
      joined.back().to = weight.to;
    else
      joined.push_back(weight);
  }
  weights = std::move(joined);
}

}  // namespace

Rod rod_of_chain(const Structure<Rational>& chain, const StatedRod& stated) {
  if (!chain.mass.empty()) throw Error("rod", "masses of its nodes", "none: its mass is uniform");
  if (chain.moment != 0) throw Error("rod", "a moment, which bends it", "forces along it");
  const std::size_t n = chain.chain.size();
  const Rational half_bar = 2 * stated.EI / stated.bar, half_bed = stated.bed * stated.bar / 2;
  Rod rod{stated.EI, stated.bar * n, chain.base, chain.end_point};
  rod.bed = stated.bed;
  rod.base.across = beside_bed(chain.base.across, half_bed);
  rod.end_point.across = beside_bed(chain.end_point.across, half_bed);
  if (!rod.base.turn.is_held()) rod.base.turn = beyond_half_bar(chain.chain.stiffness()[0], half_bar);
  if (!rod.end_point.turn.is_held())
    rod.end_point.turn = beyond_half_bar(chain.end_point.turn.stiffness, half_bar);
  for (std::size_t node = 1; node < n; ++node) {
    const Restraint<Rational> across = beside_bed(chain.across_at(node), 2 * half_bed);
    if (!across.is_free()) rod.supports.push_back({stated.bar * node, across});
  }
  add_forces(chain, stated, rod);
  add_weights(stated, rod);
  join_weights(rod.weights);
  return rod;
}

}  // namespace plumbline::proofs
