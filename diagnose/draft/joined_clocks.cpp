#include "diagnose/draft/joined_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/files/csv_file.hpp"

namespace plumbline::diagnose {
namespace {

struct Logger {
  WrittenTable table;
  std::vector<ColumnWords> words;
  std::vector<double> times;  ///< s; empty where the file has none, or they fall
  bool places = false, loads = false;
};

Logger logger_of(const DraftFile& file, const std::vector<std::string>& joints) {
  Logger logger{written_table(file.text, file.name), {}, {}};
  for (std::size_t c = 0; c < logger.table.names.size(); ++c) {
    const std::string below = c < logger.table.units.size() ? logger.table.units[c] : "";
    const ColumnWords words = words_of(logger.table.names[c], below, joints);
    logger.words.push_back(words);
    logger.places = logger.places || is_place(words.kind);
    logger.loads = logger.loads || is_force(words.kind) || is_actuation(words.kind) ||
                   words.kind == Kind::mass || words.kind == Kind::torque;
    if (words.kind != Kind::time || !logger.times.empty() || logger.table.format.transposed) continue;
    logger.times = logger.table.numbers(c);
    const double unit = words.unit.empty() ? 1 : parse_unit(words.unit, quantity::time, "").in_si();
    for (double& time : logger.times) time *= unit;
  }
  const bool rises =
      std::is_sorted(logger.times.begin(), logger.times.end()) &&
      std::none_of(logger.times.begin(), logger.times.end(), [](double t) { return std::isnan(t); });
  if (!rises) logger.times.clear();
  return logger;
}

/// Whether one has the loads alone and the other the places.
bool complete(const Logger& a, const Logger& b) {
  return (a.places && !a.loads && b.loads && !b.places) || (a.loads && !a.places && b.places && !b.loads);
}

/// The share of the longer one's time in which both read; zero where they do not complete each other.
double time_in_common(const Logger& a, const Logger& b) {
  if (a.times.empty() || b.times.empty() || !complete(a, b)) return 0;
  const double begin = std::max(a.times.front(), b.times.front()),
               end = std::min(a.times.back(), b.times.back());
  const double longer = std::max(a.times.back() - a.times.front(), b.times.back() - b.times.front());
  return longer > 0 ? std::max(0.0, (end - begin) / longer) : 0;
}

/// The value between two readings; NaN beyond the first and the last, and beside one without a value.
double value_at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.end() || time < times.front()) return NAN;
  const auto i = static_cast<std::size_t>(after - times.begin());
  if (*after == time) return values[i];
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

/// The title with its unit, which a line of units may have.
std::string title_of(const Logger& logger, std::size_t column) {
  const std::string& below = column < logger.table.units.size() ? logger.table.units[column] : "";
  return logger.table.names[column] + (below.empty() ? "" : " [" + below + "]");
}

std::string joined(const Logger& first, const Logger& second) {
  std::vector<std::size_t> others;
  for (std::size_t c = 0; c < second.words.size(); ++c)
    if (second.words[c].kind != Kind::time && second.words[c].kind != Kind::none) others.push_back(c);
  std::string text = "t [s]";
  std::vector<std::vector<double>> own, of_second;
  for (std::size_t c = 0; c < first.words.size(); ++c) {
    if (first.words[c].kind == Kind::time) continue;
    text += "," + files::csv_field(title_of(first, c));
    own.push_back(first.table.numbers(c));
  }
  for (const std::size_t c : others) {
    text += "," + files::csv_field(title_of(second, c));
    of_second.push_back(second.table.numbers(c));
  }
  text += "\n";
  const auto field = [](double value) {
    return std::isnan(value) ? std::string(",") : fmt::format(",{:.10g}", value);
  };
  for (std::size_t i = 0; i < first.times.size(); ++i) {
    const double time = first.times[i];
    if (time < second.times.front() || time > second.times.back()) continue;
    text += fmt::format("{:.6f}", time);
    for (const auto& values : own) text += field(values[i]);
    for (const auto& values : of_second) text += field(value_at(second.times, values, time));
    text += "\n";
  }
  return text;
}

}  // namespace

std::vector<DraftFile> joined_clocks(std::vector<DraftFile> files, const std::vector<std::string>& joints,
                                     Guesses& guesses) {
  std::vector<Logger> loggers;
  for (const DraftFile& file : files) loggers.push_back(logger_of(file, joints));
  for (std::size_t a = 0; a < files.size(); ++a) {
    std::size_t best = a;
    double most = 0.5;
    bool same_times = false;  // such files are joined line by line
    for (std::size_t b = 0; b < files.size(); ++b) {
      const double common = b == a ? 0 : time_in_common(loggers[a], loggers[b]);
      same_times = same_times || (common > 0 && loggers[a].times == loggers[b].times);
      if (common > most) most = common, best = b;
    }
    if (same_times || best <= a) continue;
    guesses.push_back(
        {"files of " + files[a].name, fmt::format("joined with {}", files[best].name),
         fmt::format("one has the loads, the other the places, on one clock: values of {} between its "
                     "readings, at the times of {}",
                     files[best].name, files[a].name)});
    files[a].text = joined(loggers[a], loggers[best]);
    const auto place = static_cast<std::ptrdiff_t>(best);
    files.erase(files.begin() + place), loggers.erase(loggers.begin() + place);
  }
  return files;
}

}  // namespace plumbline::diagnose
