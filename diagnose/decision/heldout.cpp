#include "diagnose/decision/heldout.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

namespace plumbline::diagnose {
namespace {

constexpr std::size_t most_parts = 4;

/// Pairs of the eighths of a run, counted from 0, without its ends. No pair is the same stretch of the way on
/// a run that goes and comes back (of these the numbers add up to 7), or goes to both sides and comes back
/// from each (to 3 or 11): of what is held out on one way the other way is seen.
using Eighths = std::array<std::size_t, 2>;
constexpr std::array<Eighths, 3> pairs_of_eighths{{{1, 4}, {2, 6}, {3, 5}}};

/// How far a run's command goes from where it begins.
double reach_of_command(const Run& run) {
  double reach = 0;
  for (const Reading& reading : run.readings)
    reach = std::max(reach, (run.command(reading) - run.command(run.readings.front())).norm());
  return reach;
}

/// The run to do without: of the kind (control, whether it turns back) that has most runs, the one that goes
/// farthest after the farthest, so that what is left goes as far. The order of the runs does not matter. Of
/// two runs neither: what is left would not tell what the runs have in common from what is one run's own.
std::optional<std::size_t> spare_run(const Experiment& experiment) {
  using Kind = std::pair<Control, bool>;
  std::map<Kind, std::vector<std::size_t>> kinds;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    kinds[{experiment.runs[r].control, experiment.runs[r].turns_back()}].push_back(r);
  auto& most = std::max_element(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) {
                 return a.second.size() < b.second.size();
               })->second;
  if (most.size() < 2 || experiment.runs.size() < 3) return std::nullopt;
  const auto key = [&](std::size_t r) {
    return std::pair(reach_of_command(experiment.runs[r]), experiment.runs[r].id);
  };
  std::sort(most.begin(), most.end(), [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
  return most[1];
}

/// Runs of which another is of the same kind, kind by kind, the farthest first.
std::vector<std::size_t> replaceable_runs(const Experiment& experiment) {
  const auto kind = [&](std::size_t r) {
    return std::pair(experiment.runs[r].control, experiment.runs[r].turns_back());
  };
  std::map<std::pair<Control, bool>, std::size_t> count;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) ++count[kind(r)];
  std::vector<std::size_t> runs;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    if (count[kind(r)] > 1) runs.push_back(r);
  const auto key = [&](std::size_t r) {
    return std::tuple(kind(r), -reach_of_command(experiment.runs[r]), experiment.runs[r].id);
  };
  std::sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return runs;
}

/// Two of the eighths of every run.
HeldOut blocks(const Experiment& experiment, const Eighths& eighths) {
  HeldOut heldout = nothing_held(experiment);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const std::size_t length = run.readings.size() / 8;
    if (length == 0) continue;
    for (const std::size_t eighth : eighths) {
      const std::size_t from = eighth * length;
      std::fill_n(heldout.reading[r].begin() + static_cast<std::ptrdiff_t>(from), length, true);
      heldout.names.push_back(run.id + "[" + std::to_string(run.first_taken(from)) + ":" +
                              std::to_string(run.last_taken(from + length - 1)) + "]");
    }
  }
  return heldout;
}

}  // namespace

HeldOut nothing_held(const Experiment& experiment) {
  HeldOut none;
  for (const Run& run : experiment.runs) none.reading.emplace_back(run.readings.size(), false);
  return none;
}

HeldOut choose_heldout(const Experiment& experiment) {
  HeldOut heldout = nothing_held(experiment);
  if (const std::optional<std::size_t> r = spare_run(experiment)) {
    heldout.reading[*r].assign(heldout.reading[*r].size(), true);
    heldout.names.push_back(experiment.runs[*r].id);
    return heldout;
  }
  return choose_blocks(experiment);
}

HeldOut choose_blocks(const Experiment& experiment) {
  return blocks(experiment, pairs_of_eighths[1]);
}

Experiment without(const Experiment& experiment, const HeldOut& heldout) {
  Experiment rest = experiment;
  constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t r = 0; r < rest.runs.size(); ++r) {
    Run& run = rest.runs[r];
    const std::vector<Channel> measured = run.measured();
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      if (!heldout.reading[r][i]) continue;
      Reading& reading = run.readings[i];
      for (const Channel& channel : measured) channel.in(reading) = unseen;
    }
  }
  // A run of which nothing is left would only be walked for nothing.
  std::erase_if(rest.runs, [&](const Run& run) {
    const auto r = static_cast<std::size_t>(&run - rest.runs.data());
    return std::all_of(heldout.reading[r].begin(), heldout.reading[r].end(), [](bool held) { return held; });
  });
  return rest;
}

std::vector<HeldOut> run_parts(const Experiment& experiment) {
  if (experiment.runs.size() < 3) return {};
  const std::vector<std::size_t> runs = replaceable_runs(experiment);
  std::vector<HeldOut> parts(std::min(runs.size(), most_parts), nothing_held(experiment));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    HeldOut& part = parts[i % most_parts];
    part.reading[runs[i]].assign(part.reading[runs[i]].size(), true);
    part.names.push_back(experiment.runs[runs[i]].id);
  }
  return parts;
}

std::vector<HeldOut> block_parts(const Experiment& experiment) {
  std::vector<HeldOut> parts;
  for (const Eighths& pair : pairs_of_eighths)
    if (HeldOut part = blocks(experiment, pair); !part.empty()) parts.push_back(std::move(part));
  return parts;
}

HeldOut named(const Experiment& experiment, const std::vector<std::string>& names) {
  HeldOut all = nothing_held(experiment);
  std::vector<HeldOut> parts = run_parts(experiment);
  for (const HeldOut& part : block_parts(experiment)) parts.push_back(part);
  parts.push_back(choose_heldout(experiment));
  for (const HeldOut& part : parts) {
    const bool among = std::all_of(part.names.begin(), part.names.end(), [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
    for (std::size_t r = 0; among && r < part.reading.size(); ++r)
      for (std::size_t i = 0; i < part.reading[r].size(); ++i)
        if (part.reading[r][i]) all.reading[r][i] = true;
  }
  all.names = names;
  return all;
}

}  // namespace plumbline::diagnose
