#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/noise/term.hpp"

namespace plumbline::diagnose {
namespace {

/// The largest number of which both are multiples, within a tolerance; zero where it is no larger than that.
double common_divisor(double one, double other, double tolerance) {
  while (other > tolerance) {
    const double left = std::abs(one - std::round(one / other) * other);
    one = other, other = left;
  }
  return one > 100 * tolerance ? one : 0;
}

/// The step of a display: the largest one of which all differences are multiples, to more digits than anybody
/// writes; zero where there is none.
double display_step(const Eigen::Ref<const VectorXd>& values) {
  constexpr Eigen::Index enough = 8;  // of random integers so many have no common divisor but one
  const double tolerance = 1e-9 * values.cwiseAbs().maxCoeff();
  double step = 0;
  Eigen::Index steps = 0;
  for (Eigen::Index i = 1; i < values.size(); ++i) {
    const double difference = std::abs(values(i) - values(i - 1));
    if (difference <= tolerance) continue;
    step = steps == 0 ? difference : common_divisor(step, difference, tolerance);
    ++steps;
    if (step == 0) return 0;
  }
  const Eigen::Index repeats = values.size() - 1 - steps;
  return steps >= enough || 4 * repeats >= values.size() ? step : 0;
}

/// By value: how many in a row read the same.
std::vector<double> repetitions(const Eigen::Ref<const VectorXd>& values) {
  std::vector<double> times(static_cast<std::size_t>(values.size()), 1);
  for (Eigen::Index from = 0; from < values.size();) {
    Eigen::Index to = from;
    while (to < values.size() && values(to) == values(from)) ++to;
    std::fill(times.begin() + from, times.begin() + to, static_cast<double>(to - from));
    from = to;
  }
  return times;
}

/// Variance of m equal readings of a display over that of one: they share one rounding error. Their own
/// scatter is no larger than keeps m of them within a step.
double shared_error(double step, double times) {
  constexpr double few = 4;  // as large as a step noise makes so many equal once in thirty times
  const double rounding = step * step / 12,
               scatter = times < few ? 1 : std::min(1.0, step * step / (8 * std::log(times)));
  return (scatter + rounding * times) / (scatter + rounding);
}

/// A coarse display. It stands in the readings themselves: no odds are asked for.
class Quantisation final : public NoiseTerm {
  [[nodiscard]] std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const override {
    if (evidence.shape.quantised) return std::nullopt;
    VectorXd wider = VectorXd::Ones(evidence.standardised.size());
    for (const Series& series : evidence.measurements.series()) {
      const auto first = static_cast<Eigen::Index>(series.first),
                 count = static_cast<Eigen::Index>(series.readings.size());
      const auto values = evidence.measurements.value().segment(first, count);
      const double step = display_step(values);
      const std::vector<double> times = repetitions(values);
      for (Eigen::Index i = 0; step > 0 && i < count; ++i)
        wider(first + i) = std::sqrt(shared_error(step / evidence.measurements.sigma()(first + i),
                                                  times[static_cast<std::size_t>(i)]));
    }
    if ((wider.array() == 1).all()) return std::nullopt;
    constexpr double certain = std::numeric_limits<double>::infinity();
    return NoiseProposal{certain, certain, [wider](NoiseShape& shape) {
                           shape.relative = shape.relative.cwiseProduct(wider);
                           shape.quantised = true;
                         }};
  }
};

}  // namespace

std::unique_ptr<NoiseTerm> quantisation() {
  return std::make_unique<Quantisation>();
}

}  // namespace plumbline::diagnose
