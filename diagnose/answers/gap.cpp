#include "diagnose/answers/gap.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

std::vector<Outlier> outliers(const Study& study, const NoiseEstimate& noise, const VectorXd& left) {
  std::vector<Outlier> all;
  const VectorXd sigma = noise.sigma(study.measurements());
  for (const Series& series : study.measurements().series()) {
    const Run& run = study.experiment().runs[series.run];
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      if (!noise.shape.outlier[series.first + i]) continue;
      const auto row = static_cast<Eigen::Index>(series.first + i);
      constexpr std::size_t last = 2;  // readings
      all.push_back({run.id, run.first_taken(series.readings[i]), series.channel, left(row) / sigma(row),
                     i < last || i + last >= series.readings.size()});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Outlier& a, const Outlier& b) {
    return std::abs(a.deviation) > std::abs(b.deviation);
  });
  return all;
}

}  // namespace

GapAnswer describe_gap(const Study& study, const NoiseEstimate& noise, const VectorXd& left) {
  GapAnswer gap;
  const VectorXd residual = study.nominal_residual(), sigma = noise.sigma(study.measurements());
  double sum = 0, count = 0;
  for (const Block& block : study.measurements().blocks()) {
    double squares = 0, values = 0;
    for (Eigen::Index i = block.first; i < block.first + block.count; ++i) {
      if (noise.shape.outlier[static_cast<std::size_t>(i)]) continue;
      squares += std::pow(residual(i) * study.measurements().sigma()(i), 2), values += 1;
      sum += std::pow(residual(i) / sigma(i), 2), count += 1;
    }
    gap.rms[block.channel] = values > 0 ? std::sqrt(squares / values) : 0;
  }
  gap.chi2_per_value = count > 0 ? sum / count : 1;
  gap.outliers = outliers(study, noise, left);
  const std::vector<Run>& runs = study.experiment().runs;
  for (const NoisierSegment& one : noise.shape.noisier) {
    const Run& run = runs[one.run];
    gap.noisier.push_back(
        {run.id, one.sensor, run.first_taken(one.from), run.last_taken(one.to), one.whole_run, one.factor});
  }
  for (const Interference& one : noise.shape.interference)
    for (const auto& [channel, rms] : one.rms)
      gap.interference.push_back({runs[one.run].id, channel, one.period, rms});
  for (const Run& run : runs) {
    if (run.weights_inferred) gap.taken_for_weights.push_back(run.id);
    if (!run.continued_by.empty()) gap.continued.push_back({run.id, run.continued_by});
    for (std::size_t c = 0; c < run.interpolated.size(); ++c)
      if (run.interpolated[c] > 0)
        gap.interpolated.push_back({run.id, study.experiment().covariates[c], run.interpolated[c],
                                    run.last_taken(run.readings.size() - 1) + 1});
    if (run.is_thinned()) gap.thinned.push_back({run.id, run.readings.size(), run.groups.first.back()});
    if (run.branch) gap.other_branch.push_back({run.id, run.first_taken(run.branch->first())});
  }
  return gap;
}

}  // namespace plumbline::diagnose
