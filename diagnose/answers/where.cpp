#include "diagnose/answers/where.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/discrepancy/torque_balance.hpp"

namespace plumbline::diagnose {
namespace {

/// Squared residual beyond noise of each value, in units of the noise; outliers count as noise.
VectorXd excess_of(const Study& study, const NoiseEstimate& noise) {
  VectorXd result =
      study.nominal_residual().cwiseQuotient(noise.sigma(study.measurements())).cwiseAbs2().array() - 1;
  for (std::size_t i = 0; i < noise.shape.outlier.size(); ++i)
    if (noise.shape.outlier[i]) result(static_cast<Eigen::Index>(i)) = 0;
  return result;
}

std::vector<ChannelShare> by_channel(const Measurements& measurements, const VectorXd& excess) {
  std::vector<ChannelShare> shares;
  for (const Series& series : measurements.series()) {
    auto place = std::find_if(shares.begin(), shares.end(),
                              [&](const auto& one) { return one.channel == series.channel; });
    if (place == shares.end()) place = shares.insert(shares.end(), {series.channel, 0});
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      place->share += excess(static_cast<Eigen::Index>(series.first + i));
  }
  normalise(shares);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  return shares;
}

std::vector<RunShare> by_run(const Study& study, const VectorXd& excess) {
  std::vector<RunShare> shares;
  for (const Run& run : study.experiment().runs) shares.push_back({run.id, 0});
  for (const Series& series : study.measurements().series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      shares[series.run].share += excess(static_cast<Eigen::Index>(series.first + i));
  normalise(shares);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  return shares;
}

std::vector<PathShare> along_path(const Study& study, const VectorXd& excess) {
  std::vector<PathShare> shares;
  if (study.experiment().visits_poses()) return shares;
  for (std::size_t r = 0; r < study.experiment().runs.size(); ++r) {
    const Run& run = study.experiment().runs[r];
    const std::vector<Regime> regime = regimes(run, study.nominal().runs[r]);
    std::vector<double> sum(regime.size(), 0.0);
    for (const Series& series : study.measurements().series()) {
      if (series.run != r) continue;
      for (std::size_t i = 0; i < series.readings.size(); ++i)
        sum[series.readings[i]] += excess(static_cast<Eigen::Index>(series.first + i));
    }
    for (std::size_t i = 0; i < regime.size(); ++i) {
      if (i == 0 || regime[i] != regime[i - 1])
        shares.push_back({run.id, run.first_taken(i), 0, 0, regime[i]});
      shares.back().to = run.last_taken(i);
      shares.back().share += sum[i];
    }
  }
  normalise(shares);
  return shares;
}

}  // namespace

std::string joint_evidence_words(JointEvidence evidence) {
  switch (evidence) {
    case JointEvidence::measured:
      return "of the measured torque residual";
    case JointEvidence::implied_by_fits:
      return "of the torque that the explanation adds";
    case JointEvidence::named_by_fits:
      return "probability of being named, over that of any joint";
    case JointEvidence::implied_by_law:
      break;
  }
  return "probability of being the only joint at fault";
}

Where locate(const Study& study, const NoiseEstimate& noise) {
  const VectorXd excess = excess_of(study, noise);
  return {by_channel(study.measurements(), excess), by_run(study, excess), along_path(study, excess),
          shares_by_missing_torque(study, noise), JointEvidence::measured};
}

}  // namespace plumbline::diagnose
