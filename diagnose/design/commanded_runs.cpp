#include "diagnose/design/commanded_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "diagnose/bench/command_range.hpp"

namespace plumbline::diagnose {
namespace {

bool moves(const CommandRange& range) {
  constexpr double still = 1e-6;  // rad or m
  return range.high - range.low > still;
}

/// "20, -45 degrees".
std::string in_words(const std::vector<double>& command, const Experiment& experiment) {
  if (experiment.slides(0)) return fmt::format("{:.3g} m", fmt::join(command, ", "));
  std::vector<double> degrees;
  for (const double angle : command) degrees.push_back(std::round(angle * 180 / std::numbers::pi) + 0.0);
  return fmt::format("{:.0f} degrees", fmt::join(degrees, ", "));
}

Run commanded(const Experiment& experiment, const std::vector<std::vector<double>>& commands,
              const OperatingEnvelope& so_far) {
  constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
  Run run{"proposed", Control::force, commands.front(), {}};
  run.device = experiment.device;
  run.by_weights = true;
  const double across = experiment.has_links() ? unseen : 0;
  for (const std::vector<double>& command : commands)
    run.readings.push_back({static_cast<double>(run.readings.size()) * so_far.sampling_interval,
                            {unseen, across, 0, 0},
                            command,
                            so_far.covariates});
  return run;
}

/// Nine poses in which every two joints meet at all of their low, middle and high commands (an orthogonal
/// array of strength two, for up to four joints).
std::vector<CandidateRun> poses(const Experiment& experiment, const std::vector<CommandRange>& joints,
                                const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  for (std::size_t i = 0; i < 9; ++i) {
    std::vector<double> pose;
    for (std::size_t j = 0; j < joints.size(); ++j)
      pose.push_back(joints[j].at(static_cast<double>((i + j * (i / 3)) % 3) / 2));
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const CandidateRun& one) { return one.run.rest == pose; });
    if (!known) all.push_back({"hold " + in_words(pose, experiment), commanded(experiment, {pose}, so_far)});
  }
  return all;
}

/// One joint goes from its lowest to its highest command and back, the others stay in the middle.
std::vector<CandidateRun> sweeps(const Experiment& experiment, const std::vector<CommandRange>& joints,
                                 const OperatingEnvelope& so_far) {
  constexpr int steps = 20;
  std::vector<CandidateRun> all;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (!moves(joints[j])) continue;
    std::vector<std::vector<double>> commands;
    for (int i = 0; i <= 2 * steps; ++i) {
      commands.emplace_back();
      for (const CommandRange& one : joints) commands.back().push_back(one.at(0.5));
      commands.back()[j] = joints[j].at(static_cast<double>(std::min(i, 2 * steps - i)) / steps);
    }
    all.push_back({fmt::format("sweep joint {} slowly from {} to {} and back", j + 1,
                               in_words({joints[j].low}, experiment), in_words({joints[j].high}, experiment)),
                   commanded(experiment, commands, so_far)});
  }
  return all;
}

/// The same with a weight at the end point; nothing where none can be hung, or borne.
std::optional<CandidateRun> with_weight(const Experiment& experiment, CandidateRun one,
                                        const OperatingEnvelope& so_far) {
  const Vector2 down = experiment.bench.down();
  const std::optional<Vector2> load =
      bearable_load(experiment, {Control::force, one.run.rest, ""}, down, so_far);
  if (!load) return std::nullopt;
  const double newtons = std::stod(fmt::format("{:.2g}", load->norm()));
  for (Reading& reading : one.run.readings)
    reading[column_Fx] = newtons * down.x(), reading[column_Fy] = newtons * down.y();
  one.description += fmt::format(", with {:.2g} N hung at the end point", newtons);
  return one;
}

}  // namespace

std::vector<CandidateRun> commanded_runs(const Experiment& experiment, const OperatingEnvelope& so_far) {
  std::vector<CandidateRun> all;
  if (std::none_of(experiment.runs.begin(), experiment.runs.end(), std::mem_fn(&Run::commands_joints)))
    return all;
  const std::vector<CommandRange> joints = command_ranges(experiment);
  const bool weighs = experiment.bench.plane != Bench::Plane::horizontal;
  for (const auto& some : {poses(experiment, joints, so_far), sweeps(experiment, joints, so_far)})
    for (const CandidateRun& one : some) {
      all.push_back(one);
      if (!weighs) continue;
      if (std::optional<CandidateRun> loaded = with_weight(experiment, one, so_far))
        all.push_back(std::move(*loaded));
    }
  return all;
}

}  // namespace plumbline::diagnose
