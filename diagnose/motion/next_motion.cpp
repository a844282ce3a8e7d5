#include "diagnose/motion/next_motion.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/motion/course.hpp"
#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {
namespace {

constexpr double proposed_duration = 10, proposed_rate = 100;  // s, 1/s

std::vector<Course> courses(double size) {
  std::vector<Course> all;
  for (const double share : {1.0, 0.3}) {
    const double a = share * size;
    for (const double hertz : {0.1, 0.3, 1.0, 3.0}) all.push_back(sine(a, hertz));
    for (const Course& one : {step(a), sweep(a, 5, proposed_duration), ramp(a, proposed_duration)})
      all.push_back(one);
  }
  return all;
}

/// By the servo of a log, with its load or without.
MotionLog log_of(const MotionLog& like, double supply, const Course& course, bool loaded) {
  MotionLog log = commanded(course, proposed_duration, proposed_rate, supply);
  log.encoder = like.encoder, log.gain = like.gain;
  if (loaded) log.inertia = like.inertia, log.gravity = like.gravity;
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
