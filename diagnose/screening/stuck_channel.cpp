#include "diagnose/screening/stuck_channel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

struct Range {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  std::size_t count = 0;

  void add(double value) {
    if (!std::isfinite(value)) return;
    lowest = std::min(lowest, value), highest = std::max(highest, value);
    ++count;
  }
  [[nodiscard]] double width() const { return count > 0 ? highest - lowest : 0; }
};

/// The ranges of one channel in one run, over its readings.
struct Ranges {
  Range measured, predicted;
};

Ranges ranges(const Run& run, const Trace& predicted, const Channel& channel) {
  Ranges both;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const double value = channel.of(run.readings[i]);
    if (std::isnan(value)) continue;
    both.measured.add(value);
    both.predicted.add(predicted(static_cast<Eigen::Index>(i), channel.column));
  }
  return both;
}

/// The largest range that the nominal model gives to a channel of the sensor.
double widest(const Run& run, const Trace& predicted, const Channel& channel) {
  double most = 0;
  for (const Channel& other : run.measured())
    if (other.sensor() == channel.sensor())
      most = std::max(most, ranges(run, predicted, other).predicted.width());
  return most;
}

bool is_stuck(const Run& run, const Trace& predicted, const Channel& channel, const Noise& noise) {
  constexpr std::size_t enough = 8;
  constexpr double of_noise = 20, of_sensor = 0.02;
  // Contacts and ball bars hold it still.
  if (channel.sensor() == Sensor::distance) return false;
  const Ranges both = ranges(run, predicted, channel);
  return both.measured.count >= enough && both.measured.width() == 0 &&
         both.predicted.width() > of_noise * channel.sigma(noise) &&
         both.predicted.width() > of_sensor * widest(run, predicted, channel);
}

bool measures(const Run& run, const Channel& channel) {
  const std::vector<Channel> measured = run.measured();
  return std::find(measured.begin(), measured.end(), channel) != measured.end();
}

/// Where one run shows that a channel is stuck, all runs in which it is constant are listed.
std::optional<StuckChannel> stuck(const Study& study, const Channel& channel) {
  const Experiment& experiment = study.experiment();
  StuckChannel found{{}, channel, {}, 0, 0};
  bool shown = false, somewhere_moved = false;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    if (!measures(run, channel)) continue;
    const Ranges both = ranges(run, study.nominal().runs[r], channel);
    if (both.measured.width() > 0) somewhere_moved = true;
    if (both.measured.count == 0 || both.measured.width() > 0) continue;
    shown = shown || is_stuck(run, study.nominal().runs[r], channel, experiment.noise);
    found.runs.push_back(run.id);
    found.values.insert(both.measured.lowest);
    found.readings += both.measured.count;
    found.predicted_range = std::max(found.predicted_range, both.predicted.width());
  }
  if (!shown) return {};
  if (!somewhere_moved) found.runs.clear();
  return found;
}

}  // namespace

std::optional<StuckChannel> stuck_channel(const Study& study) {
  std::vector<Channel> channels;
  for (const Run& run : study.experiment().runs)
    for (const Channel& channel : run.measured())
      if (std::find(channels.begin(), channels.end(), channel) == channels.end()) channels.push_back(channel);
  for (const Channel& channel : channels)
    if (const std::optional<StuckChannel> found = stuck(study, channel)) return found;
  return {};
}

void require_no_stuck_channel(const Study& study) {
  const std::optional<StuckChannel> still = stuck_channel(study);
  if (!still) return;
  std::string where = study.experiment().name + ", ", remedy = "leave its column out";
  if (!still->runs.empty()) {
    where += fmt::format("run{} {}, ", still->runs.size() > 1 ? "s" : "", fmt::join(still->runs, ", "));
    remedy = "leave its fields empty there";
  }
  const std::string_view unit = still->channel.unit();
  const std::string values =
      still->values.size() == 1 ? fmt::format("{:.6g} {}", *still->values.begin(), unit) : "one value a run";
  throw Error(where + still->channel.label(),
              fmt::format("{} in all {} readings, while the nominal model changes by {:.3g} {}", values,
                          still->readings, still->predicted_range, unit),
              "readings that change: if nothing was measured, or the sensor is stuck, " + remedy +
                  "; if not, pass --as-is");
}

}  // namespace plumbline::diagnose
