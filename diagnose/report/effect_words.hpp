#pragma once
/// \file
/// The catalogue in words: what an effect is, and the units of its parameters.

#include <string>
#include <string_view>

#include "diagnose/model/effect.hpp"

namespace plumbline::diagnose {

/// What the effect is, in a few words that can stand after "caused by": "dry friction in the joints", "play
/// in joint 3".
std::string in_words(const EffectAt& at);

/// The unit of a parameter, "ratio" for one.
std::string_view unit(EffectId effect, std::string_view parameter);

}  // namespace plumbline::diagnose
