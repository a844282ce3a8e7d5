#pragma once
/// \file
/// Numbers and chains that the parameters of a check name.

#include "verify/chains/loaded_chains.hpp"
#include "verify/generic/generic.hpp"

namespace plumbline::verify {

/// A number, or the id of a premise that has one.
Interval quantity(const std::string& text, const Premises& given);
/// The same as a fraction. \throws Error where it is none
Rational exact_quantity(const std::string& text, const Premises& given);

/// The chain of the parameter `chain`, with so many links as `links` says: lists that are shorter go on with
/// their last entry, rest angles with zero.
Premise chain_with_links(const Parameters& with, const Premises& given);
/// The same with a number of links.
Premise with_links(const Premise& chain, std::size_t links);

/// "theta 1" as "theta_1".
std::string with_index(std::string name);

/// "the chain with L = (1, 1), k = (0, 1) and the rest angles (pi/6, 0)".
std::string in_words(const Premise& chain);

/// The chain of a premise that is none of a claim's.
Chain<Rational> exact_chain(const Premise& chain);
HeldChain held_chain(const Premise& chain);

}  // namespace plumbline::verify
