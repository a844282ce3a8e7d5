#pragma once
/// \file
/// A chain with its ends, supports and loads: what the verbs, the Python package and the diagnosis share.
///
/// Nodes are numbered from 0, the base, to n, the end point; node i is joint i + 1 and the far end of link i.
///
/// \code{.cpp}
/// // A cantilever of two links under its own weight, each link one unit heavy, standing upright.
/// Structure<double> column(Chain<double>({1, 1}, {1, 1}));
/// column.end_point = {};  // free
/// for (std::size_t link = 1; link <= 2; ++link) column.add_weight(link, {-1, 0});
/// const auto N = compression(column).multiplied;  // half a link's weight stands on the middle of each
/// assert(N[0] == 1.5 && N[1] == 0.5);
/// \endcode

#include <plumbline/chain/kinematics.hpp>
#include <plumbline/structure/support.hpp>

namespace plumbline {

/// What a load does when the chain turns.
enum class LoadKind {
  dead,     ///< a force of constant direction
  follower  ///< a force that turns with the link that ends where it acts
};

/// A force at a node.
template <Number Real>
struct Load {
  std::size_t node;                ///< from 0, the base, to n, the end point
  Point<Real> force;               ///< exerted on the chain, at load factor 1
  bool multiplied = true;          ///< by the load factor; else it is there as it stands
  LoadKind kind = LoadKind::dead;  ///< dead or follower
};

/// A chain, what holds it and what loads it. Every member may be set; whoever computes with a structure asks
/// require_sound() first.
template <Number Real>
struct Structure {
  Chain<Real> chain;                         ///< its links and springs; joint 1 is at the base
  Support<Real> base = pinned<Real>();       ///< `turn` is free (k_1 holds link 1) or held (clamped)
  Support<Real> end_point = guided<Real>();  ///< `turn` is of link n against the ground
  std::vector<Restraint<Real>> across;       ///< at nodes 1 … n - 1; none where it is empty
  std::vector<Load<Real>> loads;             ///< all of them
  std::vector<Real> mass;                    ///< at nodes 0 … n, for motion; empty where none is given
  Real moment{0};                            ///< at the end point, turning from x to y, multiplied

  /// With the ends of the paper and no load.
  explicit Structure(Chain<Real> of) : chain(std::move(of)) {}

  /// A unit force against x at the end point, which the load factor multiplies: the load of the paper.
  void add_compression() { loads.push_back({chain.size(), {Real(-1), Real(0)}, true, LoadKind::dead}); }
  /// The weight of a link (from 1), at its middle. A link is rigid, so that half of the weight at either end
  /// is the same.
  void add_weight(std::size_t link, const Point<Real>& weight, bool multiplied = true) {
    const Point<Real> half{weight.x / Real(2), weight.y / Real(2)};
    for (const std::size_t node : {link - 1, link}) loads.push_back({node, half, multiplied, LoadKind::dead});
  }
  /// Springs across the chain as a bed of so much force per deflection and length: each link's share stands
  /// on its two ends. What is held already stays so.
  void add_foundation(const Real& bed) {
    across.resize(chain.size() - 1);
    for (std::size_t link = 1; link <= chain.size(); ++link) {
      const Real half = bed * chain.length()[link - 1] / Real(2);
      for (const std::size_t node : {link - 1, link}) across_of(node).add(half);
    }
  }

  /// What holds node i across the chain.
  [[nodiscard]] Restraint<Real> across_at(std::size_t node) const {
    if (node == 0) return base.across;
    if (node == chain.size()) return end_point.across;
    return across.empty() ? Restraint<Real>() : across[node - 1];
  }
  /// The masses at nodes 0 … n: those that are given, or of each link its length's, half of it at either end.
  [[nodiscard]] std::vector<Real> masses() const {
    if (!mass.empty()) return mass;
    std::vector<Real> lumped(chain.size() + 1, Real(0));
    for (std::size_t link = 1; link <= chain.size(); ++link) {
      for (const std::size_t node : {link - 1, link}) lumped[node] += chain.length()[link - 1] / Real(2);
    }
    return lumped;
  }
  /// Whether some load turns with the chain: then there is no energy.
  [[nodiscard]] bool follower() const {
    return std::any_of(loads.begin(), loads.end(),
                       [](const Load<Real>& load) { return load.kind == LoadKind::follower; });
  }

  /// \throws Error that names the member and what is wrong with it
  void require_sound() const {
    if (!across.empty() && across.size() + 1 != chain.size())
      throw Error("supports", std::to_string(across.size()) + " of them", "one for each joint but the base");
    if (!mass.empty() && mass.size() != chain.size() + 1)
      throw Error("masses", std::to_string(mass.size()) + " of them", "one for the base and for each link");
    if (base.turn.is_held() && !chain.passive_joint(0))
      throw Error("base", "a spring at joint 1 of a clamped base, which holds link 1",
                  "no spring there, stiffness 0; or no clamp, for the spring holds link 1 against the base");
    if (base.turn.hold == Hold::sprung)
      throw Error("base", "a spring that turns beside that of joint 1", "the stiffness of joint 1 alone");
    for (const Load<Real>& load : loads) {
      const std::size_t lowest = load.kind == LoadKind::follower ? 1 : 0;  // the base ends no link
      if (load.node < lowest || load.node > chain.size())
        throw Error("load", "place " + std::to_string(load.node + 1),
                    "a joint from 2 to " + std::to_string(chain.size()) + ", or the end point");
    }
  }

 private:
  Restraint<Real>& across_of(std::size_t node) {
    if (node == 0) return base.across;
    return node == chain.size() ? end_point.across : across[node - 1];
  }
};

/// The same structure in another number type, number by number.
template <Number To, Number From, class Convert>
Structure<To> convert(const Structure<From>& from, Convert one) {
  const auto restraint = [&](const Restraint<From>& r) { return Restraint<To>{r.hold, one(r.stiffness)}; };
  const auto support = [&](const Support<From>& s) {
    return Support<To>{restraint(s.along), restraint(s.across), restraint(s.turn)};
  };
  Structure<To> to(convert<To>(from.chain, one));
  to.base = support(from.base);
  to.end_point = support(from.end_point);
  for (const Restraint<From>& r : from.across) to.across.push_back(restraint(r));
  for (const Load<From>& load : from.loads)
    to.loads.push_back({load.node, {one(load.force.x), one(load.force.y)}, load.multiplied, load.kind});
  for (const From& m : from.mass) to.mass.push_back(one(m));
  to.moment = one(from.moment);
  return to;
}

/// An exact structure, rounded number by number to the nearest ones of another type.
template <Ordered To>
Structure<To> from_rational(const Structure<Rational>& structure) {
  return convert<To>(structure, [](const Rational& value) { return from_rational<To>(value); });
}

/// What compresses each link of the straight chain.
template <Number Real>
struct Compression {
  std::vector<Real> fixed;  ///< N_1 … N_n by the loads that are there as they stand; tension is negative
  std::vector<Real> multiplied;  ///< the same by those that the load factor multiplies, at factor 1
};

/// The compression of the links of the straight chain under its loads.
/// \throws Error for a load that bends the chain, and where not exactly one end is held along it
template <Ordered Real>
Compression<Real> compression(const Structure<Real>& structure) {
  const std::size_t n = structure.chain.size();
  const bool from_base = !structure.base.along.is_free(), from_end = !structure.end_point.along.is_free();
  if (from_base == from_end)
    throw Error("ends", from_base ? "both held along the chain" : "neither held along the chain",
                "one of the two, or what compresses the links is open");
  if (structure.moment != Real(0))
    throw Error("load", "a moment at the end point, which bends the straight chain", "forces along it");
  Compression<Real> N{std::vector<Real>(n, Real(0)), std::vector<Real>(n, Real(0))};
  // from the end that is held on, each link carries what acts beyond it
  for (const Load<Real>& load : structure.loads) {
    if (load.force.y != Real(0))
      throw Error("load", "a force across the straight chain, which bends it", "forces along it");
    std::vector<Real>& at = load.multiplied ? N.multiplied : N.fixed;
    if (from_base && load.node > 0) at[load.node - 1] -= load.force.x;
    if (from_end && load.node < n) at[load.node] += load.force.x;
  }
  for (std::vector<Real>* sums : {&N.fixed, &N.multiplied}) {
    for (std::size_t i = 1; i < n; ++i) {
      if (from_base) (*sums)[n - 1 - i] += (*sums)[n - i];
      if (from_end) (*sums)[i] += (*sums)[i - 1];
    }
  }
  return N;
}

}  // namespace plumbline
