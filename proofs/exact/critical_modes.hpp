#pragma once
/// \file
/// The numbers that the verb `critical` shows, right in every digit.

#include <plumbline/chain/mode.hpp>
#include <plumbline/straight/straight_chain.hpp>
#include <string>
#include <vector>

namespace plumbline::proofs {

/// A buckling mode as it is shown.
struct CriticalMode {
  std::string force;          ///< correctly rounded decimal (a force half-way between two goes to the larger)
  std::string energy_factor;  ///< (39), which is the force, to 15 digits or as many as the force if fewer
  std::vector<double> q;  ///< joint angles; the largest is 1 or -1, the first that is not zero is positive
  Rational fy;            ///< lateral force F_y at these angles
  std::string signs;      ///< of q, "0" where a joint does not turn
};

/// The lowest critical forces, to so many significant digits, with their modes; all when `lowest` is n - 1 or
/// more.
/// \throws Error for n = 1 or a mechanism
std::vector<CriticalMode> modes_in_decimals(const StraightChain<Rational>& chain, std::size_t lowest,
                                            int digits);

/// The same without the shapes: q and signs are empty.
std::vector<CriticalMode> forces_in_decimals(const StraightChain<Rational>& chain, std::size_t lowest,
                                             int digits);

}  // namespace plumbline::proofs
