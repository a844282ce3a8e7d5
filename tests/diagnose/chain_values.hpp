#pragma once
/// \file
/// The values of a reading of a planar chain.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose::test {

/// Without a second sensor of the load.
inline std::vector<double> chain_values(double x, double y, double Fx, double Fy,
                                        const std::vector<double>& q = {}) {
  std::vector<double> values{x, y, Fx, Fy, std::nan(""), std::nan("")};
  values.insert(values.end(), q.begin(), q.end());
  return values;
}

}  // namespace plumbline::diagnose::test
