#include "diagnose/discrepancy/joint_share.hpp"

namespace plumbline::diagnose {

std::vector<JointShare> joint_shares(const std::vector<double>& weight) {
  std::vector<JointShare> shares;
  shares.reserve(weight.size());
  for (const double w : weight) shares.push_back({shares.size() + 1, w});
  normalise(shares);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const JointShare& a, const JointShare& b) { return a.share > b.share; });
  return shares;
}

}  // namespace plumbline::diagnose
