#pragma once
/// \file
/// Shares of a gap, and how much of it each joint accounts for.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plumbline::diagnose {

/// Makes shares of sums, which noise can push below zero; equal shares where nothing is left.
template <class Share>
void normalise(std::vector<Share>& shares) {
  double sum = 0;
  for (Share& one : shares) sum += one.share = std::max(0.0, one.share);
  for (Share& one : shares) one.share = sum > 0 ? one.share / sum : 1 / static_cast<double>(shares.size());
}

struct JointShare {
  std::size_t joint;  ///< from 1
  double share;
};

/// Shares in proportion to the weights of the joints, largest first; alike where no joint has any.
std::vector<JointShare> joint_shares(const std::vector<double>& weight);

}  // namespace plumbline::diagnose
