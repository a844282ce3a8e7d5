#pragma once
/// \file
/// What the environment prescribes.

namespace plumbline {

/// The end point is held, and the force answers; or the force acts, and the end point answers.
enum class Control { end_point, force };

}  // namespace plumbline
