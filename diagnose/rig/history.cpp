#include "diagnose/rig/history.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "diagnose/rig/planar_statics.hpp"
#include "diagnose/rig/spatial_statics.hpp"
#include "diagnose/rig/walk.hpp"

namespace plumbline::diagnose {
namespace {

/// Of the rig and of those beside it.
Layout layout_of(const Rig& rig, const std::vector<Rig>& variations) {
  Layout layout{rig.length.size(), rig.flexibility > 0, rig.coupling != 0, contact_count(rig)};
  for (const Rig& other : variations) {
    layout.coupled = layout.coupled || other.coupling != 0;
    layout.sliders = std::max(layout.sliders, contact_count(other));
  }
  return layout;
}

bool walk(const Experiment& experiment, const Run& run, const Rig& rig, const std::vector<Rig>& variations,
          Trace& trace, const std::vector<Trace*>& sensitivity, bool& snapped) {
  if (rig.arm) {
    SpatialStatics arm(experiment, run, rig, variations);
    return Walk(experiment, run, arm).walk(trace, sensitivity);
  }
  const Layout layout = layout_of(rig, variations);
  const auto with = [&]<int Bandwidth>() {
    PlanarStatics<Bandwidth> chain(experiment, run, layout, rig, variations);
    const bool reached = Walk(experiment, run, chain).walk(trace, sensitivity);
    snapped = snapped || (reached && chain.snapped());
    return reached;
  };
  switch (layout.bandwidth()) {
    case 1:
      return with.template operator()<1>();
    case 2:
      return with.template operator()<2>();
    default:
      return with.template operator()<4>();
  }
}

/// Those of a trace: as many as a bench has that reads all that can be read of its device.
Eigen::Index columns_of(const Experiment& experiment) {
  const ArmBench& bench = experiment.arm_bench;
  return Channel::of_sensor(Channel::Name::distance, bench.sensors.size(), 0, experiment.link_length.size(),
                            bench.points.size())
      .column;
}

}  // namespace

std::vector<double> reading_values(const Eigen::Ref<const Eigen::ArrayXd>& row, const Moment& moment,
                                   const Channel& channel) {
  const double run = static_cast<double>(moment.run + 1);
  std::vector<double> values{row(column_x), row(column_y), row(column_Fx),  row(column_Fy),
                             moment.t,      run,           moment.direction};
  if (channel.name == Channel::Name::q) {
    const double q = row(channel.column);
    values.insert(values.end(), {q, q - moment.rest});
  }
  values.insert(values.end(), moment.covariates.begin(), moment.covariates.end());
  return values;
}

Prediction simulate(const Experiment& experiment, const Rig& rig,
                    const std::vector<RigVariation>& variations) {
  const auto columns = columns_of(experiment);
  Prediction result;
  for (const Run& run : experiment.runs) {
    const auto rows = static_cast<Eigen::Index>(run.readings.size());
    result.runs.push_back(Trace::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN()));
  }
  result.sensitivity.assign(variations.size(), result.runs);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Rig here = in_run(rig, run.number);
    std::vector<Rig> differ;
    std::vector<Trace*> beside;
    std::vector<Sensors> read_by;  // of each variation
    for (std::size_t p = 0; p < variations.size(); ++p) {
      Trace& trace = result.sensitivity[p][r];
      Rig other = in_run(variations[p].rig, run.number);
      read_by.push_back(std::exchange(other.sensors, here.sensors));
      if (other == here) {
        trace.setZero();
      } else {
        differ.push_back(std::move(other));
        beside.push_back(&trace);
      }
    }
    Trace& trace = result.runs[r];
    if (!walk(experiment, run, here, differ, trace, beside, result.snapped)) {
      result.reached = false;
      return result;
    }
    const Trace stands = trace;
    trace = here.sensors.shown(run, stands);
    for (std::size_t p = 0; p < variations.size(); ++p) {
      Trace& difference = result.sensitivity[p][r];
      if (!here.sensors.are_exact() || !read_by[p].are_exact())
        difference = trace.isNaN().select(0.0, read_by[p].shown(run, stands + difference) - trace);
      difference /= variations[p].step;
    }
  }
  return result;
}

}  // namespace plumbline::diagnose
