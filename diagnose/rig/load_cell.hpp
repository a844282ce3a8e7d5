#pragma once
/// \file
/// Planar load cells: what they show under a force, and the force under which they show it.

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// \param angle  rad
Vector2 turned(const Vector2& v, double angle);

/// Without load, N. \param t  time, s
Vector2 zero_of_cell(const Rig& rig, double t);

/// The reading of a load cell without bias: (1 + g) m (1 + c m) for each component of m = (1 + C) F, with the
/// force F in its axes.
Vector2 shown_by_cell(const Rig& rig, const Vector2& force);

/// The force with this reading: the smaller of two, or the nearest where none has it.
Vector2 force_on_cell(const Rig& rig, const Vector2& shown);

/// Its response in time.
Response response_of_cell(const Rig& rig);

}  // namespace plumbline::diagnose
