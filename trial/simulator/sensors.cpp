// Instruments of the wider catalogue, and runs of another day.

#include <algorithm>

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

constexpr std::string_view instruments = "instruments", other_day = "another day";

/// Values for each run, of which this one alone differs.
Values in_one_run(const Scene& s, std::size_t run, const Values& values) {
  Values all(s.plan.runs.size() * values.size(), 0.0);
  std::copy(values.begin(), values.end(), all.begin() + static_cast<std::ptrdiff_t>(run * values.size()));
  return all;
}

}  // namespace

std::vector<Kind> sensors() {
  return {
      {"run_rest",
       "",
       false,
       {},
       {true},
       false,
       6,
       [](const Scene& s, Place) { return s.plan.runs.size() > 1; },
       [](const Scene& s, Place, Random& r) {
         return in_one_run(s, r.below(s.plan.runs.size()), at_every_joint(s, r, 0.02, true));
       },
       [](Physics& is, const Plan& plan, Place, const Values& v) {
         const auto joints = static_cast<std::ptrdiff_t>(plan.size());
         auto next = v.begin();
         for (const PlannedRun& run : plan.runs) {
           is.other_day[run.id].rest.assign(next, next + joints);
           next += joints;
         }
       },
       {"a"},
       other_day,
       true},
      {"run_tare",
       "",
       false,
       {},
       {true, true},
       false,
       20,
       [](const Scene& s, Place) { return imposed_runs(s) > 1; },
       [](const Scene& s, Place, Random& r) {
         std::size_t run = r.below(s.plan.runs.size());
         while (s.plan.runs[run].force_controlled) run = r.below(s.plan.runs.size());
         return in_one_run(s, run, in_plane(r, r.log_uniform(0.005, 0.05) * s.force));
       },
       [](Physics& is, const Plan& plan, Place, const Values& v) {
         for (std::size_t r = 0; r < plan.runs.size(); ++r)
           is.other_day[plan.runs[r].id].tare = {v[2 * r], v[2 * r + 1]};
       },
       {"b_x", "b_y"},
       other_day},
      {"cross_talk",
       "",
       false,
       {"c_xy", "c_yx"},
       {true, true},
       false,
       8,
       [](const Scene& s, Place j) { return end_point_imposed(s, j) && s.plan.cross_force_measured; },
       [](const Scene&, Place, Random& r) { return in_plane(r, r.log_uniform(0.01, 0.06)); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.cross_talk = {v[0], v[1]};
       },
       {},
       instruments},
      {"cell_curvature",
       "",
       false,
       {"c_x", "c_y"},
       {true, true},
       false,
       4,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) { return in_plane(r, r.log_uniform(0.01, 0.06) / s.force); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.curvature = {v[0], v[1]};
       },
       {},
       instruments},
      {"saturation",
       "",
       false,
       {"limit"},
       {true},
       true,
       2.5,
       end_point_imposed,
       [](const Scene& s, Place, Random& r) { return Values{significant(r.uniform(0.6, 0.9) * s.force, 4)}; },
       [](Physics& is, const Plan&, Place, const Values& v) { is.saturation = v[0]; },
       {},
       instruments},
      {"sensor_lag",
       "",
       false,
       {"tau"},
       {true},
       false,
       6,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return one_way(r, 0.1 * s.sampling_interval, 1.5 * s.sampling_interval);
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.lag += v[0]; },
       {},
       instruments},
  };
}

}  // namespace plumbline::simulator
