#include "diagnose/answers/unexplained.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "diagnose/discrepancy/torque_balance.hpp"

namespace plumbline::diagnose {
namespace {

/// By reading: whether what is commanded, or what the nominal model does of it, came down to it from the one
/// before; the first goes as the second does, and where it stands still it goes as before.
std::vector<bool> falling(const std::vector<double>& command) {
  std::vector<bool> result(command.size(), false);
  std::optional<bool> way;
  std::size_t untold = 0;
  for (std::size_t i = 1; i < command.size(); ++i) {
    if (!way) untold = i;
    if (command[i] != command[i - 1]) way = command[i] < command[i - 1];
    result[i] = way.value_or(false);
  }
  std::fill_n(result.begin(), std::min(untold, result.size()), way && result[untold]);
  return result;
}

/// By run: which way the nominal chain turns a joint, whose readings may scatter more than it moves.
std::vector<std::vector<bool>> falling(const Study& study, std::size_t joint) {
  std::vector<std::vector<bool>> result;
  for (const Trace& trace : study.nominal().runs) {
    const auto angle = trace.col(column_q + static_cast<Eigen::Index>(joint - 1));
    result.push_back(falling({angle.begin(), angle.end()}));
  }
  return result;
}

Missing torque(const Study& study, std::size_t joint) {
  const std::string number = std::to_string(joint);
  Missing missing{"torque at joint " + number, "N m", "q" + number, "rad", {}, 0, 0, 0};
  const Experiment& experiment = study.experiment();
  const std::vector<std::vector<bool>> down = falling(study, joint);
  const auto torques = missing_torques(study, experiment);
  for (const MissingTorque& one : torques[joint - 1]) {
    missing.points.push_back({one.angle, one.torque, experiment.runs[one.run].readings[one.reading].t,
                              down[one.run][one.reading]});
  }
  return missing;
}

/// A coordinate of the command over which a residual may be told.
struct Abscissa {
  std::string label, unit;
  std::function<double(const Reading&)> of;
};

/// The commanded channel that moves most over the runs of one control: they share it as their abscissa.
Channel moves_most(const Experiment& experiment, const Run& like) {
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
  const std::vector<Channel> imposed = like.imposed();
  return *std::max_element(imposed.begin(), imposed.end(),
                           [&](const Channel& a, const Channel& b) { return spread(a) < spread(b); });
}

/// The commands of the joints, or what is imposed on the end.
std::vector<Abscissa> abscissae(const Experiment& experiment, const Run& like) {
  if (!like.commands_joints()) {
    const Channel over = moves_most(experiment, like);
    return {{over.label(), std::string(over.unit()),
             [over](const Reading& reading) { return over.of(reading); }}};
  }
  std::vector<Abscissa> all;
  for (std::size_t j = 0; j < like.rest.size(); ++j)
    all.push_back({"the command of " + experiment.joint_name(j), experiment.joint_unit(j),
                   [j](const Reading& reading) { return reading.rest[j]; }});
  return all;
}

Missing channel_over(const Study& study, const NoiseEstimate& noise, const Channel& of, Control control,
                     const Abscissa& over) {
  Missing missing{of.label(), std::string(of.unit()), over.label, over.unit, {}, 0, 0, 0};
  const VectorXd residual = study.nominal_residual();
  for (const Series& series : study.measurements().series()) {
    const Run& run = study.experiment().runs[series.run];
    if (series.channel != of || run.control != control) continue;
    std::vector<double> command;
    for (const Reading& reading : run.readings) command.push_back(over.of(reading));
    const std::vector<bool> down = falling(command);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      if (noise.shape.outlier[series.first + i]) continue;
      const Reading& reading = run.readings[series.readings[i]];
      const auto row = static_cast<Eigen::Index>(series.first + i);
      missing.points.push_back({over.of(reading), study.measurements().sigma()(row) * residual(row),
                                reading.t, down[series.readings[i]]});
    }
  }
  return missing;
}

/// How far values stand off the line through their neighbours in place, in units of one value's spread, for
/// every point that has one to either side among those that go the same way, or among all; and their times
/// off the line through their neighbours' times. A smooth function of place leaves nothing, noise all of
/// itself (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986).
struct OffNeighbours {
  std::vector<double> value, time;
};

OffNeighbours off_neighbours(const std::vector<MissingPoint>& points, bool each_way) {
  OffNeighbours off;
  for (const bool down : {false, true}) {
    std::vector<const MissingPoint*> line;
    for (const MissingPoint& point : points)
      if (each_way ? point.falling == down : !down) line.push_back(&point);
    std::stable_sort(line.begin(), line.end(),
                     [](const MissingPoint* a, const MissingPoint* b) { return a->at < b->at; });
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const MissingPoint &before = *line[i - 1], &here = *line[i], &after = *line[i + 1];
      const double gap = after.at - before.at, share = gap > 0 ? (here.at - before.at) / gap : 0.5;
      const double spread = std::sqrt(1 + share * share + (1 - share) * (1 - share));
      off.value.push_back((here.value - (1 - share) * before.value - share * after.value) / spread);
      off.time.push_back((here.t - (1 - share) * before.t - share * after.t) / spread);
    }
  }
  return off;
}

/// Mean square of values, without what goes with the others in proportion.
double mean_square(const std::vector<double>& values, const std::vector<double>& others) {
  double vv = 0, vo = 0, oo = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    vv += values[i] * values[i];
    vo += values[i] * others[i];
    oo += others[i] * others[i];
  }
  return std::max(0.0, vv - (oo > 0 ? vo * vo / oo : 0)) / static_cast<double>(values.size());
}

double variance(const std::vector<MissingPoint>& points) {
  double mean = 0, squares = 0;
  for (const MissingPoint& point : points) mean += point.value / static_cast<double>(points.size());
  for (const MissingPoint& point : points) squares += std::pow(point.value - mean, 2);
  return squares / static_cast<double>(points.size() - 1);
}

void describe(Missing& missing) {
  missing.by_position = missing.by_direction = missing.by_time = 0;
  constexpr std::size_t few = 4;  // of one value in place and two that a way and a trend take, one is left
  if (missing.points.size() < few) return;
  const double all = variance(missing.points);
  if (!(all > 0)) return;
  const auto share = [&](const OffNeighbours& off, bool trend) {
    if (off.value.size() < 2) return 0.0;
    const std::vector<double> time = trend ? off.time : std::vector<double>(off.value.size(), 0.0);
    return std::clamp(1 - mean_square(off.value, time) / all, 0.0, 1.0);
  };
  const OffNeighbours each_way = off_neighbours(missing.points, true);
  missing.by_position = share(off_neighbours(missing.points, false), false);
  missing.by_direction = std::max(missing.by_position, share(each_way, false));
  missing.by_time = std::max(missing.by_direction, share(each_way, true));
}

}  // namespace

Missing describe_missing(const Study& study, const NoiseEstimate& noise, const Where& where) {
  Missing missing;
  if (where.joint_evidence == JointEvidence::measured && where.joints.front().share > 0.5)
    missing = torque(study, where.joints.front().joint);
  if (!missing.points.empty()) {
    describe(missing);
    return missing;
  }
  const Channel& of = where.channels.front().channel;
  const auto& all = study.measurements().series();
  const auto first =
      std::find_if(all.begin(), all.end(), [&](const Series& one) { return one.channel == of; });
  const Run& like = study.experiment().runs[first->run];
  for (const Abscissa& over : abscissae(study.experiment(), like)) {
    Missing one = channel_over(study, noise, of, like.control, over);
    describe(one);
    if (missing.points.empty() || one.by_position > missing.by_position) missing = std::move(one);
  }
  return missing;
}

}  // namespace plumbline::diagnose
