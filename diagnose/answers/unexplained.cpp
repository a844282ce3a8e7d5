#include "diagnose/answers/unexplained.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/answers/torque_balance.hpp"
#include "diagnose/model/regime.hpp"

namespace plumbline::diagnose {
namespace {

/// By run and reading: whether the path has turned back, by the nominal model's regimes.
std::vector<std::vector<bool>> returning(const Study& study) {
  const Experiment& experiment = study.experiment();
  std::vector<std::vector<bool>> result;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    result.emplace_back();
    for (const Regime regime : regimes(experiment.runs[r], study.nominal().runs[r]))
      result.back().push_back(regime == Regime::unloading);
  }
  return result;
}

Missing torque(const Study& study, const std::vector<std::vector<bool>>& back, std::size_t joint) {
  const std::string number = std::to_string(joint);
  Missing missing{"torque at joint " + number, "N m", "q" + number, "rad", {}, 0, 0, 0};
  const Experiment& experiment = study.experiment();
  const auto torques = missing_torques(study, experiment);
  for (const MissingTorque& one : torques[joint - 1]) {
    missing.points.push_back({one.angle, one.torque, experiment.runs[one.run].readings[one.reading].t,
                              back[one.run][one.reading]});
  }
  return missing;
}

/// The commanded channel that moves most over the runs of one control: they share it as their abscissa.
Channel abscissa(const Experiment& experiment, const Run& like) {
  const auto spread = [&](const Channel& one) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Run& run : experiment.runs) {
      if (run.control != like.control) continue;
      for (const Reading& reading : run.readings) {
        low = std::min(low, one.of(reading));
        high = std::max(high, one.of(reading));
      }
    }
    return high - low;
  };
  const auto [first, second] = like.imposed();
  return spread(second) > spread(first) ? second : first;
}

Missing channel(const Study& study, const std::vector<double>& residual,
                const std::vector<std::vector<bool>>& back, const Channel& of) {
  const auto carries = [&](const Series& series) { return series.channel == of; };
  const auto& all = study.measurements().series();
  const auto first = std::find_if(all.begin(), all.end(), carries);
  const Run& like = study.experiment().runs[first->run];
  const Channel over = abscissa(study.experiment(), like);
  Missing missing{of.label(), std::string(of.unit()), over.label(), std::string(over.unit()), {}, 0, 0, 0};
  const std::vector<bool> outlier = outliers(study.measurements(), residual);
  for (const Series& series : all) {
    const Run& run = study.experiment().runs[series.run];
    if (!carries(series) || run.control != like.control) continue;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      if (outlier[series.first + i]) continue;
      const Reading& reading = run.readings[series.readings[i]];
      missing.points.push_back({over.of(reading), series.sigmas[i] * residual[series.first + i], reading.t,
                                back[series.run][series.readings[i]]});
    }
  }
  return missing;
}

/// Takes the mean of each of twenty bins of the abscissa out of the values.
void remove_means(const std::vector<MissingPoint>& points, bool by_direction, std::vector<double>& values) {
  double low = points.front().at, high = low;
  for (const MissingPoint& point : points) low = std::min(low, point.at), high = std::max(high, point.at);
  constexpr std::size_t bins = 20;
  const auto bin = [&](const MissingPoint& point) {
    const double share = high > low ? (point.at - low) / (high - low) : 0;
    const auto place = std::min(bins - 1, static_cast<std::size_t>(share * bins));
    return 2 * place + (by_direction && point.returning ? 1 : 0);
  };
  std::vector<double> sum(2 * bins, 0.0), count(2 * bins, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    sum[bin(points[i])] += values[i], count[bin(points[i])] += 1;
  for (std::size_t i = 0; i < points.size(); ++i) values[i] -= sum[bin(points[i])] / count[bin(points[i])];
}

void remove_trend(const std::vector<MissingPoint>& points, std::vector<double>& values) {
  double mean = 0, tt = 0, tv = 0;
  for (const MissingPoint& point : points) mean += point.t / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    tt += std::pow(points[i].t - mean, 2);
    tv += (points[i].t - mean) * values[i];
  }
  for (std::size_t i = 0; i < points.size() && tt > 0; ++i) values[i] -= tv / tt * (points[i].t - mean);
}

double energy(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return sum;
}

void describe(Missing& missing) {
  missing.by_position = missing.by_direction = missing.by_time = 0;
  std::vector<double> values;
  for (const MissingPoint& point : missing.points) values.push_back(point.value);
  const double all = energy(values);
  if (!(all > 0)) return;
  std::vector<double> left = values;
  remove_means(missing.points, false, left);
  missing.by_position = 1 - energy(left) / all;
  left = values;
  remove_means(missing.points, true, left);
  missing.by_direction = 1 - energy(left) / all;
  remove_trend(missing.points, left);
  missing.by_time = 1 - energy(left) / all;
}

}  // namespace

Missing describe_missing(const Study& study, const std::vector<double>& residual, const Where& where) {
  const std::vector<std::vector<bool>> back = returning(study);
  Missing missing;
  if (where.joint_evidence == JointEvidence::measured && where.joints.front().share > 0.5)
    missing = torque(study, back, where.joints.front().joint);
  if (missing.points.empty()) missing = channel(study, residual, back, where.channels.front().channel);
  describe(missing);
  return missing;
}

}  // namespace plumbline::diagnose
