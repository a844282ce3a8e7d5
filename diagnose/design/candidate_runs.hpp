#pragma once
/// \file
/// Feasible runs of a bench: presses of the end point and dead loads from its rest shapes, poses and sweeps.

#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The operating envelope: how far the runs so far went.
struct OperatingEnvelope {
  double travel = 0;      ///< of a held end point, m; a twentieth of the chain where none was commanded
  double force = 0;       ///< on the end point, N
  double deflection = 0;  ///< of a joint, rad
  double sampling_interval = 2;         ///< of the slowest run, s
  std::vector<double> covariates = {};  ///< their means

  /// Whether the runs so far set any limit.
  [[nodiscard]] bool is_limit() const;
  /// Whether the first run of a prediction stays within twice the force and one and a half times the
  /// deflection of the runs so far; always, where these set no limit.
  [[nodiscard]] bool allows(const Trace& trace, const Run& run) const;
};

OperatingEnvelope operating_envelope(const Study& study);

/// Whether the nominal chain can follow a run within the operating envelope.
bool follows(const Experiment& experiment, const Run& run, const OperatingEnvelope& so_far);

struct CandidateRun {
  std::string description;
  Run run;  ///< the command; the measured channels are empty
};

/// A rest shape of the bench, with its control.
struct Shape {
  Control control;
  std::vector<double> rest;
  std::string words;
  Device device = Device::chain;

  [[nodiscard]] const EndKind& end() const { return end_kind(device); }
};

/// The distinct rest shapes of the runs whose joints are not commanded, by their ids, followed by their
/// mirror images.
/// \param most  largest number of shapes
std::vector<Shape> shapes(const Experiment& experiment, std::size_t most);

/// Runs from a shape along x, along y and between, with and without unloading, that the nominal chain can
/// follow. A held end point is pressed to the limits of the operating envelope and to two thirds of that: up
/// to 9/4 of the largest travel so far, or 3/2 where there are no limits. A free end point carries dead
/// loads: the largest force so far, or as much as deflects the nominal chain as far as before (a third of a
/// radian without limits); none where nothing but loads along the chain acted so far.
std::vector<CandidateRun> runs_from(const Experiment& experiment, const Shape& shape,
                                    const OperatingEnvelope& so_far);

/// The largest load along a direction that deflects the nominal chain from a shape no more than before, or by
/// a third of a radian where nothing did; nothing where none does.
std::optional<Vector2> bearable_load(const Experiment& experiment, const Shape& shape, const Vector2& along,
                                     const OperatingEnvelope& so_far);

/// All candidates: runs from the shapes, and those of commanded joints and of loads along the chain; of an
/// arm in space single poses.
/// \param most_shapes  largest number of shapes
std::vector<CandidateRun> candidate_runs(const Experiment& experiment, std::size_t most_shapes,
                                         const OperatingEnvelope& so_far);

}  // namespace plumbline::diagnose
