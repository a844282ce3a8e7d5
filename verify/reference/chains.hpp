#pragma once
/// \file
/// The chains of the reference values: exact decimals, the same on every machine.

#include <cstdint>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::verify {

/// A chain and what is published about it.
struct ReferenceChain {
  std::string name;  ///< family, a dash, and what tells it from the others of the family
  Chain<Rational> chain;
  std::size_t modes;   ///< the lowest so many
  std::size_t shapes;  ///< of the lowest so many modes
};

enum class ReferenceSize {
  compact,  ///< about a hundred chains: fit for a repository
  full,     ///< a few thousand; holds all of the compact ones
};

/// The seed of the published set.
inline constexpr std::uint64_t reference_seed = 2022;

/// Which set.
struct ReferenceWish {
  ReferenceSize size = ReferenceSize::full;
  std::uint64_t seed = reference_seed;
  std::size_t random = 0;  ///< chains of the family random; 0 for what the size has

  bool operator==(const ReferenceWish&) const = default;
};

/// | family           | chains                                                                            |
/// |------------------|-----------------------------------------------------------------------------------|
/// | paper            | the straight two-link, three-link (passive base) and four-link chains of the paper |
/// | uniform-pinned   | unit links and stiffnesses, passive base: F_m = 4 sin^2(m pi / 2n)                |
/// | uniform-clamped  | unit links and stiffnesses                                                        |
/// | random           | decimals of three digits between 0.1 and 10                                       |
/// | binary           | multiples of 1/64 up to 10: exact in binary floating point                        |
/// | graded           | decimals of three digits, any order of magnitude from 1e-8 to 1e8                 |
/// | geometric        | lengths and stiffnesses in geometric progressions                                 |
/// | passive-base     | like random, first joint passive                                                  |
/// | passive-interior | like random, another joint passive                                                |
/// | tie              | an interior passive joint, two or more critical forces exactly equal              |
/// | near-tie         | the same with one stiffness off by a part in 10 to 10^60                           |
/// | long             | like random, 100 to 1000 links                                                    |
///
/// A chain depends on its name and the seed alone, so that sets of different sizes agree.
std::vector<ReferenceChain> reference_chains(const ReferenceWish& wish);

}  // namespace plumbline::verify
