#include "diagnose/answers/gap_answer.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/outliers.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<RougherRun> rougher_runs(const Study& study) {
  std::vector<RougherRun> rougher;
  for (const Series& series : study.measurements().series()) {
    const std::string& run = study.experiment().runs[series.run].id;
    const Sensor sensor = series.channel.sensor();
    const bool told = std::any_of(rougher.begin(), rougher.end(), [&](const RougherRun& one) {
      return one.run == run && one.sensor == sensor;
    });
    if (series.beside_runs > 1 && !told) rougher.push_back({run, sensor, series.beside_runs});
  }
  return rougher;
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
  gap.rougher = rougher_runs(study);
  for (const Run& run : study.experiment().runs) {
    if (run.weights_inferred) gap.taken_for_weights.push_back(run.id);
    if (run.side) gap.other_side.push_back({run.id, run.first_taken(run.side->first())});
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
