#include "trial/wilson.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace plumbline::trial {
namespace {

/// E. B. Wilson, Probable inference, the law of succession, and statistical inference, JASA 22 (1927).
double bound(const Proportion& p, double side) {
  static const double z = boost::math::quantile(boost::math::normal(), 0.975);
  const auto n = static_cast<double>(p.total);
  const double share = p.share(), weight = z * z / n;
  return (share + weight / 2 + side * z * std::sqrt(share * (1 - share) / n + weight / (4 * n))) /
         (1 + weight);
}

}  // namespace

double Proportion::share() const {
  return static_cast<double>(count) / static_cast<double>(total);
}

double Proportion::low() const {
  return count == 0 ? 0 : bound(*this, -1);
}

double Proportion::high() const {
  return count == total ? 1 : bound(*this, 1);
}

}  // namespace plumbline::trial
