#pragma once
/// \file
/// Equilibria of chains with any ends and loads, in the plane and in space, in doubles: branches as the
/// factor of the loads grows, and all that random shapes lead to.

#include <cstdint>
#include <plumbline/space/bent_branch.hpp>

namespace plumbline::proofs {

/// What was followed, and what of it cannot be trusted to be complete.
struct StructurePath {
  bool history;  ///< stretches of what really happens, in order; else branches
  std::vector<BentBranch<double>> branches;
  std::vector<std::string> warnings;
};

/// How it is followed.
struct StructureTask {
  double last;   ///< the factor grows from 0 to here
  double step;   ///< longest way between points, in radians
  int side = 1;  ///< where a symmetric structure buckles
};

/// \throws Error where what holds a straight chain is dependent there and not beside it: small motion then
///         tells of no stability
void require_regular_line(SpaceStructure<Rational> structure);

/// What the slowly loaded structure does, from its unloaded shape: fixed loads are there from the beginning.
/// \param wide  the same structure in more digits, in which singular shapes are judged
/// \throws Error where it does not come to rest, or does at a singular shape
StructurePath follow_slowly(const BentStructure<double>& model, const BentStructure<Mpfr50>& wide,
                            const StructureTask& task);
/// Every branch that hangs together with the unloaded shape.
StructurePath follow_all(const BentStructure<double>& model, const BentStructure<Mpfr50>& wide,
                         const StructureTask& task);

/// An equilibrium that a random shape led to.
struct SampledEquilibrium {
  BentPoint<double> point;
  bool singular;  ///< at a singular shape of what holds the structure: whether it is stable is not decided
};

/// Equilibria at a factor by energy, from so many random shapes: never sure to be all. Joint angles are
/// sought within `turn` of those at rest.
std::vector<SampledEquilibrium> find_equilibria(const BentStructure<double>& model,
                                                const BentStructure<Mpfr50>& wide, double factor,
                                                std::size_t starts, double turn, std::uint64_t seed);

}  // namespace plumbline::proofs
