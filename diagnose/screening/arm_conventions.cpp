#include "diagnose/screening/arm_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

/// A slip that readings may have.
struct Slip {
  std::string looks_like, remedy;
  std::function<void(Reading&)> mend;
};

void each_place(Reading& reading, const std::function<void(double*)>& change) {
  const std::size_t joints = reading.rest.size();
  for (std::size_t p = 0;; ++p) {
    const auto first = static_cast<std::size_t>(Channel(Channel::Name::place, 3 * p, joints).column);
    if (first >= reading.value.size()) return;
    change(reading.value.data() + first);
  }
}

void add_units(std::vector<Slip>& slips) {
  for (const auto& [unit, factor] : {std::pair("mm", 1e-3), {"cm", 1e-2}, {"in", 0.0254}})
    slips.push_back({fmt::format("places look like {}", unit), fmt::format("units.place = \"{}\"", unit),
                     [factor = factor](Reading& reading) {
                       each_place(reading, [&](double* at) {
                         for (int i = 0; i < 3; ++i) at[i] *= factor;
                       });
                     }});
  slips.push_back({"commands look like degrees", "units.angle = \"deg\"", [](Reading& reading) {
                     for (double& q : reading.rest) q *= std::numbers::pi / 180;
                   }});
}

void add_axes(std::vector<Slip>& slips) {
  for (int axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis], next = "xyz"[(axis + 1) % 3];
    slips.push_back({fmt::format("{} of the tracker looks reversed: its frame is left-handed", name),
                     fmt::format("the other sign of the columns of {}", name), [axis](Reading& reading) {
                       each_place(reading, [&](double* at) { at[axis] = -at[axis]; });
                     }});
    slips.push_back({fmt::format("{} and {} of the tracker look exchanged", name, next),
                     "their columns the other way round", [axis](Reading& reading) {
                       each_place(reading, [&](double* at) { std::swap(at[axis], at[(axis + 1) % 3]); });
                     }});
    for (int turned = 0; turned < 2; ++turned)
      slips.push_back({fmt::format("the tracker's frame looks turned by a quarter about {}", name),
                       "places in the frame of the base", [axis, turned](Reading& reading) {
                         each_place(reading, [&](double* at) {
                           double &a = at[(axis + 1) % 3], &b = at[(axis + 2) % 3];
                           std::swap(a, b);
                           (turned ? a : b) *= -1;
                         });
                       }});
  }
}

void add_joints(const NominalArm& arm, std::vector<Slip>& slips) {
  for (std::size_t j = 0; j < arm.joint.size(); ++j)
    slips.push_back({fmt::format("{} looks as if it turned the other way", arm.joint[j]),
                     fmt::format("the other sign of its commands, or of its axis in the model"),
                     [j](Reading& reading) { reading.rest[j] *= -1; }});
  slips.push_back({"the joints look numbered from the tip", "their columns in the order from the base",
                   [](Reading& reading) { std::reverse(reading.rest.begin(), reading.rest.end()); }});
}

/// Root mean square distance of the places from the nominal ones, over the reach.
double misfit(const Experiment& experiment, const Rig& rig, double reach) {
  const Prediction predicted = simulate(experiment, rig, {});
  if (!predicted.reached) return std::numeric_limits<double>::infinity();
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i)
      for (std::size_t c = 0; c < 3 * experiment.arm_bench.points.size(); ++c) {
        const Channel channel(Channel::Name::place, c, experiment.link_length.size());
        const double off = channel.of(experiment.runs[r].readings[i]) -
                           predicted.runs[r](static_cast<Eigen::Index>(i), channel.column);
        if (std::isfinite(off)) sum += off * off, ++count;
      }
  return count == 0 ? 0 : std::sqrt(3 * sum / static_cast<double>(count)) / reach;
}

/// A share of the readings: a slip is in all of them.
Experiment some_of(Experiment experiment) {
  constexpr std::size_t most = 40;  // of a run
  for (Run& run : experiment.runs) {
    const std::size_t stride = 1 + run.readings.size() / most;
    std::vector<Reading> few;
    for (std::size_t i = 0; i < run.readings.size(); i += stride) few.push_back(std::move(run.readings[i]));
    run.readings = std::move(few);
  }
  return experiment;
}

}  // namespace

std::optional<SuspectedSlip> suspected_slip(const Study& study) {
  if (study.experiment().arm_bench.frames == ArmBench::Frames::unknown) return {};
  constexpr double large = 0.1, mended = 0.1;  // of the reach; of the misfit as read
  const Experiment few = some_of(study.experiment());
  const double as_read = misfit(few, study.nominal_rig(), study.scales().length);
  if (!(as_read > large)) return {};
  std::vector<Slip> slips;
  add_units(slips), add_axes(slips), add_joints(*few.arm, slips);
  std::optional<SuspectedSlip> best;
  for (const Slip& slip : slips) {
    Experiment other = few;
    for (Run& run : other.runs) {
      for (Reading& reading : run.readings) slip.mend(reading);
      if (!run.readings.empty()) run.rest = run.readings.front().rest;
    }
    const double left = misfit(other, study.nominal_rig(), study.scales().length);
    if (left < mended * as_read && (!best || left < best->left))
      best = {slip.looks_like, slip.remedy, as_read, left};
  }
  return best;
}

}  // namespace plumbline::diagnose
