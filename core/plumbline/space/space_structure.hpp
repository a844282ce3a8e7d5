#pragma once
/// \file
/// A chain in space with its ends, supports and loads: what the straight one (space_pencil.hpp) and bent ones
/// (bent_structure.hpp) are assembled from.
///
/// \code{.cpp}
/// // An upright cantilever of two links on universal joints, each link one unit heavy.
/// const SpaceJoint<double> universal{{{{0, 0, 1}, 2, 0}, {{0, 1, 0}, 1, 0}}};
/// SpaceStructure<double> column(SpaceChain<double>({1, 1}, {universal, universal}));
/// column.end_point = {};  // free
/// for (std::size_t link = 1; link <= 2; ++link) column.add_weight(link, {-1, 0, 0});
/// assert(compression(column).multiplied[0] == 1.5);
/// \endcode

#include <optional>
#include <plumbline/space/space_chain.hpp>
#include <plumbline/structure/structure.hpp>

namespace plumbline {

/// What holds joint 1.
enum class SpaceBase {
  jointed,  ///< link 1 turns about the axes of joint 1
  bearing,  ///< the same without springs, and a torque is taken up as the end point takes it
  clamped   ///< link 1 does not turn
};

/// What a torque about the line does when the end point turns.
enum class TorqueKind {
  axial,          ///< keeps its direction
  tangential,     ///< turns with the last link
  semitangential  ///< the mean of both: conservative
};

/// A force of constant direction at a node.
template <Number Real>
struct SpaceForce {
  std::size_t node;           ///< from 0, the base, to n, the end point
  std::array<Real, 3> force;  ///< exerted on the chain, at load factor 1
  bool multiplied = true;     ///< by the load factor; else it is there as it stands
};

/// A chain in space, what holds it and what loads it. The base does not move.
template <Number Real>
struct SpaceStructure {
  SpaceChain<Real> chain;                    ///< its links and axes
  SpaceBase base = SpaceBase::jointed;       ///< what holds joint 1
  Support<Real> end_point = guided<Real>();  ///< alike in both directions across; `turn` free or held
  std::vector<Restraint<Real>> across;       ///< at nodes 1 … n - 1, alike in both; none where it is empty
  std::vector<SpaceForce<Real>> loads;       ///< all forces
  std::optional<TorqueKind> torque;          ///< a unit torque at the end point, in place of forces

  /// Jointed, the end point guided, and without a load.
  explicit SpaceStructure(SpaceChain<Real> of) : chain(std::move(of)) {}

  /// A unit force against x at the end point, which the load factor multiplies.
  void add_compression() { loads.push_back({chain.size(), {Real(-1), Real(0), Real(0)}}); }
  /// The weight of a link (from 1), half of it at either end.
  void add_weight(std::size_t link, const std::array<Real, 3>& weight, bool multiplied = true) {
    const std::array<Real, 3> half{weight[0] / Real(2), weight[1] / Real(2), weight[2] / Real(2)};
    for (const std::size_t node : {link - 1, link}) loads.push_back({node, half, multiplied});
  }
  /// A bed of springs across, each link's share on its two ends. What is held already stays so.
  void add_foundation(const Real& bed) {
    across.resize(chain.size() - 1);
    for (std::size_t link = 1; link <= chain.size(); ++link) {
      const Real half = bed * chain.length[link - 1] / Real(2);
      if (link > 1) across[link - 2].add(half);
      (link == chain.size() ? end_point.across : across[link - 1]).add(half);
    }
  }

  /// What holds node i, from 1, across the chain.
  [[nodiscard]] Restraint<Real> across_at(std::size_t node) const {
    if (node == chain.size()) return end_point.across;
    return across.empty() ? Restraint<Real>() : across[node - 1];
  }

  /// \throws Error that names the member and what is wrong with it
  void require_sound() const {
    if (!across.empty() && across.size() + 1 != chain.size())
      throw Error("supports", std::to_string(across.size()) + " of them", "one for each joint but the base");
    if (!end_point.along.is_free())
      throw Error("end_point", "one that is held or sprung along a chain in space", "free along it");
    if (end_point.turn.hold == Hold::sprung)
      throw Error("end_point", "a spring against turning in space", "\"free\" or \"held\"");
    const auto& first = chain.joint[0].axes;
    const bool slack =
        std::all_of(first.begin(), first.end(), [](const Axis<Real>& a) { return a.stiffness == Real(0); });
    if (base == SpaceBase::bearing && !slack)
      throw Error("base", "a bearing beside springs at joint 1", "stiffness 0 there, or \"jointed\"");
    if (base == SpaceBase::clamped && !slack)
      throw Error("base", "springs at joint 1 of a clamped base, which holds link 1",
                  "stiffness 0 there, or \"jointed\"");
    if (torque && !loads.empty()) throw Error("loads", "a torque beside other loads", "a torque alone");
    for (const SpaceForce<Real>& load : loads) {
      if (load.node > chain.size())
        throw Error("load", "place " + std::to_string(load.node + 1),
                    "a joint from 2 to " + std::to_string(chain.size()) + ", or the end point");
    }
  }
};

/// The same structure in another number type, number by number.
template <Number To, Number From, class Convert>
SpaceStructure<To> convert(const SpaceStructure<From>& from, Convert one) {
  const auto restraint = [&](const Restraint<From>& r) { return Restraint<To>{r.hold, one(r.stiffness)}; };
  SpaceStructure<To> to(convert<To>(from.chain, one));
  to.base = from.base;
  to.end_point = {restraint(from.end_point.along), restraint(from.end_point.across),
                  restraint(from.end_point.turn)};
  for (const Restraint<From>& r : from.across) to.across.push_back(restraint(r));
  for (const SpaceForce<From>& load : from.loads)
    to.loads.push_back(
        {load.node, {one(load.force[0]), one(load.force[1]), one(load.force[2])}, load.multiplied});
  to.torque = from.torque;
  return to;
}

/// An exact structure, rounded number by number to the nearest ones of another type.
template <Ordered To>
SpaceStructure<To> from_rational(const SpaceStructure<Rational>& structure) {
  return convert<To>(structure, [](const Rational& value) { return from_rational<To>(value); });
}

/// The compression of the links of the straight chain under its forces.
/// \throws Error for a force across the chain, which bends it
template <Ordered Real>
Compression<Real> compression(const SpaceStructure<Real>& structure) {
  const std::size_t n = structure.chain.size();
  Compression<Real> N{std::vector<Real>(n, Real(0)), std::vector<Real>(n, Real(0))};
  for (const SpaceForce<Real>& load : structure.loads) {
    if (load.force[1] != Real(0) || load.force[2] != Real(0))
      throw Error("loads", "a force across the straight chain, which bends it", "forces along x");
    std::vector<Real>& at = load.multiplied ? N.multiplied : N.fixed;
    for (std::size_t link = 0; link < load.node; ++link) at[link] -= load.force[0];
  }
  return N;
}

}  // namespace plumbline
