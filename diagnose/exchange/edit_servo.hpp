#pragma once
/// \file
/// Correction of a position servo in a user's MJCF: its stiffness and its rest.

#include "diagnose/exchange/mjcf_servos.hpp"

namespace plumbline::exchange {

/// \param factor  of its stiffness
/// \param moves   how far, in rad, the angle at which it is at ease moves beside its command
/// \param file    named in errors
/// \throws Error where the attributes of the element exclude the correction
void edit_servo(const MjcfServo& servo, double factor, double moves, const std::string& file);

}  // namespace plumbline::exchange
