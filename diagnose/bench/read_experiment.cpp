#include "diagnose/bench/read_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/assumed_weight.hpp"
#include "diagnose/bench/continued_runs.hpp"
#include "diagnose/bench/covariates.hpp"
#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/nominal_units.hpp"
#include "diagnose/bench/read_date.hpp"
#include "diagnose/bench/read_loads.hpp"
#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/bench/read_parts.hpp"
#include "diagnose/bench/read_poses.hpp"
#include "diagnose/bench/read_samples.hpp"
#include "diagnose/bench/sample_format.hpp"
#include "diagnose/bench/states.hpp"
#include "diagnose/bench/unmeasured.hpp"
#include "diagnose/screening/physical.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

namespace fs = std::filesystem;

Bench::Plane plane(const Section& bench) {
  const std::string word = bench.one_of("gravity_plane", {"vertical", "horizontal", "unknown"});
  if (word == "vertical") return Bench::Plane::vertical;
  return word == "horizontal" ? Bench::Plane::horizontal : Bench::Plane::unknown;
}

/// \param has_links  a joint without a link has no weight
Bench read_bench(const Section& root, bool has_links) {
  if (!has_links && root.has("bench")) root.refuse("bench", "nothing: a joint alone has no weight");
  if (!has_links) return {Bench::Plane::horizontal, {0.0, 0.0}, false};
  const Section bench = root.table_or_empty("bench");
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

/// Each noise in the unit of its readings.
Noise read_noise(const Section& noise, const SampleFormat& format) {
  std::set<std::string> own;
  for (const Column& column : format.columns)
    if (column.reads) own.insert(std::string(column.reads->kind().noise_key));
  require_keys(noise, format, own);
  Noise read;
  for (const Column& column : format.columns)
    if (column.reads)
      read[column.reads->name] =
          in_si(noise.non_negative(std::string(column.reads->kind().noise_key)), column.unit);
  return read;
}

/// \throws Error for a path outside the folder, after resolving links, or for no regular file
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

/// The kind of reading: an experiment, or a bench before any measurement.
struct Source {
  const ReadParts& read;
  bool plan;
  const ReadArm& arm;
};

/// Settings that the runs inherit.
struct Shared {
  const Source& source;
  const Experiment& experiment;
  SampleFormat format;
  Unit rest;
  /// In words.
  std::string chain;
};

/// Whether all forces of a run point straight down without noise, as weights do and a servo with a load cell
/// hardly would.
bool pulls_as_weights_do(const Run& run, const Experiment& experiment) {
  const bool exact = experiment.noise[Channel::Name::Fx] == 0 && experiment.noise[Channel::Name::Fy] == 0;
  if (run.holds_end_point() || experiment.bench.plane != Bench::Plane::vertical || !exact) return false;
  constexpr double three_decimals = 1e-3;  // of the direction of gravity
  const Eigen::Vector2d down = experiment.bench.down().normalized();
  const auto is_down = [&](const Reading& reading) {
    const Eigen::Vector2d force = run.imposed_at(reading);
    return force.dot(down) >= 0 && (force - force.dot(down) * down).norm() <= three_decimals * force.norm();
  };
  const auto pulls = [&](const Reading& reading) { return run.imposed_at(reading).norm() > 0; };
  return std::all_of(run.readings.begin(), run.readings.end(), is_down) &&
         std::any_of(run.readings.begin(), run.readings.end(), pulls);
}

/// The source of an imposed force: as declared, or inferred. Joints that are commanded, and chains that
/// tendons pull, have none without a force on the end point.
bool read_by_weights(const Section& section, const Run& run, const Experiment& experiment) {
  const auto loaded = [&](const Reading& reading) { return run.imposed_at(reading).norm() > 0; };
  const bool may_be_free = run.commands_joints() || (!run.holds_end_point() && !run.loads.empty());
  if (may_be_free && std::none_of(run.readings.begin(), run.readings.end(), loaded)) return true;
  if (!section.has("loaded_by")) return pulls_as_weights_do(run, experiment);
  const std::string word = section.one_of("loaded_by", {"servo", "weights"});
  if (word == "weights" && run.holds_end_point())
    section.refuse("loaded_by", "nothing, or \"servo\", where the end point is put");
  return word == "weights";
}

/// \param commanded  whether the run imposes joint angles
void read_samples_of(const Section& section, const Shared& shared, bool commanded, Run& run) {
  SampleFormat format = read_sample_format(section, shared.format);
  format.commanded = commanded;
  format.free_end = commanded || (!run.holds_end_point() && !shared.experiment.loads.empty());
  format.any_order |= (shared.source.plan && format.header) || commanded;  // a plan may hold commands alone
  Samples samples = read_samples(shared.source.read(section, format), run.control);
  run.readings = std::move(samples.readings);
  run.origins = std::move(samples.origins);
}

/// Whether the first reading was taken on the way.
bool read_beginning(const Section& section, const Run& run) {
  if (!section.has("begins")) return false;
  const std::string word = section.one_of("begins", {"relaxed", "moving"});
  if (word == "moving" && run.holds_end_point() && run.imposed().size() > 1)
    section.refuse("begins", "nothing, or \"relaxed\", where the end point is put");
  return word == "moving";
}

/// The rest angles of the run, or else of the nominal model.
std::vector<double> read_rest(const Section& section, const Shared& shared) {
  const Experiment& experiment = shared.experiment;
  if (!section.has("rest") && !experiment.rest.empty()) return experiment.rest;
  if (!section.has("rest") && !experiment.has_links()) return {0};
  std::vector<double> rest = section.numbers("rest", 0);
  if (rest.size() != experiment.link_length.size())
    throw Error(section.place("rest"), fmt::format("{} values", rest.size()),
                fmt::format("{}, one for each link of {}", experiment.link_length.size(), shared.chain));
  for (double& angle : rest) angle = in_si(angle, shared.rest);
  return rest;
}

/// The loads along the chain as part of the run's command, in its unit: that of a force, of the place that a
/// force moves by the nominal stiffness, or of what commanded angles do to a chain of length 1.
std::vector<LoadChannel> loads_of(const Run& run, const Experiment& experiment) {
  std::vector<LoadChannel> loads =
      load_channels(experiment.loads, experiment.link_length, experiment.covariates);
  const double length = std::accumulate(experiment.link_length.begin(), experiment.link_length.end(), 0.0),
               stiffest =
                   *std::max_element(experiment.joint_stiffness.begin(), experiment.joint_stiffness.end()),
               turn = stiffest > 0 ? length / stiffest : 0;
  for (LoadChannel& load : loads) {
    if (run.commands_joints()) load.moves *= turn;
    if (run.holds_end_point()) load.moves *= turn * length;
  }
  return loads;
}

Run read_run(const Section& section, const Shared& shared) {
  section.allow_only({"id", "state", "control", "begins", "loaded_by", "rest", "samples", "csv", "columns"});
  Run run;
  run.id = section.name("id", "a name");
  run.device = shared.experiment.device;
  const EndKind& end = run.end();
  const std::string place(end.by_place), load(end.by_load),
      control = section.one_of("control", {place, load, "command"});
  const bool commanded = control == "command";
  run.control = control == place ? Control::end_point : Control::force;
  if (commanded && section.has("rest"))
    section.refuse("rest", "nothing beside control = \"command\": q_command says it");
  if (!commanded) run.rest = read_rest(section, shared);
  if (!shared.source.plan || section.has("samples") || commanded)
    read_samples_of(section, shared, commanded, run);
  if (commanded) run.rest = run.readings.front().rest;
  run.loads = loads_of(run, shared.experiment);
  run.begins_moving = read_beginning(section, run);
  run.by_weights = read_by_weights(section, run, shared.experiment);
  run.weights_inferred = !section.has("loaded_by") && pulls_as_weights_do(run, shared.experiment);
  return run;
}

std::vector<Run> read_runs(const Section& root, const Shared& shared) {
  if (!root.has("run")) throw Error(root.place("run"), "no such key", "at least one [[run]]");
  std::vector<Run> runs;
  std::set<std::string> ids;
  for (const Section& section : root.tables("run")) {
    runs.push_back(read_run(section, shared));
    if (!ids.insert(runs.back().id).second)
      throw Error(section.place("id"), "\"" + runs.back().id + "\" again", "an id that no other run has");
  }
  return runs;
}

/// Subtracts the first time stamp of the experiment where it is larger than the duration: a clock of the day
/// or of the computer.
void count_from_first_reading(std::vector<Run>& runs) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const Run& run : runs)
    for (const Reading& reading : run.readings)
      first = std::min(first, reading.t), last = std::max(last, reading.t);
  if (!(first > last - first)) return;
  for (Run& run : runs)
    for (Reading& reading : run.readings) reading.t -= first;
}

Run read_poses_of(const Section& section, const Source& source, const PoseFormat& format,
                  const Experiment& experiment) {
  section.allow_only({"id", "state", "control", "loaded_by", "samples", "csv", "columns"});
  Run run;
  run.id = section.name("id", "a name");
  run.control = Control::force;
  run.device = experiment.device;
  run.points = experiment.arm_bench.points.size();
  run.of_sensors = experiment.arm_bench.sensor_channels(experiment.arm->arm.size());
  if (section.has("control") && section.text("control", "\"command\"") != "command")
    section.refuse("control", "\"command\", or no such key, for an arm");
  PoseFormat own = format;
  own.table = read_sample_format(section, format.table);
  Samples samples = read_poses(source.read(section, own.table), own, experiment);
  run.readings = std::move(samples.readings);
  run.origins = std::move(samples.origins);
  run.rest = run.readings.front().rest;
  run.by_weights =
      !section.has("loaded_by") || section.one_of("loaded_by", {"servo", "weights"}) == "weights";
  return run;
}

/// The settings of an arm in space, from the table [arm] on.
Experiment read_arm_settings(const Section& root, const Source& source) {
  if (root.has("load"))
    root.refuse("load", "nothing: loads act along a planar chain; of an arm in space a wrench does");
  root.allow_only({"format", "name", "date", "arm", "noise", "units", "csv", "columns", "run"});
  static_cast<void>(read_date(root));
  Experiment experiment;
  experiment.name = root.name("name", "a name");
  const ReadArmBench read = read_arm(root.table("arm"), source.arm);
  static_cast<NominalChain&>(experiment) = chain_of(read.arm);
  experiment.arm_bench = read.bench;
  experiment.bench = {Bench::Plane::vertical, {0.0, 0.0}, false};
  PoseFormat format = pose_format(experiment, root.table_or_empty("units"), read.motor_side);
  format.table = read_sample_format(root, std::move(format.table));
  experiment.noise = read_noise(root.table("noise"), format.table);
  if (!root.has("run")) throw Error(root.place("run"), "no such key", "at least one [[run]]");
  std::set<std::string> ids;
  for (const Section& section : root.tables("run")) {
    experiment.runs.push_back(read_poses_of(section, source, format, experiment));
    if (!ids.insert(experiment.runs.back().id).second)
      throw Error(section.place("id"), "\"" + experiment.runs.back().id + "\" again",
                  "an id that no other run has");
  }
  experiment.covariates = complete_covariates(experiment.runs, root.place("run"), {});
  count_from_first_reading(experiment.runs);
  assume_weights(experiment);
  return experiment;
}

/// All settings, before any plausibility check.
Experiment read_settings(const Section& root, const Source& source, const NominalChain* model) {
  const std::string expected = "\"chain-experiment/1\"";
  if (root.text("format", expected) != "chain-experiment/1") root.refuse("format", expected);
  require_one_state(root);
  if (root.has("arm")) return read_arm_settings(root, source);
  root.allow_only(
      {"format", "name", "date", "nominal", "bench", "load", "noise", "units", "csv", "columns", "run"});
  static_cast<void>(read_date(root));  // of use to who compares experiments
  Experiment experiment;
  experiment.name = root.name("name", "a name");
  const NominalChain nominal = model ? *model : read_nominal(root.table("nominal"));
  const NominalUnits units = read_nominal_units(root, nominal.slides(0));
  static_cast<NominalChain&>(experiment) = model ? nominal : in_si(nominal, units);
  experiment.origins = units.origins(model == nullptr);
  experiment.bench = read_bench(root, nominal.has_links());
  SampleFormat format = standard_format(experiment.link_length.size(), nominal.device);
  experiment.loads = read_loads(root, experiment, format);
  for (const Column& column : format.columns)
    if (column.says == Says::covariate) experiment.covariates.push_back(column.channel);
  const Shared shared{source, experiment, read_sample_format(root, std::move(format)), units.rest,
                      model ? "the model that is given" : "the nominal chain"};
  experiment.noise = read_noise(root.table("noise"), shared.format);
  experiment.runs = read_runs(root, shared);
  experiment.covariates =
      complete_covariates(experiment.runs, root.place("run"), std::move(experiment.covariates));
  join_continued(experiment);
  count_from_first_reading(experiment.runs);
  return experiment;
}

/// The same from files.
/// \param table  of experiment.toml
Experiment read_folder(const fs::path& folder, const toml::table& table, const ReadFile& read, bool plan,
                       const NominalChain* model, const ReadArm& arm = {}) {
  const ReadParts read_all = [&](const Section& run, const SampleFormat& format) {
    return read_parts(run, format, [&](const std::string& name, const std::string& place) {
      return NamedText{(folder / name).string(), read(name, place)};
    });
  };
  return read_settings(Section(table, (folder / "experiment.toml").string()), {read_all, plan, arm}, model);
}
Experiment read_folder(const fs::path& folder, const ReadFile& read, bool plan, const NominalChain* model,
                       const ReadArm& arm = {}) {
  const std::string settings = "experiment.toml", file = (folder / settings).string();
  return read_folder(folder, files::parse_toml(read(settings, file), file), read, plan, model, arm);
}

ReadFile files_of(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(folder.string(), "no such folder", "an experiment's folder");
  return [folder](const std::string& name, const std::string& place) {
    return files::read_text(file_inside(folder, name, place));
  };
}

/// A reader of models of arms in the folder.
ReadArm inside(const fs::path& folder, const ReadArm& arm) {
  if (!arm) return {};
  return [folder, arm](const std::string& name, const std::string& base, const std::string& tip) {
    return arm(file_inside(folder, name, "arm.model").string(), base, tip);
  };
}

/// What is planned, before anything is measured.
Experiment as_bench(Experiment planned) {
  Experiment bench = unmeasured(std::move(planned));
  require_bench(bench);
  return bench;
}

}  // namespace

Experiment read_experiment(const fs::path& folder, const NominalChain* model, const ReadArm& arm) {
  Experiment experiment = read_folder(folder, files_of(folder), false, model, inside(folder, arm));
  require_physical(experiment);
  return experiment;
}

Experiment read_experiment(const fs::path& folder, const toml::table& settings, const NominalChain* model,
                           const ReadArm& arm) {
  Experiment experiment = read_folder(folder, settings, files_of(folder), false, model, inside(folder, arm));
  require_physical(experiment);
  return experiment;
}

Experiment read_experiment(const fs::path& folder, const ReadFile& read, const NominalChain* model) {
  Experiment experiment = read_folder(folder, read, false, model);
  require_physical(experiment);
  return experiment;
}

Experiment read_experiment(const toml::table& settings, const std::string& source, const ReadParts& read,
                           const NominalChain* model, const ReadArm& arm) {
  Experiment experiment = read_settings(Section(settings, source), {read, false, arm}, model);
  require_physical(experiment);
  return experiment;
}

Experiment read_plan(const fs::path& folder, const NominalChain* model, const ReadArm& arm) {
  return as_bench(read_folder(folder, files_of(folder), true, model, inside(folder, arm)));
}

Experiment read_plan(const fs::path& folder, const ReadFile& read, const NominalChain* model) {
  return as_bench(read_folder(folder, read, true, model));
}

Experiment read_plan(const toml::table& settings, const std::string& source, const ReadParts& read,
                     const NominalChain* model) {
  return as_bench(read_settings(Section(settings, source), {read, true, {}}, model));
}

}  // namespace plumbline::diagnose
