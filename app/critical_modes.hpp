#pragma once
/// \file
/// The numbers that the verb `critical` shows, right in every digit.

#include <optional>
#include <plumbline/mode.hpp>
#include <string>
#include <vector>

namespace plumbline {

/// A buckling mode as it is shown.
struct CriticalMode {
  std::string force;          ///< correctly rounded decimal
  std::string energy_factor;  ///< (39), from the joint angles
  std::vector<double> q;      ///< joint angles; (q, fy) has norm 1 and q_1 > 0, as in Table 2 of the paper
  double fy;
  std::string signs;  ///< of q, exact zeros included
};

/// The modes of a chain, ascending by force. \throws Error for n = 1 or a mechanism
/// \param digits  significant digits of the forces, each of them correct
/// \param lowest  how many modes; all when left out
std::vector<CriticalMode> critical_modes(const Chain<Rational>& chain, int digits,
                                         std::optional<std::size_t> lowest = std::nullopt);

}  // namespace plumbline
