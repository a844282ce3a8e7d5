#pragma once
/// \file
/// The chain of Fig. 8 as it is slowly compressed: where it buckles, and what is next to that.

#include "verify/chains/loaded_chains.hpp"

namespace plumbline::verify::fig_8 {

HeldChain zigzag(const Premises& given);

/// As far as it is followed: a fifth of its reach, up to the next tenth.
Rational last(const Premises& given);

/// What it does, to the side on which the first angle grows.
const SlowPath& path(const Premises& given);

/// Where the zigzag loses its stability.
const BranchEvent<proofs::Located>& buckling(const Premises& given);

/// The deflection of the bifurcation, and distances from it that are small beside it.
struct Neighbourhood {
  Rational at, next, wide;
};
Neighbourhood around(const Premises& given);

/// Mean stiffness next to the bifurcation, before and after it.
std::pair<Interval, Interval> stiffnesses(const Premises& given);

/// The same in words.
std::string next_to_bifurcation(const Premises& given);

/// Whether the stiffness falls by half or more at the bifurcation.
std::string change_of_stiffness(const Premises& given);

/// Where joint 2 straightens beyond the bifurcation.
proofs::Located arch(const Premises& given);

/// Where the first angle passes zero there.
proofs::Located level(const Premises& given);

}  // namespace plumbline::verify::fig_8
