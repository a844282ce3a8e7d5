#pragma once
/// \file
/// What the core is to reproduce of straight chains, on random ones: in double and in 50 digits against exact
/// arithmetic, beside the proof for every chain.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace plumbline::verify {

/// The largest deviation that a number type has.
struct Deviation {
  double units = 0;         ///< of the type's epsilon, relative to the exact value
  double digits = 0;        ///< that agree all the same
  std::size_t chains = 0;   ///< that were compared
  std::size_t refused = 0;  ///< that the type does not resolve, by the condition of the problem
  std::uint64_t worst = 0;  ///< the index of the chain that has it
  double used = 0;          ///< the largest part of what rounding and condition allow: above 1 is a failure
};

struct CoreLine {
  std::string what;  ///< "coefficients of the characteristic polynomial"
  Deviation in_double, in_mp50;
  std::string truth;             ///< what is so, where the paper has it otherwise; else empty
  std::string theorem;           ///< of proofs/theorems.md
  std::vector<std::string> coq;  ///< what proves it in proofs/coq; may be empty
};

struct CoreTable {
  std::uint64_t seed;
  std::size_t chains;
  std::vector<CoreLine> lines;
};

/// Chains 0 … chains - 1 of a seed (sampled.hpp). \param advance  called after each
CoreTable core_table(
    std::size_t chains, std::uint64_t seed, const std::function<void()>& advance = [] {});

/// As text: a line each, and the worst chains as chain files.
std::string as_text(const CoreTable& table);

/// Whether every deviation is within what rounding and the condition of the problem allow.
bool holds(const CoreTable& table);

}  // namespace plumbline::verify
