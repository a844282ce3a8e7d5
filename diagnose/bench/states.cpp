#include "diagnose/bench/states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>

#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

toml::table settings_in(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  return files::parse_toml(files::read_text(file), file.string());
}

/// Of a run; empty without one.
std::string state_of(const toml::node& run) {
  const toml::table* const table = run.as_table();
  return table ? (*table)["state"].value_or(std::string()) : std::string();
}

}  // namespace

std::vector<std::string> states_in(const std::filesystem::path& folder) {
  const toml::table settings = settings_in(folder);
  std::vector<std::string> states;
  if (const toml::array* const runs = settings["run"].as_array())
    for (const toml::node& run : *runs)
      if (const std::string state = state_of(run);
          !state.empty() && std::find(states.begin(), states.end(), state) == states.end())
        states.push_back(state);
  return states;
}

toml::table settings_of(const std::filesystem::path& folder, const std::string& state) {
  const std::vector<std::string> states = states_in(folder);
  if (std::find(states.begin(), states.end(), state) == states.end())
    throw Error(folder.string(), fmt::format("no run of the state \"{}\"", state),
                states.empty() ? "runs with a key state, or a folder"
                               : fmt::format("one of {}", fmt::join(states, ", ")));
  toml::table settings = settings_in(folder);
  toml::array& runs = *settings["run"].as_array();
  for (std::size_t r = runs.size(); r-- > 0;)
    if (state_of(runs[r]) != state) runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(r));
  return settings;
}

void require_one_state(const Section& root) {
  std::set<std::string> states;
  for (const Section& run : root.has("run") ? root.tables("run") : std::vector<Section>()) {
    states.insert(run.has("state") ? run.name("state", "a name") : "");
    if (states.size() > 1)
      throw Error(run.place("state"),
                  fmt::format("runs of the states \"{}\"", fmt::join(states, "\" and \"")),
                  "runs of one state; --against STATE and --since compare several");
  }
}

}  // namespace plumbline::diagnose
