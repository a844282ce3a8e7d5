#include "diagnose/next/data.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose::next {

Data::Data(const Experiment& experiment) {
  struct Gathered {
    Channel channel;
    std::vector<Sequence> sequences;
    std::vector<std::size_t> run, reading;
    std::vector<double> value, sigma, time;
  };
  std::vector<Gathered> all;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      auto place =
          std::find_if(all.begin(), all.end(), [&](const Gathered& one) { return one.channel == channel; });
      if (place == all.end()) place = all.insert(all.end(), {channel, {}, {}, {}, {}, {}, {}});
      const auto first = static_cast<Eigen::Index>(place->value.size());
      for (std::size_t i = 0; i < run.readings.size(); ++i) {
        const double value = channel.of(run.readings[i]);
        if (!std::isfinite(value)) continue;
        place->run.push_back(r);
        place->reading.push_back(i);
        place->value.push_back(value);
        place->sigma.push_back(channel.sigma(experiment.noise) * run.noise_of_group());
        place->time.push_back(run.readings[i].t);
      }
      const auto count = static_cast<Eigen::Index>(place->value.size()) - first;
      if (count > 0) place->sequences.push_back({r, first, count});
    }
  }
  const auto vector = [](const std::vector<double>& v) {
    return VectorXd(Eigen::Map<const VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
  };
  for (Gathered& one : all)
    if (!one.value.empty())
      blocks_.push_back({one.channel, std::move(one.sequences), std::move(one.run), std::move(one.reading),
                         vector(one.value), vector(one.sigma), vector(one.time)});
}

Eigen::Index Data::size() const {
  Eigen::Index sum = 0;
  for (const Block& block : blocks_) sum += block.size();
  return sum;
}

std::vector<VectorXd> Data::in_sigmas(const std::vector<Trace>& traces) const {
  std::vector<VectorXd> all;
  for (const Block& block : blocks_) {
    VectorXd v(block.size());
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      v(i) = traces[block.run[k]](static_cast<Eigen::Index>(block.reading[k]), column_of(block.channel)) /
             block.sigma(i);
    }
    all.push_back(std::move(v));
  }
  return all;
}

std::vector<VectorXd> Data::residual(const Prediction& predicted) const {
  std::vector<VectorXd> all = in_sigmas(predicted.runs);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    all[b] = (blocks_[b].value.array() / blocks_[b].sigma.array()).matrix() - all[b];
  return all;
}

}  // namespace plumbline::diagnose::next
