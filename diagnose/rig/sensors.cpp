#include "diagnose/rig/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace plumbline::diagnose {
namespace {

/// The values that are known, and their times.
struct Signal {
  std::vector<double> t, value;

  [[nodiscard]] std::size_t size() const { return t.size(); }

  /// The value at a time before that of some value, by its number.
  [[nodiscard]] double before(double time, std::size_t last) const {
    const auto end = t.begin() + static_cast<std::ptrdiff_t>(last);
    const auto next = static_cast<std::size_t>(std::lower_bound(t.begin(), end, time) - t.begin());
    if (next == 0) return value.front();
    const double way = t[next] - t[next - 1];
    if (!(way > 0)) return value[next];
    const double share = std::clamp((time - t[next - 1]) / way, 0.0, 1.0);
    return value[next - 1] + share * (value[next] - value[next - 1]);
  }

  void delay(double by) {
    const Signal prompt = *this;
    for (std::size_t i = 0; i < size(); ++i) value[i] = prompt.before(t[i] - by, i);
  }

  /// By a first-order lag: the exact response to a value that changes linearly.
  void follow(double constant) {
    double led = value.front(), at = led;
    for (std::size_t i = 1; i < size(); ++i) {
      const double dt = t[i] - t[i - 1], now = value[i];
      if (dt > 0) {
        const double behind = (now - led) / dt * constant;
        at = now - behind + std::exp(-dt / constant) * (at - led + behind);
      }
      led = now;
      value[i] = at;
    }
  }
};

/// Whether two channels are beside each other: those of joints, axes, or both numbers of one sensor.
bool are_neighbours(const Channel& a, const Channel& b) {
  const auto of_one_sensor = [&] {
    return a.kind().index != ChannelKind::Index::sensor || a.joint / 2 == b.joint / 2;
  };
  return std::abs(a.column - b.column) == 1 && a.sensor() == b.sensor() && a.kind().index == b.kind().index &&
         of_one_sensor();
}

/// The time of what comes before the first reading of a run that begins moving, and the value there of a
/// channel that goes on as it begins.
std::optional<std::pair<double, double>> start_of(const Run& run, const Eigen::ArrayXd& values) {
  const std::optional<Reading> before = run.before_first();
  if (!before || values.size() < 2) return {};
  const double first = run.readings[0].t, way = run.readings[1].t - first;
  if (!(way > 0) || !values.head<2>().isFinite().all()) return {};
  return std::pair{before->t, values(0) + (before->t - first) / way * (values(1) - values(0))};
}

Eigen::ArrayXd responded_in(const Run& run, const Response& how, const Eigen::ArrayXd& t,
                            const Eigen::ArrayXd& values) {
  const auto start = start_of(run, values);
  if (!start) return responded(how, t, values);
  Eigen::ArrayXd times(t.size() + 1), all(t.size() + 1);
  times << start->first, t;
  all << start->second, values;
  return responded(how, times, all).tail(t.size());
}

}  // namespace

Eigen::ArrayXd responded(const Response& how, const Eigen::ArrayXd& t, const Eigen::ArrayXd& values) {
  Signal known;
  std::vector<Eigen::Index> place;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values(i))) continue;
    known.t.push_back(t(i));
    known.value.push_back(values(i));
    place.push_back(i);
  }
  if (place.empty()) return values;
  if (how.delay > 0) known.delay(how.delay);
  if (how.lag > 0) known.follow(how.lag);
  Signal creeps = known;
  if (how.creep > 0) creeps.follow(how.creep_time);
  Eigen::ArrayXd shown = values;
  for (std::size_t i = 0; i < place.size(); ++i)
    shown(place[i]) = std::clamp(known.value[i] + how.creep * creeps.value[i], -how.limit, how.limit);
  return shown;
}

Trace Sensors::shown(const Run& run, Trace trace) const {
  if (are_exact()) return trace;
  Eigen::ArrayXd t(trace.rows());
  for (Eigen::Index r = 0; r < t.size(); ++r) t(r) = run.readings[static_cast<std::size_t>(r)].t;
  const Trace stands = trace;
  const std::vector<Channel> measured = run.measured();
  for (const Channel& channel : measured) {
    auto shown = trace.col(channel.column);
    if (const auto found = errors.find({channel.name, channel.joint}); found != errors.end()) {
      const SensorError& own = found->second;
      shown = (1 + own.gain) * shown + own.zero + own.drift * t;
      for (const Channel& other : measured)
        if (own.neighbours != 0 && are_neighbours(channel, other))
          shown += own.neighbours * stands.col(other.column);
    }
    if (const Response how = response(channel.name); !how.is_prompt())
      shown = responded_in(run, how, t, Eigen::ArrayXd(shown));
  }
  return trace;
}

}  // namespace plumbline::diagnose
