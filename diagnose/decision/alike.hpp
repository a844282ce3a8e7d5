#pragma once
/// \file
/// The class of what cannot be told apart from the explanation that stands out.

#include "diagnose/decision/cause.hpp"

namespace plumbline::diagnose {

/// Makes the explanation at a place of the ranking the one that stands out, or the head of a class with those
/// that come near it; the cause is another with the given chance.
void settle_on(Cause& cause, std::size_t chosen, double unknown);

/// Lists beside the best explanation the plainer ones of which it is a refinement, or that it has one effect
/// more than, where these close the gap nearly as well: what it adds answers then to little, which may be
/// anything.
void list_plainer(const Study& study, const NoiseModel& noise, Cause& cause);

/// Takes from the class what comes near the best in likelihood alone and is another of the class with
/// something added: to that one anything could be added. What the best hides is the best with something
/// added, and stays.
void drop_refinements(Cause& cause);

}  // namespace plumbline::diagnose
