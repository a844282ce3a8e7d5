// Instruments of the wider catalogue, and runs of another day.

#include "simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

constexpr std::string_view instruments = "instruments", other_day = "another day";

/// The number of a run, counted from 1, and values after it.
Values with_run(std::size_t run, const Values& values) {
  Values all{static_cast<double>(run + 1)};
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

OtherDay day_of(const Plan& plan, const Values& v, std::vector<double> rest, Pair tare) {
  return {plan.runs.at(static_cast<std::size_t>(v[0]) - 1).id, std::move(rest), tare};
}

}  // namespace

std::vector<Kind> sensors() {
  return {
      {"run_rest",
       "",
       false,
       {"run"},
       {false, true},
       false,
       6,
       [](const Scene& s, Place) { return s.plan.runs.size() > 1; },
       [](const Scene& s, Place, Random& r) {
         return with_run(r.below(s.plan.runs.size()), at_every_joint(s, r, 0.02, true));
       },
       [](Physics& is, const Plan& plan, Place, const Values& v) {
         is.other_day = day_of(plan, v, {v.begin() + 1, v.end()}, {0, 0});
       },
       {"a"},
       other_day},
      {"run_tare",
       "",
       false,
       {"run", "b_x", "b_y"},
       {false, true, true},
       false,
       20,
       [](const Scene& s, Place) { return imposed_runs(s) > 1; },
       [](const Scene& s, Place, Random& r) {
         std::size_t run = r.below(s.plan.runs.size());
         while (s.plan.runs[run].force_controlled) run = r.below(s.plan.runs.size());
         return with_run(run, in_plane(r, r.log_uniform(0.005, 0.05) * s.force));
       },
       [](Physics& is, const Plan& plan, Place, const Values& v) {
         is.other_day = day_of(plan, v, {}, {v[1], v[2]});
       },
       {},
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
       [](const Scene& s, Place, Random& r) { return one_way(r, 0.1 * s.pause, 1.5 * s.pause); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.lag += v[0]; },
       {},
       instruments},
  };
}

}  // namespace plumbline::simulator
