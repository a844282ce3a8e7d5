#include <cmath>

#include "diagnose/noise/term.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// Noise that grows with what is read, beside a part that does not: variance 1 + (ratio y / sigma)^2, the
/// same in all channels of a name.
class ProportionalNoise final : public NoiseTerm {
  [[nodiscard]] std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const override {
    std::optional<NoiseProposal> best;
    for (const ChannelKind& kind : channel_kinds)
      if (!evidence.shape.proportional.contains(kind.name)) look_at(evidence, kind.name, best);
    return best;
  }

  /// Log likelihood of the values with this ratio, the scale at its best.
  static double log_likelihood(const NoiseEvidence& evidence, const std::vector<Eigen::Index>& rows,
                               double ratio) {
    double sum = 0, count = 0, logs = 0;
    for (const Eigen::Index i : rows) {
      const double variance =
          1 + std::pow(ratio * evidence.measurements.value()(i) / evidence.measurements.sigma()(i), 2);
      sum += evidence.weight(i) * evidence.standardised(i) * evidence.standardised(i) / variance;
      logs += evidence.weight(i) * std::log(variance);
      count += evidence.weight(i);
    }
    return sum > 0 ? -(count * std::log(sum / count) + logs) / 2 : 0;
  }

  static void look_at(const NoiseEvidence& evidence, Channel::Name name, std::optional<NoiseProposal>& best) {
    std::vector<Eigen::Index> rows;
    double largest = 0;
    for (const Series& series : evidence.measurements.series())
      for (std::size_t i = series.first;
           series.channel.name == name && i < series.first + series.readings.size(); ++i) {
        rows.push_back(static_cast<Eigen::Index>(i));
        largest = std::max(largest, std::abs(evidence.measurements.value()(rows.back()) /
                                             evidence.measurements.sigma()(rows.back())));
      }
    constexpr std::size_t fewest = 12;
    if (rows.size() < fewest || !(largest > 0)) return;
    const double log_prior = std::log(priors::uneven_noise) - std::log(static_cast<double>(rows.size())) / 2;
    const double even = log_likelihood(evidence, rows, 0);
    for (double at_largest = 0.5; at_largest < 30; at_largest *= 1.3) {
      const double ratio = at_largest / largest;
      const double log_odds = log_likelihood(evidence, rows, ratio) - even + log_prior;
      if (log_odds <= (best ? best->log_odds : 0)) continue;
      best = {log_odds, log_prior, [&evidence, rows, name, ratio](NoiseShape& shape) {
                for (const Eigen::Index i : rows)
                  shape.relative(i) *= std::hypot(
                      1.0, ratio * evidence.measurements.value()(i) / evidence.measurements.sigma()(i));
                shape.proportional[name] = ratio;
              }};
    }
  }
};

}  // namespace

std::unique_ptr<NoiseTerm> proportional_noise() {
  return std::make_unique<ProportionalNoise>();
}

}  // namespace plumbline::diagnose
