#include "diagnose/log_sum.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plumbline::diagnose {

double log_sum(const Eigen::VectorXd& v) {
  const double most = v.maxCoeff();
  if (!std::isfinite(most)) return most;
  return most + std::log((v.array() - most).exp().sum());
}

double log_sum(const std::vector<double>& v) {
  return log_sum(
      Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()))));
}

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::plus<>());
  return result;
}

}  // namespace plumbline::diagnose
