#include "diagnose/discrepancy/kernel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "diagnose/bench/command_range.hpp"
#include "diagnose/priors.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {
namespace {

double matern(double distance, double length) {
  const double z = std::sqrt(5.0) * distance / length;
  return (1 + z + z * z / 3) * std::exp(-z);
}

/// By reading, whether the command goes away from rest (1) or back (-1) along the main axis of the run.
std::vector<double> directions(const std::vector<Eigen::Vector2d>& command) {
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
  for (const auto& one : command) square += (one - command.front()) * (one - command.front()).transpose();
  Eigen::Vector2d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(square).eigenvectors().col(1);
  for (const auto& one : command)
    if ((one - command.front()).norm() > 0.02) {
      if (axis.dot(one - command.front()) < 0) axis = -axis;
      break;
    }
  std::vector<double> result(command.size(), 1);
  double last = 1;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const double step = axis.dot(command[i] - command[i - 1]);
    if (std::abs(step) > 1e-9) last = step > 0 ? 1 : -1;
    result[i] = last;
  }
  return result;
}

/// How alike runs are in the plane: by control and rest shape.
MatrixXd likeness(const Experiment& experiment) {
  const auto n = static_cast<Eigen::Index>(experiment.runs.size());
  MatrixXd alike = MatrixXd::Zero(n, n);
  constexpr double near_shape = 0.3;  // rad
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = 0; b < n; ++b) {
      const Run &one = experiment.runs[static_cast<std::size_t>(a)],
                &other = experiment.runs[static_cast<std::size_t>(b)];
      if (one.holds_end_point() != other.holds_end_point()) continue;
      double sum = 0;
      for (std::size_t j = 0; j < one.rest.size(); ++j) sum += std::pow(one.rest[j] - other.rest[j], 2);
      alike(a, b) = std::exp(-sum / static_cast<double>(one.rest.size()) / (2 * near_shape * near_shape));
    }
  return alike;
}

/// From -1 to 1 within the range.
double share_of(const CommandRange& range, double value) {
  return (2 * value - range.low - range.high) / (range.high - range.low);
}

}  // namespace

CommandStates::CommandStates(const Experiment& experiment) {
  if (experiment.visits_poses())
    add_poses(experiment);
  else
    add_ways(experiment);
}

void CommandStates::add_ways(const Experiment& experiment) {
  double reach[2] = {1e-300, 1e-300}, longest = 1e-300;
  std::vector<std::vector<Eigen::Vector2d>> command;
  for (const Run& run : experiment.runs) {
    const Eigen::Vector2d rest =
        run.holds_end_point() ? Eigen::Vector2d(unloaded_end(experiment, run.rest)) : Eigen::Vector2d(0, 0);
    command.emplace_back();
    Eigen::Vector2d last(0, 0);
    for (const Reading& reading : run.readings) {
      const Eigen::Vector2d now = run.command(reading) - rest;
      if (now.allFinite()) last = now;
      command.back().push_back(last);
      double& most = reach[run.holds_end_point()];
      most = std::max(most, last.norm());
    }
  }
  for (std::size_t r = 0; r < command.size(); ++r) {
    const double most = reach[experiment.runs[r].holds_end_point()];
    // Where nothing is imposed at all, as in a sag test, the runs are poses, and nothing is known to be at
    // rest.
    knows_rest.push_back(most > 1e-12);
    if (knows_rest.back())
      for (auto& one : command[r]) one /= most;
  }
  for (std::size_t r = 0; r < command.size(); ++r) {
    const std::vector<double> direction = directions(command[r]);
    of.emplace_back();
    double way = 0;
    for (std::size_t i = 0; i < command[r].size(); ++i) {
      if (i > 0) way += (command[r][i] - command[r][i - 1]).norm();
      of.back().push_back({{{command[r][i].x(), command[r][i].y(), 0}}, {direction[i]}, way});
    }
    longest = std::max(longest, way);
  }
  for (auto& run : of)
    for (CommandState& one : run) one.progress /= longest;
  alike = likeness(experiment);
}

void CommandStates::add_poses(const Experiment& experiment) {
  const std::size_t joints = experiment.link_length.size();
  const std::vector<CommandRange> range = command_ranges(experiment);
  one_session = true;
  double heaviest = 0, readings = 0, taken = 0;
  for (const Run& run : experiment.runs) readings += static_cast<double>(run.readings.size());
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings) heaviest = std::max(heaviest, reading.wrench_force().norm());
  for (const Run& run : experiment.runs) {
    of.emplace_back();
    knows_rest.push_back(false);
    std::vector<double> way(joints + 1, 1);
    const Reading* last = nullptr;
    for (const Reading& reading : run.readings) {
      CommandState state{{}, {}, taken++ / readings};
      for (std::size_t j = 0; j < joints; ++j) {
        if (last && reading.rest[j] != last->rest[j]) way[j] = reading.rest[j] > last->rest[j] ? 1 : -1;
        if (!(range[j].high > range[j].low)) continue;
        state.command.emplace_back(share_of(range[j], reading.rest[j]), 0, 0);
        state.direction.push_back(way[j]);
      }
      if (heaviest > 0 || state.command.empty()) {
        state.command.push_back(reading.wrench_force() / std::max(heaviest, 1e-300));
        state.direction.push_back(1);
      }
      of.back().push_back(std::move(state));
      last = &reading;
    }
  }
  const auto n = static_cast<Eigen::Index>(experiment.runs.size());
  alike = MatrixXd::Ones(n, n);
}

namespace {

constexpr Eigen::Index most_columns = 40;
constexpr double left_out = 1e-3;  // of the trace

/// Covariance of a discrepancy of size one.
class Kernel {
 public:
  Kernel(const CommandStates& states, const Measurements& measurements, const Block& block, double length)
      : states_(states), measurements_(measurements), first_(block.first), length_(length) {}

  /// At two values of the block.
  [[nodiscard]] double operator()(Eigen::Index i, Eigen::Index j) const {
    const ReadingPlace &p = place(i), &q = place(j);
    const CommandState &a = states_.of[p.run][p.reading], &b = states_.of[q.run][q.reading];
    static const CommandState rest;
    const bool knows_rest = states_.knows_rest[p.run];
    constexpr double vanishes = 1 - priors::rest_share;
    double common = smooth(a, b), own = 0;
    if (knows_rest) common -= vanishes * smooth(a, rest) * smooth(rest, b);
    if (states_.one_session)
      own = matern(std::abs(a.progress - b.progress), length_);
    else if (p.run == q.run && knows_rest)
      own = matern(std::abs(a.progress - b.progress), length_) -
            vanishes * matern(a.progress, length_) * matern(b.progress, length_);
    const double alike = states_.alike(static_cast<Eigen::Index>(p.run), static_cast<Eigen::Index>(q.run));
    return (1 - priors::own_share) * alike * common + priors::own_share * own;
  }

 private:
  [[nodiscard]] const ReadingPlace& place(Eigen::Index i) const {
    return measurements_.places()[static_cast<std::size_t>(first_ + i)];
  }
  [[nodiscard]] double smooth(const CommandState& a, const CommandState& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < a.command.size(); ++k)
      sum += matern((a.command[k] - b.command[k]).norm(), length_) *
             ((1 - priors::directional_share) + priors::directional_share * a.direction[k] * b.direction[k]);
    return sum / static_cast<double>(a.command.size());
  }

  const CommandStates& states_;
  const Measurements& measurements_;
  Eigen::Index first_;
  double length_;
};

/// An incomplete Cholesky factor with its pivots.
struct Factor {
  MatrixXd columns;
  std::vector<Eigen::Index> pivots;
};

Factor incomplete_cholesky(const Kernel& kernel, Eigen::Index n) {
  VectorXd left(n);
  for (Eigen::Index i = 0; i < n; ++i) left(i) = kernel(i, i);
  const double enough = left_out * left.sum();
  MatrixXd columns(n, std::min(n, most_columns));
  std::vector<Eigen::Index> pivots;
  while (static_cast<Eigen::Index>(pivots.size()) < columns.cols() && left.sum() > enough) {
    const auto rank = static_cast<Eigen::Index>(pivots.size());
    Eigen::Index pivot = 0;
    const double largest = left.maxCoeff(&pivot);
    if (!(largest > 1e-9)) break;
    VectorXd column(n);
    for (Eigen::Index i = 0; i < n; ++i) column(i) = kernel(i, pivot);
    if (rank > 0) column -= columns.leftCols(rank) * columns.row(pivot).head(rank).transpose();
    columns.col(rank) = column / std::sqrt(largest);
    left = (left - columns.col(rank).cwiseAbs2()).cwiseMax(0);
    left(pivot) = 0;
    pivots.push_back(pivot);
  }
  return {columns.leftCols(static_cast<Eigen::Index>(pivots.size())), pivots};
}

}  // namespace

DiscrepancyBasis discrepancy_basis(const CommandStates& states, const Measurements& measurements,
                                   const Block& block, const std::vector<double>& lengths) {
  const Factor factor =
      incomplete_cholesky(Kernel(states, measurements, block, lengths.front()), block.count);
  DiscrepancyBasis result{factor.columns, {}};
  const Eigen::Index rank = factor.columns.cols();
  const MatrixXd at_pivots = factor.columns(factor.pivots, Eigen::all);
  for (const double length : lengths) {
    if (length == lengths.front()) {
      result.covariance.emplace_back(MatrixXd::Identity(rank, rank));
      continue;
    }
    // The other lengths are interpolated from the pivots (Nystroem).
    const Kernel kernel(states, measurements, block, length);
    MatrixXd k(rank, rank);
    for (std::size_t i = 0; i < factor.pivots.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const auto row = static_cast<Eigen::Index>(i), col = static_cast<Eigen::Index>(j);
        k(row, col) = k(col, row) = kernel(factor.pivots[i], factor.pivots[j]);
      }
    const auto lower = at_pivots.triangularView<Eigen::Lower>();
    const MatrixXd half = lower.solve(k);
    result.covariance.emplace_back(lower.solve(MatrixXd(half.transpose())));
  }
  return result;
}

}  // namespace plumbline::diagnose
