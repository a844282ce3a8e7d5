#pragma once
/// \file
/// Rows of sensors and drives that respond late: by a time constant, or by a delay.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// A kind of sensor, or the drives.
struct Responder {
  std::string id;     ///< of its rows
  std::string words;  ///< a noun phrase that "with a delay" can follow
  std::function<std::vector<Response*>(const Addition& to)> responses;
};

/// Sensors of channels with these names.
std::function<std::vector<Response*>(const Addition& to)> sensors_of(std::vector<Channel::Name> names);

using Possible = std::function<bool(const Place& at)>;

/// The row of a first-order lag.
/// \param form  that distinguishes it from the other; empty for the first of both
Effect lagging(const Responder& one, Possible possible, std::string_view form = {});
/// The row of a delay.
Effect delayed(const Responder& one, Possible possible, std::string_view form = "by a delay");

}  // namespace plumbline::diagnose
