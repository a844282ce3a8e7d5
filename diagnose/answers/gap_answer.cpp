#include "diagnose/answers/gap_answer.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

/// Where a sensor scatters more, told once of all its channels.
void tell_where_rough(const Study& study, GapAnswer& gap) {
  std::set<std::pair<std::size_t, Sensor>> told;
  for (const Series& series : study.measurements().series()) {
    const Run& run = study.experiment().runs[series.run];
    const Sensor sensor = series.channel.sensor();
    if (!told.emplace(series.run, sensor).second) continue;
    if (series.beside_runs > 1) gap.rougher.push_back({run.id, sensor, series.beside_runs});
    for (const RoughStretch& one : series.rough)
      gap.rougher_stretches.push_back(
          {run.id, sensor, run.first_taken(one.from), run.last_taken(one.to - 1), one.times});
  }
}

}  // namespace

std::vector<HummingChannel> listed(const Study& study, const std::vector<Hum>& hum) {
  std::vector<HummingChannel> channels;
  for (const Hum& one : hum) {
    const Series& series = study.measurements().series()[one.series];
    channels.push_back({study.experiment().runs[series.run].id, series.channel, one.period, one.rms()});
  }
  return channels;
}

GapAnswer ask_for_gap(const Study& study, const std::vector<double>& residual) {
  const Measurements& measurements = study.measurements();
  GapAnswer gap;
  gap.test = test_gap(measurements, residual);
  gap.present = gap.test.p_value < beliefs::gap_level;
  const std::vector<double> clean = without_outliers(measurements, residual);
  std::map<Channel, double> count;
  double sum = 0;
  for (const Series& series : measurements.series()) {
    const double scale = gap.test.noise.of(series.channel);
    for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i) {
      gap.rms[series.channel] += std::pow(series.sigmas[i - series.first] * clean[i], 2);
      count[series.channel] += 1;
      sum += std::pow(clean[i] / scale, 2);
    }
  }
  for (auto& [channel, square] : gap.rms) square = std::sqrt(square / count[channel]);
  gap.hum = listed(study, gap.test.hum);
  for (const Series& series : measurements.series())
    if (series.beside_joints > 1) gap.uneven[series.channel] = series.beside_joints;
  tell_where_rough(study, gap);
  for (const Run& run : study.experiment().runs) {
    if (run.weights_inferred) gap.taken_for_weights.push_back(run.id);
    if (run.branch) gap.other_branch.push_back({run.id, run.first_taken(run.branch->first())});
  }
  for (const Series& series : measurements.series()) {
    if (series.proportion == 0) continue;
    double& share = gap.proportional[series.channel.name];
    share = std::max(share, series.proportion * series.sigma * gap.test.noise.of(series.channel));
  }
  gap.chi2_per_value = sum / static_cast<double>(measurements.size());
  return gap;
}

}  // namespace plumbline::diagnose
