#pragma once
/// \file
/// The stability regime of each reading of a run, by the tangent stiffness of the nominal model.

#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

enum class Regime { pre_critical, near_critical, post_critical, loading, unloading };

std::string regime_word(Regime regime);

/// One regime per reading. The stiffness along the path is the change of the nominal force along the motion
/// over the motion. Pre-buckling: at least half of its value at the start of the loading; near the loss of
/// stiffness: between half and a tenth of it; post-buckling: below, or after the force has passed its
/// maximum. Unloading: the commanded point moves back towards the unloaded shape.
/// A joint alone loses no stability: it is loading or unloading.
std::vector<Regime> regimes(const Run& run, const Trace& nominal);

}  // namespace plumbline::diagnose
