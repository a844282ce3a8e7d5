#include "diagnose/answers/next_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/inference/separation.hpp"

namespace plumbline::diagnose {
namespace {

constexpr int steps = 20;                   // readings of a press
constexpr double usual_angle_sigma = 1e-3;  // rad: a common encoder, where the lab has not declared one

/// The rig as it was in the runs so far: how far it went.
struct Extent {
  double travel = 0, force = 0, deflection = 0, pause = 1;
};

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

Extent extent(const Study& study) {
  Extent so_far;
  const Experiment& experiment = study.experiment();
  const Prediction& nominal = study.nominal();
  for (std::size_t r = 0; r < nominal.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const Trace& trace = nominal.runs[r];
    const Vector2 start = unloaded_end(experiment, run.rest);
    so_far.force = std::max(so_far.force, largest_force(trace));
    so_far.deflection = std::max(so_far.deflection, largest_deflection(trace, run.rest));
    for (Eigen::Index i = 0; i < trace.rows(); ++i) {
      const double way = (Vector2(trace(i, column_x), trace(i, column_y)) - start).norm();
      if (run.holds_end_point()) so_far.travel = std::max(so_far.travel, way);
    }
    if (run.readings.size() > 1) so_far.pause = run.readings[1].t - run.readings[0].t;
  }
  if (so_far.travel == 0) {
    for (const double length : experiment.link_length) so_far.travel += 0.05 * length;
  }
  return so_far;
}

struct Press {
  const char* name;
  Vector2 direction;
};

Run press(const Experiment& experiment, const std::vector<double>& rest, const Vector2& by, bool back,
          double pause) {
  Run run{"proposed", Control::end_point, rest, {}};
  const Vector2 start = unloaded_end(experiment, rest);
  const int last = back ? 2 * steps : steps;
  const double empty = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i <= last; ++i) {
    const double share = static_cast<double>(std::min(i, 2 * steps - i)) / steps;
    const Vector2 end = start + share * by;
    run.readings.push_back({i * pause, end.x(), end.y(), empty, empty, {}});
  }
  return run;
}

/// The bench with the proposed run alone on it.
Experiment bench_for(const Experiment& experiment, const Run& run, bool out_of_gravity) {
  Experiment bench = experiment;
  bench.runs = {run};
  bench.runs.front().number = bench.run_count;  // what differs from run to run says nothing of it
  if (out_of_gravity) {
    bench.gravity = {0, 0};
    bench.bench = {Bench::Plane::vertical, {0, 0}, true};
  }
  return bench;
}

/// What the rivals would measure in the run; nothing where one cannot follow or it asks too much of the rig.
std::optional<std::vector<Prediction>> forecast(const Study& bench, const std::vector<Fit>& rivals,
                                                const Extent& so_far) {
  std::vector<Prediction> all;
  for (const Fit& rival : rivals) {
    all.push_back(predict(bench, rival.candidate, rival.parameters, true));
    const Prediction& one = all.back();
    if (!one.reached || one.snapped || largest_force(one.runs[0]) > 2 * so_far.force ||
        largest_deflection(one.runs[0], bench.experiment().runs[0].rest) > 1.5 * so_far.deflection)
      return std::nullopt;
  }
  return all;
}

/// Rows of the new run: forces, and angles where they are measured.
Imitation new_rows(const Prediction& truth, const Prediction& imitator, const Noise& sigma,
                   const NoiseModel& noise, bool angles) {
  const Trace& a = truth.runs[0];
  const Trace& b = imitator.runs[0];
  const Eigen::Index last = angles ? a.cols() : static_cast<Eigen::Index>(column_q);
  const Eigen::Index columns = last - column_Fx, rows = a.rows();
  Imitation result;
  result.difference.resize(rows * columns);
  result.slope.resize(rows * columns, static_cast<Eigen::Index>(imitator.sensitivity.size()));
  for (Eigen::Index c = column_Fx; c < last; ++c) {
    const double declared = c == column_Fx ? sigma.Fx : (c == column_Fy ? sigma.Fy : sigma.q);
    const double real = declared * noise.scale[static_cast<std::size_t>(std::min<Eigen::Index>(c, column_q))];
    const Eigen::Index at = (c - column_Fx) * rows;
    result.difference.segment(at, rows) = ((a.col(c) - b.col(c)) / real).matrix();
    for (std::size_t p = 0; p < imitator.sensitivity.size(); ++p)
      result.slope.col(static_cast<Eigen::Index>(p)).segment(at, rows) =
          -(imitator.sensitivity[p][0].col(c) / real).matrix();
  }
  return result;
}

/// Expected lead of the right rival over its best imitator, averaged over which is right.
template <class Rows>
double expected_log_odds(std::size_t rivals, Rows rows) {
  double sum = 0;
  for (std::size_t a = 0; a < rivals; ++a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < rivals; ++b)
      if (a != b) nearest = std::min(nearest, separation(rows(a, b)));
    sum += nearest / 2;
  }
  return sum / static_cast<double>(rivals);
}

Noise with_angles(Noise sigma) {
  if (sigma.q <= 0) sigma.q = usual_angle_sigma;
  return sigma;
}

/// Weighs one run after the other.
class Planner {
 public:
  Planner(const Study& study, const std::vector<Fit>& rivals, const NoiseModel& noise)
      : experiment_(study.experiment()), noise_(noise), so_far_(extent(study)) {
    FitSettings settings;
    settings.noise = noise;
    for (const Fit& rival : rivals)
      rivals_.push_back(fit_from(study, rival.candidate, settings, rival.parameters));
    for (const Fit& truth : rivals_)
      for (const Fit& imitator : rivals_) known_.push_back(condensed(imitation(truth, imitator)));
    before_ = expected_log_odds(rivals_.size(), [&](std::size_t a, std::size_t b) { return known(a, b); });
  }

  /// All presses from one rest shape.
  void add_presses(const std::vector<double>& rest, const std::string& shape) {
    static const std::vector<Press> presses{{"along -x", {-1, 0}},
                                            {"along +x", {1, 0}},
                                            {"along +y", {0, 1}},
                                            {"along -y", {0, -1}},
                                            {"between -x and +y", {-0.8, 0.6}}};
    for (const Press& one : presses) {
      for (const double range : {1.0, 1.5}) {
        const double by = range * so_far_.travel;
        for (const bool back : {false, true}) {
          add(fmt::format("press {} by {:.3g} m from {}{}", one.name, by, shape, back ? " and unload" : ""),
              press(experiment_, rest, by * one.direction, back, so_far_.pause));
        }
      }
    }
  }

  [[nodiscard]] std::vector<Proposal> best(std::size_t count) {
    // Of runs that promise the same to a few percent the one that asks least stands first.
    const auto grade = [](const Proposal& one) { return std::lround(16 * std::log(one.log_odds + 1e-3)); };
    std::stable_sort(proposals_.begin(), proposals_.end(),
                     [&](const Proposal& a, const Proposal& b) { return grade(a) > grade(b); });
    std::vector<Proposal> chosen;
    for (const Proposal& one : proposals_) {
      const bool alike = std::any_of(chosen.begin(), chosen.end(), [&](const Proposal& other) {
        return other.run.rest == one.run.rest && other.angles == one.angles &&
               other.out_of_gravity == one.out_of_gravity;
      });
      if (!alike && chosen.size() < count) chosen.push_back(one);
    }
    return chosen;
  }

 private:
  [[nodiscard]] const Imitation& known(std::size_t a, std::size_t b) const {
    return known_[a * rivals_.size() + b];
  }

  void add(const std::string& what, const Run& run) {
    const bool weighs = experiment_.bench.plane != Bench::Plane::horizontal;
    for (const bool out_of_gravity : {false, true}) {
      if (out_of_gravity && !weighs) continue;
      const auto all = forecast(Study(bench_for(experiment_, run, out_of_gravity)), rivals_, so_far_);
      if (!all) continue;
      for (const bool angles : {false, true}) {
        const Noise sigma = with_angles(experiment_.noise);
        const double after = expected_log_odds(rivals_.size(), [&](std::size_t a, std::size_t b) {
          return stacked(known(a, b), new_rows((*all)[a], (*all)[b], sigma, noise_, angles));
        });
        proposals_.push_back({what + (out_of_gravity ? ", the rig turned out of gravity" : "") +
                                  (angles ? ", joint angles measured" : ""),
                              run, angles, out_of_gravity, after, before_});
      }
    }
  }

  const Experiment& experiment_;
  const NoiseModel& noise_;
  Extent so_far_;
  std::vector<Fit> rivals_;
  std::vector<Imitation> known_;  ///< [truth][imitator]
  double before_ = 0;
  std::vector<Proposal> proposals_;
};

}  // namespace

std::vector<Proposal> next_runs(const Study& study, const std::vector<Fit>& rivals, const NoiseModel& noise,
                                std::size_t count) {
  Planner planner(study, rivals, noise);
  for (const Run& run : study.experiment().runs) {
    std::vector<double> mirrored = run.rest;
    for (double& q : mirrored) q = -q;
    planner.add_presses(run.rest, "the rest shape of " + run.id);
    planner.add_presses(mirrored, "the mirrored rest shape of " + run.id);
  }
  return planner.best(count);
}

}  // namespace plumbline::diagnose
