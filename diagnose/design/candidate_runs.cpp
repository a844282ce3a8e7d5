#include "diagnose/design/candidate_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/design/candidate_poses.hpp"
#include "diagnose/design/commanded_runs.hpp"
#include "diagnose/design/load_sweeps.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

constexpr int press_steps = 20;  // readings of a press

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

struct Direction {
  const char* name;
  Vector2 along;
};

/// Where one channel is imposed it goes one way or the other.
const std::vector<Direction>& directions(const EndKind& end) {
  static const std::vector<Direction> line{{"the negative way", {-1, 0}}, {"the positive way", {1, 0}}};
  if (end.place.size() == 1) return line;
  static const std::vector<Direction> all{{"along -x", {-1, 0}},
                                          {"along +x", {1, 0}},
                                          {"along +y", {0, 1}},
                                          {"along -y", {0, -1}},
                                          {"between -x and +y", {-0.8, 0.6}},
                                          {"between -x and -y", {-0.8, -0.6}},
                                          {"between +x and +y", {0.8, 0.6}},
                                          {"between +x and -y", {0.8, -0.6}}};
  return all;
}

/// Of any joint.
/// \param angle  of a reading and joint, by their numbers; NaN where there is none
template <class Angle>
double largest_deflection(const Run& run, Angle angle) {
  double largest = 0;
  for (std::size_t j = 0; j < run.rest.size(); ++j)
    largest =
        std::max(largest, run.largest_deflection(j, [&](std::size_t reading) { return angle(reading, j); }));
  return largest;
}

double largest_deflection(const Trace& trace, const Run& run) {
  return largest_deflection(run, [&](std::size_t reading, std::size_t joint) {
    return trace(static_cast<Eigen::Index>(reading), column_q + static_cast<Eigen::Index>(joint));
  });
}

/// How far from their commands joints were read; 0 where they are not commanded: their chain may have play.
double reached(const Run& run) {
  if (!run.commands_joints()) return 0;
  return largest_deflection(run, [&](std::size_t reading, std::size_t joint) {
    const Reading& one = run.readings[reading];
    return one[run.end().joint_angles ? Channel(Channel::Name::q, joint).column : column_x];
  });
}

double largest_force(const Trace& trace) {
  return std::sqrt((trace.col(column_Fx).square() + trace.col(column_Fy).square()).maxCoeff());
}

/// A run whose command moves from `start` by `by`, and back if asked.
Run gone(const Shape& from, const Vector2& start, const Vector2& by, bool back,
         const OperatingEnvelope& so_far) {
  const double pause = so_far.sampling_interval;
  Run run{"proposed", from.control, from.rest, {}};
  run.device = from.device;
  const int last = back ? 2 * press_steps : press_steps;
  for (int i = 0; i <= last; ++i) {
    const double share = static_cast<double>(std::min(i, 2 * press_steps - i)) / press_steps;
    const Vector2 to = start + share * by;
    if (from.control == Control::end_point) {
      run.readings.push_back({i * pause, {to.x(), to.y()}});
    } else {
      run.readings.push_back({i * pause, {not_measured, not_measured, to.x(), to.y()}});
    }
    run.readings.back().covariates = so_far.covariates;
  }
  return run;
}

std::vector<double> mirrored(std::vector<double> rest) {
  for (double& q : rest) q = -q;
  return rest;
}

/// The two longest distances along a direction, in a ratio of 3/2, that the nominal chain can follow.
std::vector<double> ways(const Experiment& experiment, const Shape& shape, const Vector2& start,
                         const Vector2& along, const OperatingEnvelope& so_far) {
  // Powers of 3/2; without limits one power at most.
  const int longest = so_far.is_limit() ? 2 : 1;
  constexpr int shortest = -4;
  std::vector<double> all;
  for (int power = longest; power >= shortest && all.size() < 2; --power) {
    const double by = std::pow(1.5, power) * so_far.travel;
    const Run there_and_back = gone(shape, start, by * along, true, so_far);
    if (follows(experiment, there_and_back, so_far)) all.push_back(by);
  }
  std::reverse(all.begin(), all.end());
  return all;
}

std::vector<CandidateRun> presses(const Experiment& experiment, const Shape& shape,
                                  const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  const Vector2 start = unloaded_end(experiment, shape.rest);
  const EndKind& end = shape.end();
  const bool turns = end.place.front().sensor() == Sensor::angle;
  for (const Direction& one : directions(end))
    for (const double by : ways(experiment, shape, start, one.along, so_far))
      for (const bool back : {false, true})
        all.push_back({fmt::format("{} {} by {:.3g} {} from {}{}", turns ? "turn" : "press", one.name, by,
                                   end.place.front().unit(), shape.words, back ? " and unload" : ""),
                       gone(shape, start, by * one.along, back, so_far)});
  return all;
}

}  // namespace

bool follows(const Experiment& experiment, const Run& run, const OperatingEnvelope& so_far) {
  Experiment bench = experiment;
  bench.runs = {run};
  const Prediction nominal = simulate(bench, nominal_rig(bench), {});
  return nominal.reached && !nominal.snapped && so_far.allows(nominal.runs[0], run);
}

std::optional<Vector2> bearable_load(const Experiment& experiment, const Shape& shape, const Vector2& along,
                                     const OperatingEnvelope& so_far) {
  constexpr double usual_deflection = 0.33;  // rad
  const double wanted = so_far.deflection > 0 ? so_far.deflection : usual_deflection;
  const double shortest = *std::min_element(experiment.link_length.begin(), experiment.link_length.end());
  const double stiffest =
      *std::max_element(experiment.joint_stiffness.begin(), experiment.joint_stiffness.end());
  double force = so_far.force > 0 ? so_far.force : 2 * wanted * stiffest / shortest;
  for (int halved = 0; halved < 12; ++halved, force /= 2) {
    Experiment bench = experiment;
    bench.runs = {gone(shape, {0, 0}, force * along, true, so_far)};
    const Prediction nominal = simulate(bench, nominal_rig(bench), {});
    if (nominal.reached && !nominal.snapped && largest_deflection(nominal.runs[0], bench.runs[0]) <= wanted)
      return force * along;
  }
  return std::nullopt;
}

namespace {

std::vector<CandidateRun> loads(const Experiment& experiment, const Shape& shape,
                                const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  const EndKind& end = shape.end();
  for (const Direction& one : directions(end)) {
    const std::optional<Vector2> load = bearable_load(experiment, shape, one.along, so_far);
    if (!load) continue;
    for (const bool back : {false, true})
      all.push_back({fmt::format("load with {:.3g} {} {} from {}{}", load->norm(), end.load.front().unit(),
                                 one.name, shape.words, back ? " and unload" : ""),
                     gone(shape, {0, 0}, *load, back, so_far)});
  }
  return all;
}

/// Their means over all readings.
std::vector<double> mean_covariates(const Experiment& experiment) {
  std::vector<double> sums(experiment.covariates.size());
  double count = 0;
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) {
      for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += reading.covariates[c];
      ++count;
    }
  for (double& sum : sums) sum /= std::max(count, 1.0);
  return sums;
}

}  // namespace

bool OperatingEnvelope::is_limit() const {
  return force > 0 || deflection > 0;
}

bool OperatingEnvelope::allows(const Trace& trace, const Run& run) const {
  return (force == 0 || largest_force(trace) <= 2 * force) &&
         (deflection == 0 || largest_deflection(trace, run) <= 1.5 * deflection);
}

OperatingEnvelope operating_envelope(const Study& study) {
  OperatingEnvelope so_far;
  const Experiment& experiment = study.experiment();
  const Prediction& nominal = study.nominal();
  double pause = 0;
  for (std::size_t r = 0; r < nominal.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Trace& trace = nominal.runs[r];
    if (run.readings.empty()) continue;
    const Vector2 start = unloaded_end(experiment, run.rest);
    so_far.force = std::max(so_far.force, largest_force(trace));
    so_far.deflection = std::max({so_far.deflection, largest_deflection(trace, run), reached(run)});
    for (Eigen::Index i = 0; i < trace.rows(); ++i) {
      const double way = (Vector2(trace(i, column_x), trace(i, column_y)) - start).norm();
      if (run.holds_end_point()) so_far.travel = std::max(so_far.travel, way);
    }
    pause = std::max(pause, run.sampling_interval());
  }
  constexpr double rounding = 1e-9;  // rad: the deflection of joints that nothing loads
  if (so_far.deflection < rounding) so_far.deflection = 0;
  if (pause > 0) so_far.sampling_interval = pause;
  so_far.covariates = mean_covariates(experiment);
  if (so_far.travel == 0) {
    for (const double length : experiment.link_length) so_far.travel += 0.05 * length;
  }
  return so_far;
}

std::vector<Shape> shapes(const Experiment& experiment, std::size_t most) {
  std::vector<Shape> all;
  const auto add = [&](Shape one) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const Shape& other) {
      return other.control == one.control && other.rest == one.rest;
    });
    if (!known && all.size() < most) all.push_back(std::move(one));
  };
  std::vector<const Run*> runs;
  for (const Run& run : experiment.runs)
    if (!run.commands_joints()) runs.push_back(&run);
  std::sort(runs.begin(), runs.end(), [](const Run* a, const Run* b) { return a->id < b->id; });
  const bool bends = experiment.has_links();
  for (const Run* run : runs)
    add({run->control, run->rest, (bends ? "the rest shape of " : "the rest of ") + run->id, run->device});
  for (const Run* run : runs)
    if (bends) add({run->control, mirrored(run->rest), "the mirrored rest shape of " + run->id});
  return all;
}

std::vector<CandidateRun> runs_from(const Experiment& experiment, const Shape& shape,
                                    const OperatingEnvelope& so_far) {
  if (shape.control == Control::end_point) return presses(experiment, shape, so_far);
  const bool by_loads_alone = !experiment.loads.empty() && so_far.force == 0;
  return by_loads_alone ? std::vector<CandidateRun>() : loads(experiment, shape, so_far);
}

std::vector<CandidateRun> candidate_runs(const Experiment& experiment, std::size_t most_shapes,
                                         const OperatingEnvelope& so_far) {
  if (experiment.visits_poses()) return candidate_poses(experiment);
  std::vector<CandidateRun> all = commanded_runs(experiment, so_far);
  const std::vector<Shape> from = shapes(experiment, most_shapes);
  for (CandidateRun& one : load_sweeps(experiment, from, so_far)) all.push_back(std::move(one));
  for (const Shape& shape : from)
    for (CandidateRun& one : runs_from(experiment, shape, so_far)) all.push_back(std::move(one));
  return all;
}

}  // namespace plumbline::diagnose
