#include <cmath>

#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// A smooth function of the command in one channel, whichever, of any size; nothing is left in the others.
class OneChannel final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    const std::vector<double>& prior = left.likelihood.priors().log_amplitude_outside;
    std::vector<double> gain;
    for (const ChannelLook& one : left.look.channels)
      gain.push_back(log_sum(sum(one.log_by_amplitude, prior)) - one.log_by_amplitude.front());
    const double any = log_sum(gain);
    OutsideFit fit{left.look.log_by_amplitude.front() + any - std::log(static_cast<double>(gain.size()))};
    for (std::size_t c = 0; c < gain.size(); ++c) {
      const ChannelLook& one = left.look.channels[c];
      fit.discrepancy += std::exp(gain[c] - any) * expected(one.log_by_amplitude, prior, one.discrepancy) /
                         static_cast<double>(gain.size());
    }
    return fit;
  }
};

}  // namespace

std::unique_ptr<OutsideCause> one_channel() {
  return std::make_unique<OneChannel>();
}

}  // namespace plumbline::diagnose
