#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// By value of a block, one past the last value of its run; of the block where all runs are one session.
std::vector<Eigen::Index> ends_of_runs(const Measurements& measurements, const Block& block,
                                       bool one_session) {
  const auto run_of = [&](Eigen::Index value) {
    return measurements.places()[static_cast<std::size_t>(block.first + value)].run;
  };
  std::vector<Eigen::Index> end(static_cast<std::size_t>(block.count), block.count);
  for (Eigen::Index value = block.count - 2; value >= 0 && !one_session; --value)
    end[static_cast<std::size_t>(value)] =
        run_of(value) == run_of(value + 1) ? end[static_cast<std::size_t>(value + 1)] : value + 1;
  return end;
}

using RunAndReading = std::pair<std::size_t, std::size_t>;  // run and reading

/// From some reading on, an amount of its own is added to each channel or not, as probably: something
/// slipped, broke or was moved. It lasts to the end of its run, or of the session where the runs are parts of
/// one. Every reading but the first of a run is as probable.
class StepDeparture final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    // With every autocorrelation: the search leaves out those that do not matter beside its best cause.
    const std::unique_ptr<Likelihood> alone = left.likelihood.of_noise_alone();
    const bool one_session = left.likelihood.states().one_session;
    std::vector<double> gain;
    const std::map<RunAndReading, double> factor = factors(*alone, left.residual, one_session);
    for (auto step = std::next(factor.begin()); step != factor.end(); ++step)
      if (one_session || std::prev(step)->first.first == step->first.first) gain.push_back(step->second);
    if (gain.empty()) return {-std::numeric_limits<double>::infinity()};
    return {alone->look(left.residual).log_by_amplitude.front() + log_sum(gain) -
            std::log(static_cast<double>(gain.size()))};
  }

  /// By run and reading: log Bayes factor of a step that begins there.
  static std::map<RunAndReading, double> factors(const Likelihood& alone, const VectorXd& residual,
                                         bool one_session) {
    const Measurements& measurements = alone.measurements();
    const auto place_of = [&](Eigen::Index row) {
      const ReadingPlace& at = measurements.places()[static_cast<std::size_t>(row)];
      return RunAndReading(at.run, at.reading);
    };
    std::map<RunAndReading, double> factor;
    for (Eigen::Index row = 0; row < residual.size(); ++row) factor.emplace(place_of(row), 0.0);
    for (std::size_t b = 0; b < alone.blocks().size(); ++b) {
      const Block& block = measurements.blocks()[b];
      const VectorXd own =
          alone.blocks()[b].log_steps(residual.segment(block.first, block.count),
                                      ends_of_runs(measurements, block, one_session), alone.typical_size(b));
      Eigen::Index value = 0;
      for (auto& [place, total] : factor) {
        while (value < block.count && place_of(block.first + value) < place) ++value;
        const bool reaches =
            value < block.count && (one_session || place_of(block.first + value).first == place.first);
        total += log_sum({reaches ? own(value) : 0, 0.0}) - std::log(2.0);
      }
    }
    return factor;
  }
};

}  // namespace

std::unique_ptr<OutsideCause> step_departure() {
  return std::make_unique<StepDeparture>();
}

}  // namespace plumbline::diagnose
