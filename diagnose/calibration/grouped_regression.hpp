#pragma once
/// \file
/// Linear regression on groups of columns whose sizes are learned: one standard deviation for each group
/// (Mackay, Bayesian interpolation, Neural Computation 4, 1992).

#include <Eigen/Core>
#include <vector>

namespace plumbline::diagnose {

/// Neighbouring columns of one size.
struct ColumnGroup {
  Eigen::Index first, count;
};

/// Some groups with the standard deviations that have most evidence, and the coefficients' posterior. A
/// column of several groups belongs to the last of them.
struct GroupedFit {
  std::vector<std::size_t> groups;
  std::vector<double> size;           ///< standard deviation of the coefficients, by group of these
  double noise = 1;                   ///< standard deviation of the values
  std::vector<double> determined;     ///< so many coefficients of the group the values tell
  std::vector<Eigen::Index> columns;  ///< of these groups
  std::vector<std::size_t> owner;     ///< place of its group among these, by column of these
  Eigen::VectorXd mean;               ///< of all columns; zero for those of no group
  Eigen::MatrixXd covariance;         ///< of the columns of these groups
  double log_evidence = 0;            ///< sizes at their best
};

/// All of it goes by one Gram matrix: a choice of groups costs nothing but its own small blocks.
class GroupedRegression {
 public:
  /// \param unknown  columns of any coefficients, which are projected out
  /// \param columns  in units of a typical coefficient
  GroupedRegression(const Eigen::MatrixXd& unknown, const Eigen::MatrixXd& columns,
                    std::vector<ColumnGroup> groups, const Eigen::VectorXd& values);

  [[nodiscard]] GroupedFit fit(const std::vector<std::size_t>& groups) const;
  /// Least squares, with the noise declared, tied to sizes that are given.
  [[nodiscard]] GroupedFit tied(const std::vector<std::size_t>& groups, double size) const;
  /// The groups that stand always, and of those offered one after the other, while the evidence rises by more
  /// than the choice among so many takes.
  [[nodiscard]] GroupedFit extended(const std::vector<std::size_t>& always,
                                    const std::vector<std::size_t>& offered) const;

 private:
  /// Takes the columns of the groups, each for the last that has it.
  void take_columns(GroupedFit& fit) const;
  /// Mackay's iterations from the sizes and the noise of a fit.
  [[nodiscard]] GroupedFit iterated(GroupedFit fit, int iterations) const;
  /// Of those offered, the few beside a fit that promise most by a score test, and of each group the
  /// farthest.
  [[nodiscard]] std::vector<std::size_t> promising(const GroupedFit& beside,
                                                   const std::vector<std::size_t>& offered) const;

  std::vector<ColumnGroup> groups_;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd product_;
  double squares_, count_;
};

}  // namespace plumbline::diagnose
