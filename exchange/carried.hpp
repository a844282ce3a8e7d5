#pragma once
/// \file
/// What of a model goes into a file of some format.

#include "exchange/format.hpp"
#include "exchange/model.hpp"

namespace plumbline::exchange {

/// Of every effect of the model, whether the format carries it and as what, or why not; then of its law.
std::vector<Carried> what_is_carried(const Model& model, Format format);

/// The rig with those effects alone that are carried.
diagnose::Rig carried_rig(const Model& model, const std::vector<Carried>& effects);

}  // namespace plumbline::exchange
