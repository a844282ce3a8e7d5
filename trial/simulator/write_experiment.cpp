#include "trial/simulator/write_experiment.hpp"

#include <fmt/format.h>

#include <cmath>

#include "support/files/output_file.hpp"

namespace plumbline::simulator {
namespace {

/// As a TOML float: with a point.
std::string number(double value) {
  std::string text = fmt::format("{:.6g}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return "[" + text + "]";
}

std::string settings(const Experiment& experiment) {
  const Plan& plan = experiment.plan;
  const Sigma& sigma = experiment.scatter.declared;
  std::string text =
      fmt::format("format = \"chain-experiment/1\"\nname   = \"{}\"\n\n[nominal]\n", experiment.name);
  text += "link_length     = " + list(plan.nominal.length) + "\n";
  text += "joint_stiffness = " + list(plan.nominal.stiffness) + "\n";
  if (!plan.nominal.mass.empty()) {
    text += "link_mass       = " + list(plan.nominal.mass) + "\n";
    text += "gravity         = " + list({plan.nominal.gravity[0], plan.nominal.gravity[1]}) + "\n";
  }
  constexpr std::array<const char*, 3> planes{"horizontal", "vertical", "unknown"};
  text += fmt::format("\n[bench]\ngravity_plane = \"{}\"\n", planes[static_cast<std::size_t>(plan.plane)]);
  if (plan.plane == Plane::vertical)
    text += "gravity_direction = " + list({plan.down[0], plan.down[1]}) + "\n";
  text += fmt::format("\n[noise]\nx = {0}\ny = {0}\nFx = {1}\nFy = {1}\n", number(sigma.position),
                      number(sigma.force));
  if (plan.angles_measured) text += "q = " + number(sigma.angle) + "\n";
  for (const PlannedRun& run : plan.runs) {
    text +=
        fmt::format("\n[[run]]\nid      = \"{0}\"\ncontrol = \"{1}\"\nrest    = {2}\nsamples = \"{0}.csv\"\n",
                    run.id, run.force_controlled ? "force" : "displacement", list(run.rest));
  }
  return text;
}

std::string field(double value, int decimals) {
  return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, decimals);
}

std::string samples(const Readings& readings) {
  std::string text = "t,x,y,Fx,Fy";
  for (std::size_t j = 0; j < readings.front().q.size(); ++j) text += fmt::format(",q{}", j + 1);
  for (const Reading& one : readings) {
    text += fmt::format("\n{},{},{},{},{}", field(one.t, 3), field(one.end_point[0], 6),
                        field(one.end_point[1], 6), field(one.force[0], 6), field(one.force[1], 6));
    for (const double q : one.q) text += "," + field(q, 5);
  }
  return text + "\n";
}

}  // namespace

void write_experiment(const Experiment& experiment, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    files::write_text(folder / (experiment.plan.runs[r].id + ".csv"), samples(experiment.runs[r]));
  files::write_text(folder / "experiment.toml", settings(experiment));
}

}  // namespace plumbline::simulator
