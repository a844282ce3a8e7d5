#include "diagnose/next/discrepancy.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose::next {
namespace {
double env(const char* name, double otherwise) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : otherwise;
}
const double share_direction = env("RHO", 0.4), share_run = env("KAPPA", 0.3);

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

}  // namespace

States::States(const Experiment& experiment) {
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
  for (std::size_t r = 0; r < command.size(); ++r)
    for (auto& one : command[r]) one /= reach[experiment.runs[r].holds_end_point()];
  for (std::size_t r = 0; r < command.size(); ++r) {
    const std::vector<double> direction = directions(command[r]);
    of.emplace_back();
    double way = 0;
    for (std::size_t i = 0; i < command[r].size(); ++i) {
      if (i > 0) way += (command[r][i] - command[r][i - 1]).norm();
      of.back().push_back({command[r][i], direction[i], way});
    }
    longest = std::max(longest, way);
  }
  for (auto& run : of)
    for (State& one : run) one.progress /= longest;
  const auto n = static_cast<Eigen::Index>(experiment.runs.size());
  alike = MatrixXd::Zero(n, n);
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
}

double Kernel::operator()(std::size_t run, std::size_t reading, std::size_t other_run,
                          std::size_t other_reading) const {
  const State &a = states_.of[run][reading], &b = states_.of[other_run][other_reading];
  const auto common = [&](const Eigen::Vector2d& u, double d, const Eigen::Vector2d& v, double e) {
    return matern((u - v).norm(), length_) * ((1 - share_direction) + share_direction * d * e);
  };
  const Eigen::Vector2d rest(0, 0);
  double sum = (1 - share_run) *
               states_.alike(static_cast<Eigen::Index>(run), static_cast<Eigen::Index>(other_run)) *
               (common(a.command, a.direction, b.command, b.direction) -
                common(a.command, a.direction, rest, 1) * common(rest, 1, b.command, b.direction));
  if (run == other_run)
    sum += share_run * (matern(std::abs(a.progress - b.progress), length_) -
                        matern(a.progress, length_) * matern(b.progress, length_));
  return sum;
}

MatrixXd basis(const Kernel& kernel, const Block& block, Eigen::Index most, double left_out) {
  const Eigen::Index n = block.size();
  const auto of = [&](Eigen::Index i, Eigen::Index j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    return kernel(block.run[a], block.reading[a], block.run[b], block.reading[b]);
  };
  VectorXd left(n);
  for (Eigen::Index i = 0; i < n; ++i) left(i) = of(i, i);
  const double enough = left_out * left.sum();
  MatrixXd columns(n, std::min(n, most));
  Eigen::Index rank = 0;
  while (rank < columns.cols() && left.sum() > enough) {
    Eigen::Index pivot = 0;
    const double largest = left.maxCoeff(&pivot);
    if (!(largest > 1e-12)) break;
    VectorXd column(n);
    for (Eigen::Index i = 0; i < n; ++i) column(i) = of(i, pivot);
    if (rank > 0) column -= columns.leftCols(rank) * columns.row(pivot).head(rank).transpose();
    columns.col(rank) = column / std::sqrt(largest);
    left = (left - columns.col(rank).cwiseAbs2()).cwiseMax(0);
    ++rank;
  }
  return columns.leftCols(rank);
}

}  // namespace plumbline::diagnose::next
