#pragma once
/// \file
/// Critical factors by a dense solver in fifty digits, from the energy written out link by link: nothing of
/// the band, the string or the counts.

#include <plumbline/structure/structure.hpp>
#include <vector>

/// The positive ones, ascending, of a structure that is stable without its multiplied loads, which has no
/// load that follows it.
std::vector<plumbline::Mpfr50> dense_factors(const plumbline::Structure<plumbline::Rational>& structure);
