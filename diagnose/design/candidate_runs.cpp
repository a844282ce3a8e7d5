#include "diagnose/design/candidate_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

constexpr int press_steps = 20;  // readings of a press

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

struct Direction {
  const char* name;
  Vector2 along;
};

const std::vector<Direction>& directions() {
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

double largest_deflection(const Trace& trace, const std::vector<double>& rest) {
  double largest = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto q = trace.col(column_q + static_cast<Eigen::Index>(i));
    largest = std::max(largest, (q - rest[i]).abs().maxCoeff());
  }
  return largest;
}

double largest_force(const Trace& trace) {
  return std::sqrt((trace.col(column_Fx).square() + trace.col(column_Fy).square()).maxCoeff());
}

/// A run whose command moves from `start` by `by`, and back if asked.
Run gone(Control control, const std::vector<double>& rest, const Vector2& start, const Vector2& by, bool back,
         const OperatingEnvelope& so_far) {
  const double pause = so_far.sampling_interval;
  Run run{"proposed", control, rest, {}};
  const int last = back ? 2 * press_steps : press_steps;
  for (int i = 0; i <= last; ++i) {
    const double share = static_cast<double>(std::min(i, 2 * press_steps - i)) / press_steps;
    const Vector2 to = start + share * by;
    if (control == Control::end_point) {
      run.readings.push_back({i * pause, to.x(), to.y(), not_measured, not_measured, {}});
    } else {
      run.readings.push_back({i * pause, not_measured, not_measured, to.x(), to.y(), {}});
    }
    run.readings.back().covariates = so_far.covariates;
  }
  return run;
}

std::vector<double> mirrored(std::vector<double> rest) {
  for (double& q : rest) q = -q;
  return rest;
}

/// Whether the nominal chain can follow a run within the operating envelope.
bool follows(const Experiment& experiment, const Run& run, const OperatingEnvelope& so_far) {
  Experiment bench = experiment;
  bench.runs = {run};
  const Prediction nominal = simulate(bench, nominal_rig(bench), {});
  return nominal.reached && !nominal.snapped && so_far.allows(nominal.runs[0], run.rest);
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
    const Run there_and_back = gone(Control::end_point, shape.rest, start, by * along, true, so_far);
    if (follows(experiment, there_and_back, so_far)) all.push_back(by);
  }
  std::reverse(all.begin(), all.end());
  return all;
}

std::vector<CandidateRun> presses(const Experiment& experiment, const Shape& shape,
                                  const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  const Vector2 start = unloaded_end(experiment, shape.rest);
  for (const Direction& one : directions())
    for (const double by : ways(experiment, shape, start, one.along, so_far))
      for (const bool back : {false, true})
        all.push_back({fmt::format("press {} by {:.3g} m from {}{}", one.name, by, shape.words,
                                   back ? " and unload" : ""),
                       gone(Control::end_point, shape.rest, start, by * one.along, back, so_far)});
  return all;
}

/// The largest load along a direction that deflects the nominal chain no more than is wanted.
std::optional<Vector2> bearable(const Experiment& experiment, const Shape& shape, const Vector2& along,
                                const OperatingEnvelope& so_far) {
  constexpr double usual_deflection = 0.33;  // rad
  const double wanted = so_far.deflection > 0 ? so_far.deflection : usual_deflection;
  const double shortest = *std::min_element(experiment.link_length.begin(), experiment.link_length.end());
  const double stiffest =
      *std::max_element(experiment.joint_stiffness.begin(), experiment.joint_stiffness.end());
  double force = so_far.force > 0 ? so_far.force : 2 * wanted * stiffest / shortest;
  for (int halved = 0; halved < 12; ++halved, force /= 2) {
    Experiment bench = experiment;
    bench.runs = {gone(Control::force, shape.rest, {0, 0}, force * along, true, so_far)};
    const Prediction nominal = simulate(bench, nominal_rig(bench), {});
    if (nominal.reached && !nominal.snapped && largest_deflection(nominal.runs[0], shape.rest) <= wanted)
      return force * along;
  }
  return std::nullopt;
}

std::vector<CandidateRun> loads(const Experiment& experiment, const Shape& shape,
                                const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  for (const Direction& one : directions()) {
    const std::optional<Vector2> load = bearable(experiment, shape, one.along, so_far);
    if (!load) continue;
    for (const bool back : {false, true})
      all.push_back({fmt::format("load with {:.3g} N {} from {}{}", load->norm(), one.name, shape.words,
                                 back ? " and unload" : ""),
                     gone(Control::force, shape.rest, {0, 0}, *load, back, so_far)});
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
  for (double& sum : sums) sum /= count;
  return sums;
}

}  // namespace

bool OperatingEnvelope::is_limit() const {
  return force > 0 || deflection > 0;
}

bool OperatingEnvelope::allows(const Trace& trace, const std::vector<double>& rest) const {
  return (force == 0 || largest_force(trace) <= 2 * force) &&
         (deflection == 0 || largest_deflection(trace, rest) <= 1.5 * deflection);
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
    for (Eigen::Index i = 0; i < trace.rows(); ++i) {
      const std::vector<double>& rest = run.rest_at(run.readings[static_cast<std::size_t>(i)]);
      so_far.deflection = std::max(so_far.deflection, largest_deflection(trace.middleRows(i, 1), rest));
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
  for (const Run& run : experiment.runs) runs.push_back(&run);
  std::sort(runs.begin(), runs.end(), [](const Run* a, const Run* b) { return a->id < b->id; });
  for (const Run* run : runs) add({run->control, run->rest, "the rest shape of " + run->id});
  for (const Run* run : runs)
    add({run->control, mirrored(run->rest), "the mirrored rest shape of " + run->id});
  return all;
}

std::vector<CandidateRun> runs_from(const Experiment& experiment, const Shape& shape,
                                    const OperatingEnvelope& so_far) {
  return shape.control == Control::end_point ? presses(experiment, shape, so_far)
                                             : loads(experiment, shape, so_far);
}

}  // namespace plumbline::diagnose
