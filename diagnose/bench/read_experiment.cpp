#include "diagnose/bench/read_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/plausible.hpp"
#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/bench/read_samples.hpp"
#include "files/printable.hpp"
#include "files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

namespace fs = std::filesystem;

Bench::Plane plane(const Section& bench) {
  const std::string expected = "\"vertical\", \"horizontal\" or \"unknown\"";
  const std::string word = bench.text("gravity_plane", expected);
  if (word == "vertical") return Bench::Plane::vertical;
  if (word == "horizontal") return Bench::Plane::horizontal;
  if (word == "unknown") return Bench::Plane::unknown;
  throw Error(bench.place("gravity_plane"), "\"" + word + "\"", expected);
}

Bench read_bench(const Section& bench) {
  bench.allow_only({"gravity_plane", "gravity_direction"});
  Bench result{Bench::Plane::unknown, {0.0, 0.0}, false};
  if (bench.has("gravity_plane")) result.plane = plane(bench);
  if (!bench.has("gravity_direction")) return result;
  result.gravity_direction = bench.pair("gravity_direction");
  result.has_direction = true;
  const double norm = std::hypot(result.gravity_direction[0], result.gravity_direction[1]);
  const double written_to = 1e-3;  // a direction noted to three decimals still counts as a unit vector
  if (std::abs(norm - 1) > written_to)
    throw Error(bench.place("gravity_direction"), fmt::format("a vector of length {:.4g}", norm),
                "a unit vector");
  if (result.plane == Bench::Plane::horizontal)
    throw Error(bench.place("gravity_direction"), "a direction", "none in a horizontal plane");
  return result;
}

Noise read_noise(const Section& noise) {
  noise.allow_only({"x", "y", "Fx", "Fy", "q"});
  return {noise.non_negative("x"), noise.non_negative("y"), noise.non_negative("Fx"),
          noise.non_negative("Fy"), noise.non_negative("q")};
}

/// \throws Error at the place for what is not inside the folder, behind all links, or no plain file
fs::path file_inside(const fs::path& folder, const std::string& name, const std::string& place) {
  std::error_code error;
  const fs::path file = fs::weakly_canonical(folder / name, error);
  const fs::path inside = file.lexically_relative(fs::weakly_canonical(folder));
  if (error || inside.empty() || *inside.begin() == "..")
    throw Error(place, "\"" + files::shown(name) + "\"", "a file inside the experiment's folder");
  if (fs::exists(file, error) && !fs::is_regular_file(file, error))
    throw Error(place, "\"" + files::shown(name) + "\", which is no plain file", "a file with samples");
  return folder / name;
}

/// \param nominal  whose rest angles are those of a run that names none
Run read_run(const Section& section, const fs::path& folder, const ReadFile& read,
             const NominalChain& nominal) {
  section.allow_only({"id", "control", "rest", "samples"});
  Run run;
  run.id = section.text("id", "a name");
  const std::string expected = "\"displacement\" or \"force\"";
  const std::string control = section.text("control", expected);
  if (control != "displacement" && control != "force")
    throw Error(section.place("control"), "\"" + control + "\"", expected);
  run.control = control == "force" ? Control::force : Control::end_point;
  const std::size_t n = nominal.link_length.size();
  run.rest = section.has("rest") || nominal.rest.empty() ? section.numbers("rest", n) : nominal.rest;
  const std::string name = section.text("samples", "the name of a sample file");
  run.readings =
      parse_samples(read(name, section.place("samples")), (folder / name).string(), run.control, n);
  return run;
}

std::vector<Run> read_runs(const Section& root, const fs::path& folder, const ReadFile& read,
                           const NominalChain& nominal) {
  const toml::node& node = root.required("run", "at least one [[run]]");
  if (!node.is_array_of_tables()) throw Error(root.place("run"), shown(node), "at least one [[run]]");
  std::vector<Run> runs;
  std::set<std::string> ids;
  for (const toml::node& entry : *node.as_array()) {
    const Section section(*entry.as_table(), root.place("run[" + std::to_string(runs.size() + 1) + "]."));
    runs.push_back(read_run(section, folder, read, nominal));
    if (!ids.insert(runs.back().id).second)
      throw Error(section.place("id"), "\"" + runs.back().id + "\" again", "an id that no other run has");
  }
  return runs;
}

}  // namespace

Experiment read_experiment(const fs::path& folder, const NominalChain* model) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(folder.string(), "no such folder", "an experiment's folder");
  const ReadFile read = [&](const std::string& name, const std::string& place) {
    return files::read_text(file_inside(folder, name, place));
  };
  return read_experiment(folder, read, model);
}

Experiment read_experiment(const fs::path& folder, const ReadFile& read, const NominalChain* model) {
  const std::string settings = "experiment.toml", file = (folder / settings).string();
  const toml::table table = files::parse_toml(read(settings, file), file);
  const Section root(table, file + ": ");
  const std::string format = root.text("format", "\"chain-experiment/1\"");
  if (format != "chain-experiment/1")
    throw Error(root.place("format"), "\"" + format + "\"", "\"chain-experiment/1\"");
  root.allow_only({"format", "name", "nominal", "bench", "noise", "run"});
  Experiment experiment;
  experiment.name = root.text("name", "a name");
  static_cast<NominalChain&>(experiment) = model ? *model : read_nominal(root.table("nominal"));
  experiment.bench =
      root.has("bench") ? read_bench(root.table("bench")) : Bench{Bench::Plane::unknown, {0.0, 0.0}, false};
  experiment.noise = read_noise(root.table("noise"));
  experiment.runs = read_runs(root, folder, read, experiment);
  require_physical(experiment);
  return experiment;
}

}  // namespace plumbline::diagnose
