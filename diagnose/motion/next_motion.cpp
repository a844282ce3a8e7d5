#include "diagnose/motion/next_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {
namespace {

/// A command over time, from zero.
struct Course {
  std::string words;
  std::function<double(double)> at;
};

std::vector<Course> courses(double size) {
  std::vector<Course> all;
  for (const double share : {1.0, 0.3}) {
    const double a = share * size;
    for (const double hertz : {0.1, 0.3, 1.0, 3.0})
      all.push_back({fmt::format("a sine of {:.2g} rad at {:g} Hz", a, hertz),
                     [a, hertz](double t) { return a * std::sin(2 * std::numbers::pi * hertz * t); }});
    all.push_back({fmt::format("a step of {:.2g} rad", a), [a](double t) { return t < 0.5 ? 0 : a; }});
    all.push_back({fmt::format("a sweep of {:.2g} rad from 0 to 5 Hz", a),
                   [a](double t) { return a * std::sin(std::numbers::pi * 0.5 * t * t); }});
    all.push_back({fmt::format("a ramp to {:.2g} rad in 8 s, and back in 2 s", a),
                   [a](double t) { return t < 8 ? a * t / 8 : a * std::max(0.0, 1 - (t - 8) / 2); }});
  }
  return all;
}

/// Ten seconds at 100 Hz, by the servo of a log, with its load or without.
MotionLog log_of(const MotionLog& like, double supply, const Course& course, bool loaded) {
  MotionLog log;
  log.encoder = like.encoder, log.gain = like.gain;
  if (loaded) log.inertia = like.inertia, log.gravity = like.gravity;
  for (int k = 0; k < 1000; ++k) {
    log.time.push_back(0.01 * k);
    log.command.push_back(course.at(log.time.back()));
  }
  log.supply.assign(log.time.size(), supply);
  log.powered.assign(log.time.size(), true);
  return log;
}

double apart_in(const MotionLog& log, const Drive<double>& one, const Drive<double>& other) {
  const Segment whole{0, 0, log.time.size()};
  const std::vector<double> a = angles_of(one, log, whole, 0.0, 0.0),
                            b = angles_of(other, log, whole, 0.0, 0.0);
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

std::optional<NextMotion> next_motion(const Bench& bench, const Drive<double>& one,
                                      const Drive<double>& other) {
  double size = 0;
  for (const MotionLog& log : bench.logs)
    for (const double command : log.command) size = std::max(size, std::abs(command));
  const double supply = Sizes(bench.logs).supply;
  std::optional<NextMotion> best;
  // A rotor alone moves by an equation where it has an inertia, and no gear between it and nothing.
  const auto may_be_bare = [](const Drive<double>& drive) {
    return drive[Term::armature] > 0 && !drive.gives_way();
  };
  std::set<double> gains;
  for (const MotionLog& log : bench.logs) {
    if (!gains.insert(log.gain).second) continue;
    for (const bool loaded : {true, false})
      for (const Course& course : courses(size)) {
        if (!loaded && !(may_be_bare(one) && may_be_bare(other))) continue;
        const double apart = apart_in(log_of(log, supply, course, loaded), one, other);
        if (apart > (best ? best->apart : bench.sigma))
          best = {course.words + (loaded ? "" : " without the load"), log.gain, apart};
      }
  }
  return best;
}

}  // namespace plumbline::motion
