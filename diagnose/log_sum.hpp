#pragma once
/// \file
/// Sums of what is known by its logarithm.

#include <Eigen/Core>
#include <initializer_list>
#include <vector>

namespace plumbline::diagnose {

/// log(sum(exp(v)))
double log_sum(const Eigen::VectorXd& v);
double log_sum(const std::vector<double>& v);
inline double log_sum(std::initializer_list<double> v) {
  return log_sum(std::vector<double>(v));
}

/// By element.
std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace plumbline::diagnose
