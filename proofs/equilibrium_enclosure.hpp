#pragma once
/// \file
/// From a box of doubles that holds one root of the equilibrium equations to an enclosure of fifty digits and
/// a type.

#include "proofs/census.hpp"
#include "proofs/equilibrium_box.hpp"

namespace plumbline::proofs {

/// \param isolated  a box that holds exactly one root; the root near its middle is enclosed
CertifiedEquilibrium enclose(const Chain<Interval>& chain, Control control, const Point<Interval>& load,
                             const Box& isolated);

}  // namespace plumbline::proofs
