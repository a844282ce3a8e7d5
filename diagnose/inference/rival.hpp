#pragma once
/// \file
/// When one explanation is a rival of another at all.

#include <cstddef>

#include "diagnose/model/effect.hpp"

namespace plumbline::diagnose {

/// Whether an effect is the other one, or that is a special case of it.
bool covers(const EffectAt& whole, const EffectAt& part);

/// With so many parameters more an explanation comes near another by likelihood alone; with more of them any
/// comes as near as one likes.
inline constexpr std::size_t spare_parameters = 1;

}  // namespace plumbline::diagnose
