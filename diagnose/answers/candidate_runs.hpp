#pragma once
/// \file
/// Runs that a lab could make on its bench: presses of the end point and dead loads, from the rest shapes
/// that the bench has.

#include <string>
#include <vector>

#include "diagnose/model/study.hpp"

namespace plumbline::diagnose {

/// The rig as it was in the runs so far: how far it went.
struct Extent {
  double travel = 0;      ///< of a held end point, m; a twentieth of the chain where none was commanded
  double force = 0;       ///< on the end point, N
  double deflection = 0;  ///< of a joint, rad
  double pause = 2;       ///< between readings, s

  /// Whether the first run of a prediction asks no more than twice the force, and half as much deflection
  /// again, as the runs so far; anything where they asked nothing.
  [[nodiscard]] bool allows(const Trace& trace, const std::vector<double>& rest) const;
};

Extent extent(const Study& study);

struct CandidateRun {
  std::string description;
  Run run;  ///< what to command; the measured channels are empty
};

/// The end point pressed along x, along y and between, as far as before and half as far again, with and
/// without unloading.
/// \param shape  the rest shape in words
std::vector<CandidateRun> presses(const Experiment& experiment, const std::vector<double>& rest,
                                  const std::string& shape, const Extent& so_far);

/// The end point loaded along the same directions with weights on a string, and unloaded: as large as the
/// runs so far, or as deflects the nominal chain as much as they did, a third of a radian where they asked
/// nothing.
std::vector<CandidateRun> loads(const Experiment& experiment, const std::vector<double>& rest,
                                const std::string& shape, const Extent& so_far);

/// The rest shape turned over, as the same bench can have it.
std::vector<double> mirrored(std::vector<double> rest);

}  // namespace plumbline::diagnose
