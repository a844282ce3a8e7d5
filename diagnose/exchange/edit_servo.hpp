#pragma once
/// \file
/// A servo of somebody's MJCF, made softer or stiffer, or at ease elsewhere.

#include "diagnose/exchange/mjcf_servos.hpp"

namespace plumbline::exchange {

/// \param factor  of its stiffness
/// \param moves   how far, in rad, the angle at which it is at ease moves beside its command
/// \param file    named in errors
/// \throws Error where the element says that in a way which does not go together with its own words
void edit_servo(const MjcfServo& servo, double factor, double moves, const std::string& file);

}  // namespace plumbline::exchange
