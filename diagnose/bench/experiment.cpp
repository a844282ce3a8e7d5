#include "diagnose/bench/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;

/// Where the end point is, or the joint that is alone.
std::vector<Channel> place_channels(Alone alone) {
  if (alone == Alone::turns) return {{Name::angle}};
  return alone == Alone::slides ? std::vector<Channel>{{Name::x}}
                                : std::vector<Channel>{{Name::x}, {Name::y}};
}

/// What loads it.
std::vector<Channel> load_channels(Alone alone) {
  if (alone == Alone::turns) return {{Name::torque}};
  return alone == Alone::slides ? std::vector<Channel>{{Name::Fx}}
                                : std::vector<Channel>{{Name::Fx}, {Name::Fy}};
}

/// What a second sensor reads of that.
std::vector<Channel> second_load_channels(Alone alone) {
  if (alone == Alone::turns) return {{Name::torque_2}};
  return alone == Alone::slides ? std::vector<Channel>{{Name::Fx_2}}
                                : std::vector<Channel>{{Name::Fx_2}, {Name::Fy_2}};
}

}  // namespace

Reading between(const Reading& from, const Reading& to, double share) {
  const auto at = [share](double a, double b) { return a + share * (b - a); };
  Reading one{at(from.t, to.t),   at(from.x, to.x),   at(from.y, to.y),
              at(from.Fx, to.Fx), at(from.Fy, to.Fy), {},
              from.rest,          from.covariates};
  for (std::size_t i = 0; i < one.rest.size(); ++i) one.rest[i] = at(from.rest[i], to.rest[i]);
  for (std::size_t i = 0; i < one.covariates.size(); ++i)
    one.covariates[i] = at(from.covariates[i], to.covariates[i]);
  return one;
}

std::size_t Branch::first() const {
  return static_cast<std::size_t>(std::find(differs.begin(), differs.end(), true) - differs.begin());
}

std::vector<Channel> Run::imposed() const {
  return holds_end_point() ? place_channels(alone) : load_channels(alone);
}

std::vector<Channel> Run::answering() const {
  return holds_end_point() ? load_channels(alone) : place_channels(alone);
}

Eigen::Vector2d Run::imposed_at(const Reading& reading) const {
  return holds_end_point() ? Eigen::Vector2d(reading.x, reading.y) : Eigen::Vector2d(reading.Fx, reading.Fy);
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

std::vector<Channel> Run::measured() const {
  std::vector<Channel> channels = answering();
  for (std::size_t j = 0; !readings.empty() && j < readings.front().q.size(); ++j)
    channels.push_back({Name::q, j});
  if (readings.empty()) return channels;
  for (const Channel& channel : second_load_channels(alone))
    if (std::any_of(readings.begin(), readings.end(),
                    [&](const Reading& one) { return std::isfinite(channel.of(one)); }))
      channels.push_back(channel);
  const Reading& first = readings.front();
  for (std::size_t i = 0; i < first.points.size(); ++i)
    channels.push_back({i % 6 < 3 ? Name::place : Name::turn, 3 * (i / 6) + i % 3});
  for (std::size_t j = 0; j < first.torque.size(); ++j) channels.push_back({Name::drive, j});
  return channels;
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
