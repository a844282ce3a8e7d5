#pragma once
/// \file
/// The properties of chain_properties.hpp on random chains.

#include <array>
#include <cstdint>
#include <functional>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

#include "support/work/journal.hpp"
#include "support/work/work_list.hpp"

namespace plumbline::verify {

struct SampledProperty {
  std::string name, statement;
  std::size_t chains = 0;  ///< to how many of the chains it applied
  std::size_t failures = 0;
  double worst_margin = 0;     ///< largest part of the allowance that was used; above 1 is a failure
  std::string counterexample;  ///< the first chain that failed, as a chain file; else empty
};

/// How many digits Algorithm 1 in double and in 50 digits have in common, force by force.
struct DoubleAgreement {
  std::size_t unresolved = 0;  ///< forces that double cannot resolve (Sample::resolved), or not found
  std::array<std::size_t, 17> digits{};  ///< of the others, how many agree to so many digits and no more
};

/// "N of M forces resolved in double; of these half agree to a digits or more, 99 % to b, all to c".
std::string summary(const DoubleAgreement& agreement);

struct SampledChains {
  std::vector<SampledProperty> properties;
  DoubleAgreement agreement;
};

/// Chain number `index` of a seed: 2 to 8 links, lengths and stiffnesses over up to eight decades or with
/// ties, one time in four a passive base, one time in eight another passive joint. Every number has few
/// enough digits to be the same in double and in rationals.
Chain<double> random_chain(std::uint64_t seed, std::uint64_t index);

/// What another process is told: to check some of the chains.
extern const work::Task chains_task;

/// Checks every property on the first `chains` chains of a seed.
/// \param journal  nothing where nothing is to be kept of work that is cut off
/// \param advance  called with how many chains more are checked
/// \param block    chains of an item of work, which make no difference; 0 for what suits their number
SampledChains check_random_chains(std::size_t chains, std::uint64_t seed, work::Journal* journal,
                                  const std::function<void(std::size_t)>& advance, std::size_t block = 0);

}  // namespace plumbline::verify
