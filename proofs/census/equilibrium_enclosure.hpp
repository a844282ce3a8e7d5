#pragma once
/// \file
/// From a box of doubles that holds one root of the equilibrium equations to an enclosure of fifty digits and
/// a type.

#include "proofs/census/census.hpp"
#include "proofs/census/equilibrium_box.hpp"

namespace plumbline::proofs {

/// \param chain     in units of its own (proofs/exact/units.hpp)
/// \param isolated  a box that holds exactly one root; the root near its middle is enclosed
/// \returns nothing where the root does not let itself be enclosed, such as beside a fold
std::optional<CertifiedEquilibrium> enclose(const Chain<Interval>& chain, Control control,
                                            const Point<Interval>& load, const Box& isolated);

}  // namespace plumbline::proofs
