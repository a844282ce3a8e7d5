#include "diagnose/screening/anomalies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/chain/kinematics.hpp>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

class Look {
 public:
  Look(const Experiment& experiment, std::vector<std::string>& remarks)
      : experiment_(experiment), remarks_(remarks) {}

  void at(const Run& run) {
    run_ = &run;
    clock();
    for (const Channel& channel : run.measured()) at(channel);
    if (run.holds_end_point() && run.imposed().size() > 1) start();
  }

 private:
  template <class... Values>
  void remark(fmt::format_string<Values...> text, Values&&... values) {
    remarks_.push_back("run " + run_->id + ": " + fmt::format(text, std::forward<Values>(values)...));
  }

  void clock() {
    const std::vector<Reading>& readings = run_->readings;
    if (run_->counts_readings()) {
      remark(
          "t is 0, 1, 2, ...: a counter of the readings, not a clock, so that creep and drift cannot be "
          "identified");
      return;
    }
    constexpr double much = 20;
    const double typical = run_->sampling_interval();
    for (std::size_t i = 1; i < readings.size(); ++i)
      if (const double pause = readings[i].t - readings[i - 1].t; pause > much * typical)
        remark("a pause of {:.3g} s after reading {}; {:.3g} s is usual", pause, i, typical);
  }

  void at(const Channel& channel) {
    std::vector<double> values;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < run_->readings.size(); ++i) {
      const double value = channel.of(run_->readings[i]);
      if (!std::isnan(value)) values.push_back(value), numbers.push_back(i + 1);
    }
    if (values.empty()) return;  // a channel that the run does not measure
    if (2 * values.size() < run_->readings.size())
      remark("{} is missing in {} of {} readings", channel.label(), run_->readings.size() - values.size(),
             run_->readings.size());
    constexpr std::size_t enough = 8;
    if (values.size() < enough) return;
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    if (*lowest == *highest) {
      remark("{} is constant at {:.6g} {}", channel.label(), *lowest, channel.unit());
      return;
    }
    scatter(channel, values);
    spikes(channel, values, numbers);
  }

  /// Second differences of white noise have sqrt(6) times its standard deviation; curvature adds to that.
  void scatter(const Channel& channel, const std::vector<double>& values) {
    std::vector<double> bends;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      bends.push_back(values[i - 1] - 2 * values[i] + values[i + 1]);
    const double little = 0.2, sigma = channel.sigma(experiment_.noise);
    const double seen = median_deviation(std::move(bends)) / std::sqrt(6.0);
    if (seen < little * sigma)
      remark("{} has a noise of {:.2g} {} at most; {:.2g} is declared", channel.label(), seen, channel.unit(),
             sigma);
  }

  /// A value far from both neighbours, which are near each other and near theirs: the last condition excludes
  /// the turning point of a run.
  void spikes(const Channel& channel, const std::vector<double>& values,
              const std::vector<std::size_t>& numbers) {
    constexpr double far = 20, near = 0.1;
    const double sigma = channel.sigma(experiment_.noise);
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
      const double away = std::abs(values[i] - (values[i - 1] + values[i + 1]) / 2);
      const auto is_near = [&](std::size_t a, std::size_t b) {  // or b is beyond an end
        return b >= values.size() || std::abs(values[a] - values[b]) < near * away;
      };
      if (away > far * sigma && is_near(i - 1, i + 1) && is_near(i - 1, i - 2) && is_near(i + 1, i + 2))
        remark("{} has a lone spike of {:.4g} {} in reading {}", channel.label(), values[i], channel.unit(),
               numbers[i]);
    }
  }

  void start() {
    const Reading& first = run_->readings.front();
    const Chain<double> chain(experiment_.link_length, experiment_.joint_stiffness);
    const Point<double> end = end_point(chain, run_->rest);
    const double away = std::hypot(first[column_x] - end.x, first[column_y] - end.y),
                 length = reach(experiment_.link_length).largest;
    constexpr double far = 0.05, there = 1e-3;
    if (away > far * length)
      remark("starts {:.3g} m from the unloaded end point ({:.4g}, {:.4g}) m", away, end.x, end.y);
    if (away > there * length) return;
    constexpr double much = 20;
    for (const Channel& channel : {Channel(Channel::Name::Fx), Channel(Channel::Name::Fy)}) {
      const double force = channel.of(first);
      if (std::abs(force) > much * channel.sigma(experiment_.noise))
        remark("{} is {:.4g} N at the unloaded end point: a tare, a weight?", channel.label(), force);
    }
  }

  const Experiment& experiment_;
  std::vector<std::string>& remarks_;
  const Run* run_ = nullptr;
};

bool same_readings(const Run& a, const Run& b) {
  const auto same = [](const Reading& r, const Reading& s) {
    return std::equal(r.value.begin(), r.value.begin() + column_Fx_2, s.value.begin());
  };
  return std::equal(a.readings.begin(), a.readings.end(), b.readings.begin(), b.readings.end(), same);
}

}  // namespace

std::vector<std::string> anomalies(const Experiment& experiment) {
  std::vector<std::string> remarks;
  Look look(experiment, remarks);
  const std::vector<Run>& runs = experiment.runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    look.at(runs[r]);
    for (std::size_t s = 0; s < r; ++s)
      if (same_readings(runs[r], runs[s]))
        remarks.push_back("run " + runs[r].id + ": repeats the readings of run " + runs[s].id);
  }
  return remarks;
}

}  // namespace plumbline::diagnose
