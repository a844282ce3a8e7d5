#include <cmath>

#include "diagnose/noise/term.hpp"

namespace plumbline::diagnose {

std::vector<std::unique_ptr<NoiseTerm>> noise_terms() {
  std::vector<std::unique_ptr<NoiseTerm>> all;
  for (const auto& make :
       {quantisation, proportional_noise, noisier_runs, noisier_segments, periodic_interference})
    all.push_back(make());
  return all;
}

double gain_of_two(const Squares& one, const Squares& other) {
  if (!(one.sum > 0) || !(other.sum > 0)) return 0;
  const double pooled = (one.sum + other.sum) / (one.count + other.count);
  return (one.count * std::log(pooled / one.variance()) + other.count * std::log(pooled / other.variance())) /
         2;
}

}  // namespace plumbline::diagnose
