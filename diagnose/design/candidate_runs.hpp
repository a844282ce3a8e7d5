#pragma once
/// \file
/// Runs that a lab could make on its bench: presses of the end point and dead loads, from the rest shapes
/// that the bench has.

#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The rig as it was in the runs so far: how far it went.
struct OperatingEnvelope {
  double travel = 0;      ///< of a held end point, m; a twentieth of the chain where none was commanded
  double force = 0;       ///< on the end point, N
  double deflection = 0;  ///< of a joint, rad
  double sampling_interval = 2;  ///< between readings, s: as slow as the slowest

  /// Whether they asked anything.
  [[nodiscard]] bool is_limit() const;
  /// Whether the first run of a prediction asks no more than twice the force, and half as much deflection
  /// again, as the runs so far; anything where they asked nothing.
  [[nodiscard]] bool allows(const Trace& trace, const std::vector<double>& rest) const;
};

OperatingEnvelope operating_envelope(const Study& study);

struct CandidateRun {
  std::string description;
  Run run;  ///< what to command; the measured channels are empty
};

/// A rest shape that a bench has, and how it is moved from there.
struct Shape {
  Control control;
  std::vector<double> rest;
  std::string words;
};

/// The rest shapes of the runs, by the names of these, then the same turned over; of shapes that are alike
/// the first. \param most  so many of them, at most
std::vector<Shape> shapes(const Experiment& experiment, std::size_t most);

/// Runs from a shape along x, along y and between, with and without unloading, that the nominal chain
/// follows. A held end point is pressed as far as the limits of the runs so far let it, and by two thirds of
/// that: up to nine quarters as far as before, where they set none half as far again. Another is loaded with
/// weights on a string: as much as in the runs so far, or as deflects the nominal chain as much as they did,
/// a third of a radian where they asked nothing.
std::vector<CandidateRun> runs_from(const Experiment& experiment, const Shape& shape,
                                    const OperatingEnvelope& so_far);

}  // namespace plumbline::diagnose
