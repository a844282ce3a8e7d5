#include "diagnose/motion/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/motion/report.hpp"
#include "diagnose/motion/roll_out.hpp"
#include "support/page/chart.hpp"
#include "support/page/markup.hpp"

namespace plumbline::motion {
namespace {

using page::Chart, page::ChartPoint, page::Layer;

constexpr std::size_t logs_shown = 2;

Layer line(const char* ink, std::vector<ChartPoint> points) {
  return {Layer::Kind::line, ink, std::move(points)};
}

/// Those with the largest errors without a cause, held out first.
std::vector<const MotionLog*> worst(const Bench& bench, const Diagnosis& diagnosis) {
  const std::vector<MotionLog>& logs = bench.held_out.empty() ? bench.logs : bench.held_out;
  std::vector<std::pair<double, const MotionLog*>> sorted;
  for (const MotionLog& log : logs)
    for (const LogError& one : diagnosis.errors)
      if (one.log == log.name) sorted.emplace_back(-one.before, &log);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const MotionLog*> shown;
  for (std::size_t i = 0; i < std::min(logs_shown, sorted.size()); ++i) shown.push_back(sorted[i].second);
  return shown;
}

std::vector<ChartPoint> over_time(const MotionLog& log, const std::vector<double>& values) {
  std::vector<ChartPoint> points;
  for (std::size_t k = 0; k < values.size(); ++k) points.push_back({log.time[k], values[k]});
  return points;
}

std::vector<double> less(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}

std::string charts_of(const MotionLog& log, std::size_t number, const Diagnosis& d) {
  const std::vector<double> before = predicted(d.without, log), after = predicted(d.drive, log);
  const Chart position{fmt::format("position-{}", number),
                       "Position of " + log.name,
                       "Position as read, as predicted without a cause, and with it",
                       "t, s",
                       "position, rad",
                       {line("nominal", over_time(log, before)),
                        line("corrected", over_time(log, after)),
                        {Layer::Kind::dots, "measured", over_time(log, log.position), 0.8}}};
  const Chart error{fmt::format("error-{}", number),
                    "Error of " + log.name,
                    "Position as read less the predicted one, without a cause and with it",
                    "t, s",
                    "error, rad",
                    {line("nominal", over_time(log, less(log.position, before))),
                     line("corrected", over_time(log, less(log.position, after)))}};
  return page::drawn(position) + page::drawn(error);
}

/// Torque of friction at a constant speed, nothing passing the gear.
std::vector<ChartPoint> law_of(const Drive<double>& drive, double fastest) {
  constexpr int points = 100;
  std::vector<ChartPoint> law;
  for (int i = -points; i <= points; ++i) {
    const double v = fastest * i / points, way = v > 0 ? 1 : -1;
    law.push_back({v, way * friction_of(drive, way, v, 0.0, 1.0) + drive[Term::viscous] * v});
  }
  return law;
}

/// What the motor gives beside what moves and lifts the load, by the measured motion.
std::vector<ChartPoint> taken(const Drive<double>& drive, const MotionLog& log) {
  const InitialState begin = initial_state(log, 0);
  std::vector<ChartPoint> points;
  roll_out(
      drive, log, {0, 0, log.time.size(), log.step}, begin.q, begin.v,
      [&](std::size_t k, const Motion<double>& state, const Imposed<double>& now) {
        if (k % 5 != 0 || !now.powered) return;
        const InitialState read = initial_state(log, k);
        const Forces<double> f = forces_at(drive, now, state.acting, read.q);
        const double inertia = now.inertia * (1 + drive[Term::load_mass]) + drive[Term::armature];
        points.push_back({read.v, f.motor - drive[Term::back_emf] * read.v - f.against - inertia * read.a});
      });
  return points;
}

std::string law_chart(const Bench& bench, const Diagnosis& d, const MotionLog& log) {
  const double fastest = 2 * Sizes(bench.logs).speed;
  const Chart chart{"friction",
                    "Friction over speed",
                    "Torque that the motor gives beside what moves and lifts the load, in " + log.name +
                        ", and the law of friction without a cause and with it",
                    "speed, rad/s",
                    "torque, N m",
                    {{Layer::Kind::dots, "measured", taken(d.drive, log), 0.8},
                     line("nominal", law_of(d.without, fastest)),
                     line("corrected", law_of(d.drive, fastest))}};
  return page::drawn(chart);
}

}  // namespace

std::string as_html(const Bench& bench, const Diagnosis& diagnosis) {
  std::string body = fmt::format("<h1>{}</h1>\n<pre>{}</pre>\n", page::escaped(diagnosis.name),
                                 page::escaped(as_text(diagnosis)));
  const std::vector<const MotionLog*> shown = worst(bench, diagnosis);
  for (std::size_t i = 0; i < shown.size(); ++i)
    body +=
        fmt::format("<h2>{}</h2>\n{}", page::escaped(shown[i]->name), charts_of(*shown[i], i + 1, diagnosis));
  if (!shown.empty()) body += "<h2>Friction</h2>\n" + law_chart(bench, diagnosis, *shown.front());
  return page::document(diagnosis.name, "What a joint in motion has that its model lacks", body);
}

}  // namespace plumbline::motion
