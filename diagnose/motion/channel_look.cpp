#include "diagnose/motion/channel_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::motion {
namespace {

/// A channel that is refreshed more slowly shows no motion, s.
constexpr double slowest_refresh = 0.25;

double between(const MotionLog& log, const std::vector<double>& signal, double t) {
  const auto next = std::upper_bound(log.time.begin() + 1, log.time.end() - 1, t);
  const auto k = static_cast<std::size_t>(next - log.time.begin());
  const double share = (t - log.time[k - 1]) / (log.time[k] - log.time[k - 1]);
  return signal[k - 1] + share * (signal[k] - signal[k - 1]);
}

/// What positions and commands show of a channel at a reading: the speed of a time before, or the duty by
/// the command of a time before.
double shown(Channel channel, const MotionLog& log, std::size_t k, double late) {
  if (channel == Channel::velocity) {
    constexpr double beside = 0.02;  // s
    const double t = log.time[k] - late;
    return (between(log, log.position, t + beside) - between(log, log.position, t - beside)) / (2 * beside);
  }
  // A held command is half a step older than one between its readings.
  const double half_step = k == 0 ? 0 : (log.time[k] - log.time[k - 1]) / 2;
  const double command = between(log, log.command, log.time[k] - late - half_step);
  const double duty = std::clamp(log.gain * (command - log.position[k]), -1.0, 1.0);
  return (log.powered[k] ? duty : 0) * (channel == Channel::torque ? log.supply[k] : 1);
}

/// The readings of one channel, with their logs.
struct ChannelCourse {
  const MotionLog& log;
  const std::vector<double>& read;
};

std::vector<ChannelCourse> courses_of(Channel channel, const std::vector<MotionLog>& logs) {
  std::vector<ChannelCourse> all;
  for (const MotionLog& log : logs)
    for (const ChannelReadings& one : log.beside)
      if (one.channel == channel) all.push_back({log, one.value});
  return all;
}

/// Least squares of the readings over what is shown. The begins of logs are left out, whose commands are not
/// known.
ChannelLook regression(Channel channel, const std::vector<ChannelCourse>& courses, double late) {
  constexpr double begin = 0.1;  // s
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const auto& [log, read] : courses)
    for (std::size_t k = 0; k < read.size(); ++k) {
      if (log.time[k] < log.time.front() + begin || log.time[k] > log.time.back() - begin) continue;
      const double a = shown(channel, log, k, late), b = read[k];
      ++n, x += a, y += b, xx += a * a, xy += a * b, yy += b * b;
    }
  const double of_x = xx - x * x / n, of_y = yy - y * y / n, both = xy - x * y / n;
  ChannelLook look{};
  look.channel = channel;
  look.late = late;
  if (of_x > 0 && of_y > 0) look.ratio = both / of_x, look.explained = both * both / (of_x * of_y);
  return look;
}

double mean_refresh(const std::vector<ChannelCourse>& courses) {
  double duration = 0, changes = 0;
  for (const ChannelCourse& course : courses) {
    duration += course.log.time.back() - course.log.time.front();
    for (std::size_t k = 1; k < course.read.size(); ++k) changes += course.read[k] != course.read[k - 1];
  }
  return duration / std::max(1.0, changes);
}

/// Whether no reading is negative where a twentieth of what is shown is.
bool has_no_sign(Channel channel, const std::vector<ChannelCourse>& courses) {
  double negative = 0, all = 0;
  for (const auto& [log, read] : courses) {
    if (std::any_of(read.begin(), read.end(), [](double x) { return x < 0; })) return false;
    for (std::size_t k = 0; k < read.size(); ++k) negative += shown(channel, log, k, 0) < 0, ++all;
  }
  return negative > all / 20;
}

ChannelLook look_at_channel(Channel channel, const std::vector<ChannelCourse>& courses) {
  ChannelLook best = regression(channel, courses, 0);
  for (double late = -0.02; late < 0.0605; late += 0.002)
    if (const ChannelLook one = regression(channel, courses, late); one.explained > best.explained)
      best = one;
  best.refresh = mean_refresh(courses);
  if (has_no_sign(channel, courses))
    best.left_out = "it has no sign";
  else if (best.refresh > slowest_refresh)
    best.left_out = fmt::format("it changes every {:.2g} s", best.refresh);
  return best;
}

}  // namespace

std::vector<ChannelLook> look_beside(const std::vector<MotionLog>& logs) {
  std::vector<ChannelLook> all;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto channel = static_cast<Channel>(c);
    const std::vector<ChannelCourse> courses = courses_of(channel, logs);
    if (!courses.empty()) all.push_back(look_at_channel(channel, courses));
  }
  return all;
}

}  // namespace plumbline::motion
