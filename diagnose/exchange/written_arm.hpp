#pragma once
/// \file
/// The nominal model of an arm in space with what a diagnosis found, in a format.

#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The file that the arm was read from, edited in place; or, in our own format, the arm joint by joint. What
/// is no part of an arm's model, such as an error of an instrument, is said not to be carried.
/// \pre the model's experiment has an arm
/// \throws Error, one line, for a format other than that of the arm's file, where there is none of it
Written written_arm(const Model& model, Format format);

}  // namespace plumbline::exchange
