#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// Every reading of one channel, whichever, is off by an amount of its own: a discrepancy that no function of
/// the command describes. The scale of that channel's noise is one or larger, any order of magnitude as
/// probable.
class Scatter final : public OutsideCause {
  [[nodiscard]] bool stands_beside() const override { return true; }

  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    std::vector<double> gain, size;
    for (std::size_t c = 0; c < left.look.channels.size(); ++c) {
      const ChannelLook& look = left.look.channels[c];
      const ScaleGrid& grid = left.likelihood.blocks()[c].scales();
      VectorXd log_p = look.log_by_scale;
      const auto larger =
          std::count_if(grid.scale.begin(), grid.scale.end(), [](double s) { return s >= 1; });
      for (Eigen::Index k = 0; k < log_p.size(); ++k)
        log_p(k) +=
            grid.scale[static_cast<std::size_t>(k)] < 1
                ? -std::numeric_limits<double>::infinity()
                : -std::log(static_cast<double>(larger)) - grid.log_prior[static_cast<std::size_t>(k)];
      const double all = log_sum(log_p);
      double mean = 0;
      for (Eigen::Index k = 0; k < log_p.size(); ++k)
        mean += std::exp(log_p(k) - all) *
                std::sqrt(std::max(0.0, std::pow(grid.scale[static_cast<std::size_t>(k)], 2) - 1));
      gain.push_back(all - look.log_by_amplitude.front());
      size.push_back(mean / left.likelihood.nominal_size());
    }
    const double any = log_sum(gain);
    OutsideFit fit{left.look.log_by_amplitude.front() + any - std::log(static_cast<double>(gain.size()))};
    for (std::size_t c = 0; c < gain.size(); ++c) fit.size += std::exp(gain[c] - any) * size[c];
    return fit;
  }
};

}  // namespace

std::unique_ptr<OutsideCause> scatter() {
  return std::make_unique<Scatter>();
}

}  // namespace plumbline::diagnose
