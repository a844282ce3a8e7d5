#pragma once
/// \file
/// What is timed in a portable build and in one for the machine at hand: the same text, compiled twice into a
/// library each. Only standard types cross the border, for what Eigen aligns to depends on the machine.

#include <vector>

namespace plumbline::bench {

/// Chains of `links` links each, one after the other.
struct ChainList {
  std::size_t links;
  std::vector<double> length, stiffness;
};

struct Kernels {
  std::vector<double> (*lowest_one_by_one)(const ChainList& chains);
  std::vector<double> (*lowest_as_batch)(const ChainList& chains);
  std::vector<double> (*all_forces)(const ChainList& chains);
  /// End forces along the path of the first chain, bent a little, compressed to half its reach.
  std::vector<double> (*path)(const ChainList& chains);
};

/// Compiled for any machine of its kind.
Kernels portable_kernels();
/// Compiled with -march=native.
Kernels native_kernels();

}  // namespace plumbline::bench
