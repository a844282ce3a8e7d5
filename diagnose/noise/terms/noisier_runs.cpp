#include <cmath>

#include "diagnose/noise/term.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// A run in which a sensor is noisier than in the others.
class NoisierRuns final : public NoiseTerm {
  [[nodiscard]] std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const override {
    std::optional<NoiseProposal> best;
    const std::size_t runs = evidence.experiment.runs.size();
    for (const Sensor sensor : all_sensors)
      for (std::size_t r = 0; runs > 1 && r < runs; ++r) {
        if (evidence.shape.is_noisier(r, sensor)) continue;
        Squares own, others;
        for (const Series& series : evidence.measurements.series()) {
          if (series.channel.sensor() != sensor) continue;
          for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            (series.run == r ? own : others).add(evidence.standardised(row), evidence.weight(row));
          }
        }
        constexpr double fewest = 6;
        if (own.count < fewest || others.count < fewest || own.variance() <= others.variance()) continue;
        const double log_prior =
            std::log(priors::uneven_noise / static_cast<double>(runs)) - std::log(own.count) / 2;
        const double log_odds = gain_of_two(own, others) + log_prior;
        if (log_odds <= (best ? best->log_odds : 0)) continue;
        const double factor = std::sqrt(own.variance() / others.variance());
        best = {log_odds, log_prior, [&evidence, sensor, r, factor](NoiseShape& shape) {
                  for (const Series& series : evidence.measurements.series())
                    if (series.channel.sensor() == sensor && series.run == r)
                      shape.relative.segment(static_cast<Eigen::Index>(series.first),
                                             static_cast<Eigen::Index>(series.readings.size())) *= factor;
                  shape.noisier.push_back(
                      {r, sensor, 0, evidence.experiment.runs[r].readings.size() - 1, true, factor});
                }};
      }
    return best;
  }
};

}  // namespace

std::unique_ptr<NoiseTerm> noisier_runs() {
  return std::make_unique<NoisierRuns>();
}

}  // namespace plumbline::diagnose
