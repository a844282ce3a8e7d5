#pragma once
/// \file
/// Paths of the nominal chain in doubles: what a slowly loaded chain does, and every branch.

#include <plumbline/branch/trace.hpp>
#include <span>
#include <string>
#include <vector>

namespace plumbline::proofs {

/// What the end of a branch is called.
std::string_view name(BranchEnd end);

struct PathTask {
  Chain<double> chain;
  Loading<double> loading;
  double last;   ///< the load grows from 0 to here
  double step;   ///< longest way between points: root mean square turn of the links, in radians
  int side = 1;  ///< where a symmetric chain buckles: the side it leaves to, 1 or -1
};

/// What was followed: the stable history stretch by stretch, or every branch.
struct PathReport {
  std::string chain;
  Loading<double> loading;
  double last;   ///< end of the load window
  bool history;  ///< stretches of what really happens, in order; else branches
  std::vector<Branch<double>> branches;
  std::vector<std::string> warnings;
};

/// The slowly loaded chain, from its unloaded shape. A straight chain begins in its lowest buckling mode, on
/// the given side.
PathReport follow_slowly(const PathTask& task);

/// Every branch that hangs together with the unloaded shape (a straight chain: with a buckling mode), or that
/// passes one of the equilibria of certified censuses at the last, the middle and a small load (up to five
/// links).
PathReport follow_all(const PathTask& task);

/// The state at a load on a branch, and of a slowly loaded chain on its stretches; the nearest stored point
/// where they do not reach it.
BranchPoint<double> state_at(const PathTask& task, const Branch<double>& branch, double load);
BranchPoint<double> state_at(const PathTask& task, const std::vector<Branch<double>>& stretches, double load);

}  // namespace plumbline::proofs
