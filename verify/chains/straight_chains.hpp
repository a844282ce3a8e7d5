#pragma once
/// \file
/// The exact chains that the claims of section 4 are tried on.

#include <plumbline/chain/chain.hpp>

namespace plumbline::verify {

/// Section 4.2: four elastic links, L = k = 1.
inline Chain<Rational> four_link_chain() {
  return Chain<Rational>({1, 1, 1, 1}, {1, 1, 1, 1});
}

/// n elastic links without any regularity: L_i = (3i - 1)/i.
inline Chain<Rational> unequal_chain(std::size_t n) {
  std::vector<Rational> length;
  std::vector<Rational> stiffness;
  for (std::size_t i = 1; i <= n; ++i) {
    length.emplace_back(static_cast<int>(3 * i - 1), static_cast<int>(i));
    stiffness.emplace_back(static_cast<int>(7 * (i - 1) % 5 + 1), 2);
  }
  return Chain<Rational>(length, stiffness);
}

}  // namespace plumbline::verify
