#pragma once
/// \file
/// When one explanation is a rival of another at all.

#include <cstddef>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Whether an effect is the other one, or that is a special case of it.
bool covers(const EffectAt& whole, const EffectAt& part);

/// Whether a set of effects is another one and more: as many at least, for one may be a special case of each
/// of several.
bool contains(const Candidate& whole, const Candidate& part);

/// Whether the one explanation has one value, for all joints or at a single one, where the other has one at
/// each, and is else the same: tolerances tell them apart, no matter how well both fit.
bool has_at_each(const Candidate& plain, const Candidate& other);

/// Whether the other explanation is what machining leaves, as the first one is, and singles out a change that
/// is made by its values as well.
bool singles_out(const Candidate& machining, const Candidate& other);

/// How many of the effects have a value a joint, a link or a run, with which they follow much that they are
/// not. Machining does not count: together its values are held by narrow tolerances.
std::size_t many_valued(const Study& study, const Candidate& candidate);

/// With so many parameters more an explanation comes near another by likelihood alone; with more of them any
/// comes as near as one likes.
inline constexpr std::size_t spare_parameters = 1;

}  // namespace plumbline::diagnose
