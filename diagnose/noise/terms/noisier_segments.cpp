#include <cmath>

#include "diagnose/noise/term.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t fewest_of_segment = 6;  // readings of a segment, and beside it

/// Squares of a sensor in a run up to each reading.
std::vector<Squares> cumulated(const NoiseEvidence& evidence, std::size_t run, Sensor sensor) {
  std::vector<Squares> each(evidence.experiment.runs[run].readings.size() + 1);
  for (const Series& series : evidence.measurements.series()) {
    if (series.run != run || series.channel.sensor() != sensor) continue;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      each[series.readings[i] + 1].add(evidence.standardised(row), evidence.weight(row));
    }
  }
  for (std::size_t i = 1; i < each.size(); ++i)
    each[i].sum += each[i - 1].sum, each[i].count += each[i - 1].count;
  return each;
}

/// A segment of a run in which a sensor is noisier than elsewhere, in this run and in the others.
class NoisierSegments final : public NoiseTerm {
  [[nodiscard]] std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const override {
    std::optional<NoiseProposal> best;
    for (const Sensor sensor : all_sensors) {
      Squares all;
      for (const Series& series : evidence.measurements.series())
        for (std::size_t i = series.first;
             series.channel.sensor() == sensor && i < series.first + series.readings.size(); ++i)
          all.add(evidence.standardised(static_cast<Eigen::Index>(i)),
                  evidence.weight(static_cast<Eigen::Index>(i)));
      for (std::size_t r = 0; r < evidence.experiment.runs.size(); ++r)
        if (!evidence.shape.is_noisier(r, sensor)) look_at(evidence, sensor, r, all, best);
    }
    return best;
  }

  /// \param all  squares of the sensor in all runs
  static void look_at(const NoiseEvidence& evidence, Sensor sensor, std::size_t r, const Squares& all,
                      std::optional<NoiseProposal>& best) {
    const std::vector<Squares> until = cumulated(evidence, r, sensor);
    const std::size_t readings = until.size() - 1;
    if (readings < 2 * fewest_of_segment || !(until.back().sum > 0)) return;
    const auto runs = static_cast<double>(evidence.experiment.runs.size());
    const double log_prior =
        std::log(priors::uneven_noise / runs) - 2 * std::log(static_cast<double>(readings));
    for (std::size_t from = 0; from + fewest_of_segment <= readings; ++from)
      for (std::size_t to = from + fewest_of_segment; to <= readings; ++to) {
        const Squares inside{until[to].sum - until[from].sum, until[to].count - until[from].count},
            outside{all.sum - inside.sum, all.count - inside.count};
        if (inside.count < fewest_of_segment || outside.count < fewest_of_segment ||
            inside.variance() <= outside.variance())
          continue;
        const double cost = log_prior - std::log(inside.count) / 2,
                     log_odds = gain_of_two(inside, outside) + cost;
        if (log_odds <= (best ? best->log_odds : 0)) continue;
        const double factor = std::sqrt(inside.variance() / outside.variance());
        best = {log_odds, cost, [&evidence, sensor, r, from, to, factor](NoiseShape& shape) {
                  for (const Series& series : evidence.measurements.series()) {
                    if (series.channel.sensor() != sensor || series.run != r) continue;
                    for (std::size_t i = 0; i < series.readings.size(); ++i)
                      if (series.readings[i] >= from && series.readings[i] < to)
                        shape.relative(static_cast<Eigen::Index>(series.first + i)) *= factor;
                  }
                  shape.noisier.push_back({r, sensor, from, to - 1, false, factor});
                }};
      }
  }
};

}  // namespace

std::unique_ptr<NoiseTerm> noisier_segments() {
  return std::make_unique<NoisierSegments>();
}

}  // namespace plumbline::diagnose
