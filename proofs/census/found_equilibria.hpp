#pragma once
/// \file
/// Equilibria that floating point finds: fast, for any n, and never sure to be all.

#include "proofs/census/census_task.hpp"

namespace plumbline::proofs {

/// One equilibrium in double precision, in the units of its chain: forces and energies may be out of a
/// double's range.
struct FoundEquilibrium {
  std::vector<double> q;  ///< joint angles; a passive joint's within half a turn
  Interval::End x, y, fx, fy, energy;
  std::size_t negative_directions;
};

struct FoundEquilibria {
  std::vector<FoundEquilibrium>
      equilibria;      ///< by energy; no two differ by full turns of passive joints alone
  Window window;       ///< the joint angles looked at; empty under a force: all
  std::size_t starts;  ///< random shapes that Newton's method began from
  bool exhausted;  ///< all that were meant to be tried; else there are more equilibria, perhaps a continuum
};

/// Newton's method from 1000 n random shapes, the same at every call, until a thousand equilibria are found.
/// \throws Error for an end point out of reach
FoundEquilibria find_equilibria(const CensusTask& task);

}  // namespace plumbline::proofs
