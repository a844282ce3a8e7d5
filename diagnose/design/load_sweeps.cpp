#include "diagnose/design/load_sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "diagnose/bench/command_range.hpp"

namespace plumbline::diagnose {
namespace {

CommandRange range_of(const Experiment& experiment, std::size_t covariate) {
  CommandRange range;
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) range.add(reading.covariates[covariate]);
  return range;
}

Run swept(const Shape& from, const LoadChannel& load, const CommandRange& range, bool back,
          const OperatingEnvelope& so_far) {
  constexpr int steps = 20;  // of one way
  constexpr double unread = std::numeric_limits<double>::quiet_NaN();
  Run run{"proposed", Control::force, from.rest, {}};
  run.by_weights = true;
  run.loads = {load};
  for (int i = 0; i <= (back ? 2 * steps : steps); ++i) {
    const double share = static_cast<double>(std::min(i, 2 * steps - i)) / steps;
    run.readings.push_back({i * so_far.sampling_interval, {unread, unread, 0, 0}});
    run.readings.back().covariates = so_far.covariates;
    run.readings.back().covariates[load.covariate] = range.at(share);
  }
  return run;
}

}  // namespace

std::vector<CandidateRun> load_sweeps(const Experiment& experiment, const std::vector<Shape>& shapes,
                                      const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  const std::vector<LoadChannel> loads =
      load_channels(experiment.loads, experiment.link_length, experiment.covariates);
  for (const Shape& shape : shapes)
    for (const LoadChannel& load : loads) {
      const CommandRange range = range_of(experiment, load.covariate);
      if (shape.control != Control::force || !(range.high > range.low)) continue;
      for (const bool back : {false, true}) {
        Run run = swept(shape, load, range, back, so_far);
        if (follows(experiment, run, so_far))
          all.push_back({fmt::format("{} from {:.3g} to {:.3g} {} from {}{}", load.name, range.low,
                                     range.high, load.unit, shape.words, back ? " and back" : ""),
                         std::move(run)});
      }
    }
  return all;
}

}  // namespace plumbline::diagnose
