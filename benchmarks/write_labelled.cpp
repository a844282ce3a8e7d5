#include "benchmarks/write_labelled.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

namespace plumbline::bench {
namespace {

std::string list(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::vector<double> angles(const Run& run, const diagnose::Reading& reading) {
  return run.reads_angles() ? reading.angles(run.rest.size()) : std::vector<double>();
}

}  // namespace

void write_labelled(const std::filesystem::path& folder, const Experiment& experiment,
                    const nlohmann::json& label) {
  std::filesystem::create_directories(folder);
  std::ofstream toml(folder / "experiment.toml");
  toml << fmt::format("format = \"chain-experiment/1\"\nname = \"{}\"\n\n[nominal]\nlink_length = {}\n",
                      experiment.name, list(experiment.link_length));
  toml << fmt::format("joint_stiffness = {}\n\n[bench]\n", list(experiment.joint_stiffness));
  if (experiment.bench.plane == Bench::Plane::vertical)
    toml << "gravity_plane = \"vertical\"\ngravity_direction = [0.0, -1.0]\n";
  else
    toml << fmt::format("gravity_plane = \"{}\"\n",
                        experiment.bench.plane == Bench::Plane::horizontal ? "horizontal" : "unknown");
  using Name = diagnose::Channel::Name;
  const Noise& noise = experiment.noise;
  toml << fmt::format("\n[noise]\nx = {}\ny = {}\nFx = {}\nFy = {}\n", noise[Name::x], noise[Name::y],
                      noise[Name::Fx], noise[Name::Fy]);
  if (noise[Name::q] > 0) toml << fmt::format("q = {}\n", noise[Name::q]);
  for (const Run& run : experiment.runs) {
    toml << fmt::format("\n[[run]]\nid = \"{0}\"\ncontrol = \"{1}\"\nrest = {2}\nsamples = \"{0}.csv\"\n",
                        run.id, run.control == Control::end_point ? "displacement" : "force", list(run.rest));
    std::ofstream csv(folder / (run.id + ".csv"));
    csv << "t,x,y,Fx,Fy";
    for (std::size_t j = 0; j < angles(run, run.readings[0]).size(); ++j) csv << ",q" << j + 1;
    csv << "\n";
    for (const diagnose::Reading& r : run.readings) {
      csv << fmt::format("{},{},{},{},{}", r.t, r[diagnose::column_x], r[diagnose::column_y],
                         r[diagnose::column_Fx], r[diagnose::column_Fy]);
      for (const double q : angles(run, r)) csv << "," << q;
      csv << "\n";
    }
  }
  std::ofstream(folder / "label.json") << label.dump(1) << "\n";
}

}  // namespace plumbline::bench
