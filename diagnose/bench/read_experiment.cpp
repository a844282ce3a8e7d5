#include "diagnose/bench/read_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <plumbline/base/error.hpp>
#include <set>
#include <sstream>

#include "diagnose/bench/plausible.hpp"
#include "diagnose/bench/read_samples.hpp"
#include "files/printable.hpp"
#include "files/text_file.hpp"
#include "files/toml_file.hpp"

namespace plumbline::diagnose {
namespace {

namespace fs = std::filesystem;

std::string shown(const toml::node& node) {
  if (const auto* value = node.as_floating_point()) return fmt::format("{}", value->get());
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return files::shown(text.str());
}

/// A table of the file, with the words that an error about it begins with.
class Section {
 public:
  Section(const toml::table& table, std::string place) : table_(table), place_(std::move(place)) {}

  [[nodiscard]] std::string place(const std::string& key) const { return place_ + key; }

  void allow_only(const std::set<std::string>& keys) const {
    for (const auto& [key, value] : table_) {
      if (keys.contains(std::string(key.str()))) continue;
      std::string expected = "one of";
      for (const std::string& known : keys) expected += " " + known;
      throw Error(place(files::shown(key.str())), "an unknown key", expected);
    }
  }

  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }

  [[nodiscard]] const toml::node& required(const std::string& key, const std::string& expected) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) throw Error(place(key), "no such key", expected);
    return *node;
  }

  [[nodiscard]] Section table(const std::string& key) const {
    const toml::node& node = required(key, "a table [" + key + "]");
    if (!node.is_table()) throw Error(place(key), shown(node), "a table [" + key + "]");
    return {*node.as_table(), place(key) + "."};
  }

  [[nodiscard]] std::string text(const std::string& key, const std::string& expected) const {
    const toml::node& node = required(key, expected);
    if (!node.is_string() || node.as_string()->get().empty()) throw Error(place(key), shown(node), expected);
    files::require_printable(node.as_string()->get(), place(key));
    return node.as_string()->get();
  }

  /// Zero where the key is absent.
  [[nodiscard]] double non_negative(const std::string& key) const {
    if (!has(key)) return 0;
    const std::string expected = "a number, zero or positive";
    const double value = number(required(key, expected), place(key), expected);
    if (value < 0) throw Error(place(key), shown(*table_.get(key)), expected);
    return value;
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const {
    const std::string expected =
        count == 0 ? std::string("a list of numbers") : "a list of " + std::to_string(count) + " numbers";
    const toml::node& node = required(key, expected);
    if (!node.is_array()) throw Error(place(key), shown(node), expected);
    const toml::array& list = *node.as_array();
    if (list.empty() || (count != 0 && list.size() != count))
      throw Error(place(key), std::to_string(list.size()) + " values", expected);
    std::vector<double> values;
    for (const toml::node& entry : list)
      values.push_back(
          number(entry, place(key) + "[" + std::to_string(values.size() + 1) + "]", "a finite number"));
    return values;
  }

 private:
  static double number(const toml::node& node, const std::string& place, const std::string& expected) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) throw Error(place, shown(node), expected);
    return *value;
  }

  const toml::table& table_;
  std::string place_;
};

template <class Accept>
std::vector<double> numbers_that(const Section& section, const std::string& key, std::size_t count,
                                 const std::string& expected, Accept accept) {
  std::vector<double> values = section.numbers(key, count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (accept(values[i])) continue;
    throw Error(section.place(key) + "[" + std::to_string(i + 1) + "]", fmt::format("{}", values[i]),
                expected);
  }
  return values;
}

constexpr auto positive = [](double v) { return v > 0; };
constexpr auto not_negative = [](double v) { return v >= 0; };

std::array<double, 2> pair(const Section& section, const std::string& key) {
  const std::vector<double> values = section.numbers(key, 2);
  return {values[0], values[1]};
}

void read_nominal(const Section& nominal, Experiment& experiment) {
  nominal.allow_only({"link_length", "joint_stiffness", "link_mass", "gravity"});
  experiment.link_length = numbers_that(nominal, "link_length", 0, "a positive length", positive);
  const std::size_t n = experiment.link_length.size();
  experiment.joint_stiffness =
      numbers_that(nominal, "joint_stiffness", n, "zero (passive) or a positive stiffness", not_negative);
  experiment.link_mass.assign(n, 0.0);
  if (nominal.has("link_mass"))
    experiment.link_mass = numbers_that(nominal, "link_mass", n, "zero or a positive mass", not_negative);
  experiment.gravity = nominal.has("gravity") ? pair(nominal, "gravity") : std::array<double, 2>{0.0, 0.0};
}

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
  result.gravity_direction = pair(bench, "gravity_direction");
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

Run read_run(const Section& section, const fs::path& folder, const ReadFile& read, std::size_t n) {
  section.allow_only({"id", "control", "rest", "samples"});
  Run run;
  run.id = section.text("id", "a name");
  const std::string expected = "\"displacement\" or \"force\"";
  const std::string control = section.text("control", expected);
  if (control != "displacement" && control != "force")
    throw Error(section.place("control"), "\"" + control + "\"", expected);
  run.control = control == "force" ? Control::force : Control::end_point;
  run.rest = section.numbers("rest", n);
  const std::string name = section.text("samples", "the name of a sample file");
  run.readings =
      parse_samples(read(name, section.place("samples")), (folder / name).string(), run.control, n);
  return run;
}

std::vector<Run> read_runs(const Section& root, const fs::path& folder, const ReadFile& read, std::size_t n) {
  const toml::node& node = root.required("run", "at least one [[run]]");
  if (!node.is_array_of_tables()) throw Error(root.place("run"), shown(node), "at least one [[run]]");
  std::vector<Run> runs;
  std::set<std::string> ids;
  for (const toml::node& entry : *node.as_array()) {
    const Section section(*entry.as_table(), root.place("run[" + std::to_string(runs.size() + 1) + "]."));
    runs.push_back(read_run(section, folder, read, n));
    if (!ids.insert(runs.back().id).second)
      throw Error(section.place("id"), "\"" + runs.back().id + "\" again", "an id that no other run has");
  }
  return runs;
}

}  // namespace

Experiment read_experiment(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(folder.string(), "no such folder", "an experiment's folder");
  return read_experiment(folder, [&](const std::string& name, const std::string& place) {
    return files::read_text(file_inside(folder, name, place));
  });
}

Experiment read_experiment(const fs::path& folder, const ReadFile& read) {
  const std::string settings = "experiment.toml", file = (folder / settings).string();
  const toml::table table = files::parse_toml(read(settings, file), file);
  const Section root(table, file + ": ");
  const std::string format = root.text("format", "\"chain-experiment/1\"");
  if (format != "chain-experiment/1")
    throw Error(root.place("format"), "\"" + format + "\"", "\"chain-experiment/1\"");
  root.allow_only({"format", "name", "nominal", "bench", "noise", "run"});
  Experiment experiment;
  experiment.name = root.text("name", "a name");
  read_nominal(root.table("nominal"), experiment);
  experiment.bench =
      root.has("bench") ? read_bench(root.table("bench")) : Bench{Bench::Plane::unknown, {0.0, 0.0}, false};
  experiment.noise = read_noise(root.table("noise"));
  experiment.runs = read_runs(root, folder, read, experiment.link_length.size());
  require_physical(experiment);
  return experiment;
}

}  // namespace plumbline::diagnose
