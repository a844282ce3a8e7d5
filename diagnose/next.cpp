#include "diagnose/next.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "diagnose/physical.hpp"

namespace plumbline {
namespace {

struct Design {
  std::string description;
  Experiment experiment;  ///< the old runs and the new one; of the new one only what is commanded counts
};

Vector2 commanded(const Run& run, const Reading& reading) {
  return run.control == Control::displacement ? Vector2(reading.x, reading.y)
                                              : Vector2(reading.Fx, reading.Fy);
}

void command(Run& run, Reading& reading, const Vector2& target) {
  (run.control == Control::displacement ? reading.x : reading.Fx) = target.x();
  (run.control == Control::displacement ? reading.y : reading.Fy) = target.y();
}

/// The run with its path turned and stretched about its start.
Run pushed(Run run, double along, double aside) {
  const Vector2 start = commanded(run, run.readings.front());
  for (Reading& reading : run.readings) {
    const Vector2 step = commanded(run, reading) - start;
    command(run, reading, start + along * step + aside * Vector2(-step.y(), step.x()));
  }
  return run;
}

Run and_back(Run run) {
  const std::size_t there = run.readings.size();
  const double end = run.readings.back().t;
  for (std::size_t i = there - 1; i-- > 0;) {
    run.readings.push_back(run.readings[i]);
    run.readings.back().t = 2 * end - run.readings[i].t;
  }
  return run;
}

Run mirrored(Run run) {
  for (double& angle : run.rest) angle = -angle;
  for (Reading& reading : run.readings) {
    const Vector2 target = commanded(run, reading);
    command(run, reading, Vector2(target.x(), -target.y()));
  }
  return run;
}

Run with_angles(Run run) {
  for (Reading& reading : run.readings) reading.q.assign(run.rest.size(), 0.0);
  return run;
}

const Run& longest(const Experiment& experiment) {
  return *std::max_element(experiment.runs.begin(), experiment.runs.end(),
                           [](const Run& a, const Run& b) { return a.readings.size() < b.readings.size(); });
}

Design design(const Experiment& experiment, const std::string& description, Run run) {
  Design result{description, experiment};
  run.id = "next";
  result.experiment.runs.push_back(std::move(run));
  return result;
}

std::vector<Design> designs(const Experiment& experiment) {
  const Run& base = longest(experiment);
  std::vector<Design> all;
  const auto add = [&](const std::string& description, const Run& run) {
    all.push_back(design(experiment, description + " run \"" + base.id + "\"", run));
  };
  add("repeat", base);
  add("push back after", and_back(base));
  add("push sideways instead, the rest as in", pushed(base, 0, 0.5));
  add("push aslant, the rest as in", pushed(base, 0.8, 0.4));
  add("push half as far again as in", pushed(base, 1.5, 0));
  add("start from the mirrored shape of", mirrored(base));
  if (experiment.noise.q == 0) {
    add("measure the joint angles (to 1 mrad) in a repetition of", with_angles(base));
    all.back().experiment.noise.q = 1e-3;
  }
  return all;
}

/// The experiment as it would be read without noise if this were the cause; nothing where the rig cannot
/// follow.
std::optional<Experiment> imagined(Experiment experiment, const Fit& cause) {
  const Prediction predicted = predict(experiment, cause.candidate, cause.parameters);
  if (!predicted.reached) return std::nullopt;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const auto row = predicted.runs[r].row(static_cast<Eigen::Index>(i));
      Reading& reading = run.readings[i];
      const bool displacement = run.control == Control::displacement;
      (displacement ? reading.Fx : reading.x) = row(displacement ? column_Fx : column_x);
      (displacement ? reading.Fy : reading.y) = row(displacement ? column_Fy : column_y);
      for (std::size_t j = 0; j < reading.q.size(); ++j)
        reading.q[j] = row(column_q + static_cast<Eigen::Index>(j));
    }
  }
  return experiment;
}

/// Half the chi-square that the rival cannot follow.
std::optional<double> separation(const Design& plan, const Fit& truth, const Fit& rival) {
  const std::optional<Experiment> data = imagined(plan.experiment, truth);
  if (!data) return std::nullopt;
  const Fit best = fit_from(*data, Measurements(*data), rival.candidate, {}, rival.parameters);
  if (!best.converged) return std::nullopt;
  return best.cost / 2;
}

bool within_reach(const Experiment& experiment) {
  const Reach limits = reach(experiment.link_length);
  const Run& run = experiment.runs.back();
  return run.control == Control::force ||
         std::all_of(run.readings.begin(), run.readings.end(), [&](const Reading& r) {
           const double distance = std::hypot(r.x, r.y);
           return distance < limits.largest && distance > limits.smallest;
         });
}

}  // namespace

std::vector<Proposal> what_next(const Experiment& experiment, const Cause& cause) {
  std::vector<const Fit*> fits{&cause.ranking[cause.best].hypothesis.fit};
  for (const std::size_t place : cause.equivalent) fits.push_back(&cause.ranking[place].hypothesis.fit);
  std::vector<Proposal> proposals;
  for (const Design& plan : designs(experiment)) {
    if (!within_reach(plan.experiment)) continue;
    std::optional<double> least;
    for (std::size_t rival = 1; rival < fits.size(); ++rival) {
      for (const auto& [truth, other] : {std::pair(fits[0], fits[rival]), std::pair(fits[rival], fits[0])}) {
        const std::optional<double> one = separation(plan, *truth, *other);
        if (one) least = least ? std::min(*least, *one) : *one;
      }
    }
    if (least) proposals.push_back({plan.description, *least});
  }
  std::sort(proposals.begin(), proposals.end(),
            [](const auto& a, const auto& b) { return a.log_odds > b.log_odds; });
  if (proposals.size() > 5) proposals.resize(5);
  return proposals;
}

}  // namespace plumbline
