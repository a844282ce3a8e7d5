#include "diagnose/bench/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;

}  // namespace

std::vector<double> Reading::angles(std::size_t joints) const {
  std::vector<double> all;
  for (std::size_t j = 0; j < joints; ++j) all.push_back(Channel(Name::q, j).of(*this));
  return all;
}

Reading between(const Reading& from, const Reading& to, double share) {
  const auto all = [share](std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += share * (b[i] - a[i]);
    return a;
  };
  Reading one{
      from.t + share * (to.t - from.t), {}, all(from.rest, to.rest), all(from.covariates, to.covariates)};
  for (const std::ptrdiff_t column : {column_x, column_y, column_Fx, column_Fy})
    one[column] = from[column] + share * (to[column] - from[column]);
  one.wrench = from.wrench.size() == to.wrench.size() ? all(from.wrench, to.wrench) : to.wrench;
  return one;
}

std::size_t Branch::first() const {
  return static_cast<std::size_t>(std::find(differs.begin(), differs.end(), true) - differs.begin());
}

std::vector<Channel> Run::imposed() const {
  return holds_end_point() ? end().place : end().load;
}

std::vector<Channel> Run::answering() const {
  return holds_end_point() ? end().load : end().place;
}

Eigen::Vector2d Run::imposed_at(const Reading& reading) const {
  return holds_end_point() ? Eigen::Vector2d(reading[column_x], reading[column_y])
                           : Eigen::Vector2d(reading[column_Fx], reading[column_Fy]);
}

Eigen::Vector2d Run::command(const Reading& reading) const {
  Eigen::Vector2d by_loads(0, 0);
  for (const LoadChannel& load : loads) by_loads += reading.covariates[load.covariate] * load.moves;
  if (reading.rest.empty()) return imposed_at(reading) + by_loads;
  double theta = 0;
  Eigen::Vector2d moved(0, 0);
  for (const double angle : reading.rest) {
    theta += angle;
    moved += Eigen::Vector2d(std::cos(theta) - 1, std::sin(theta));
  }
  return moved / static_cast<double>(reading.rest.size()) + by_loads;
}

std::optional<Reading> Run::before_first() const {
  if (!begins_moving || readings.empty()) return {};
  constexpr double share = 1.0 / 3;  // of the farthest command: friction has slipped by then
  const auto away = [&](const Reading& one) { return (command(one) - command(readings.front())).norm(); };
  const Reading &first = readings.front(),
                &far = *std::max_element(readings.begin(), readings.end(),
                                         [&](const Reading&a, const Reading&b) { return away(a) < away(b); });
  return between(first, far, -share);
}

std::vector<bool> Run::turning_points() const {
  std::vector<bool> turns(readings.size(), false);
  std::optional<std::size_t> before;  // the last reading with a command
  Eigen::Vector2d last_step(0, 0);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!command(readings[i]).allFinite()) continue;
    if (before) {
      const Eigen::Vector2d step = command(readings[i]) - command(readings[*before]);
      turns[*before] = step.dot(last_step) < 0;
      if (step != Eigen::Vector2d(0, 0)) last_step = step;
    }
    before = i;
  }
  return turns;
}

bool Run::turns_back() const {
  const std::vector<bool> turns = turning_points();
  return std::find(turns.begin(), turns.end(), true) != turns.end();
}

bool Run::counts_readings() const {
  for (std::size_t i = 1; i < readings.size(); ++i)
    if (readings[i].t != readings[i - 1].t + 1) return false;
  return true;
}

double Run::sampling_interval() const {
  std::vector<double> pauses;
  for (std::size_t i = 1; i < readings.size(); ++i)
    if (const double pause = readings[i].t - readings[i - 1].t; pause > 0) pauses.push_back(pause);
  return pauses.empty() ? 0 : median(std::move(pauses));
}

std::vector<Channel> Run::measurable() const {
  using Of = ChannelKind::Of;
  std::vector<Channel> channels = answering();
  const std::size_t joints = rest.size();
  const auto add_joints = [&](Of of) {
    for (const ChannelKind& kind : channel_kinds)
      for (std::size_t j = 0; kind.of == of && kind.index == ChannelKind::Index::joint && j < joints; ++j)
        channels.emplace_back(kind.name, j, joints);
  };
  if (end().joint_angles) add_joints(Of::joints);
  for (const Channel& channel : end().second) channels.push_back(channel);
  for (std::size_t p = 0; p < points; ++p)
    for (const Name name : {Name::place, Name::turn})
      for (std::size_t axis = 0; axis < 3; ++axis) channels.emplace_back(name, 3 * p + axis, joints);
  if (end().joint_angles) add_joints(end().joints);
  channels.insert(channels.end(), of_sensors.begin(), of_sensors.end());
  return channels;
}

std::vector<Channel> ArmBench::sensor_channels(std::size_t joints) const {
  std::vector<Channel> channels;
  for (std::size_t s = 0; s < sensors.size(); ++s)
    for (std::size_t i = 0; i < sensors[s].kind->numbers; ++i)
      channels.push_back(sensors[s].channel(s, i, joints, points.size()));
  return channels;
}

std::vector<Channel> Run::measured() const {
  const std::size_t answers = answering().size();
  const auto is_planned = [&](const Channel& one) {
    return std::find(planned.begin(), planned.end(), one) != planned.end();
  };
  std::vector<Channel> channels;
  for (const Channel& channel : measurable())
    if (channels.size() < answers || is_planned(channel) ||
        std::any_of(readings.begin(), readings.end(),
                    [&](const Reading& one) { return std::isfinite(channel.of(one)); }))
      channels.push_back(channel);
  return channels;
}

bool Run::reads_angles() const {
  return std::ranges::any_of(readings, [&](const Reading& one) {
    return std::ranges::any_of(one.angles(rest.size()), [](double q) { return std::isfinite(q); });
  });
}

std::size_t Run::first_taken(std::size_t reading) const {
  return groups.first.empty() ? reading : groups.first[reading];
}

std::size_t Run::last_taken(std::size_t reading) const {
  return groups.first.empty() ? reading : groups.first[reading + 1] - 1;
}

double Run::noise_of_group() const {
  // The variance of the median of m normal values is pi / (2 m) of theirs, for large m.
  return groups.size == 1 ? 1 : std::sqrt(std::numbers::pi / (2 * static_cast<double>(groups.size)));
}

}  // namespace plumbline::diagnose
