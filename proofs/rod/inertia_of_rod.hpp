#pragma once
/// \file
/// How many critical factors of a rod lie below a number: an exact count, in intervals.
///
/// A rod cut into pieces short enough that each, clamped at both ends, is stable has as many negative
/// directions of its energy as the matrix of the ends' forces by the ends' deflections and slopes, which
/// power series give (W. H. Wittrick, F. W. Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284; by
/// Haynsworth for the form itself: proofs/theorems.md). A clamped piece of length l is stable where N l^2 /
/// (4 π^2 E I) + m ω^2 l^4 / (500 E I) < 1, for 4 π^2 and 500.56 are its lowest eigenvalues.

#include "proofs/rod/rod.hpp"

namespace plumbline::proofs {

/// Negative directions of the energy at a load factor, less that of motion at a frequency; all loads are
/// taken as dead ones.
/// \throws Error where an interval leaves a sign open, and for a rod that needs too many pieces
std::size_t negative_directions(const DividedRod& rod, const Rational& factor,
                                const Rational& frequency_squared);

}  // namespace plumbline::proofs
