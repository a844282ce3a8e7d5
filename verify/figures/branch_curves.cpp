#include "verify/figures/branch_curves.hpp"

#include <cmath>

namespace plumbline::verify {

std::vector<std::pair<double, double>> outline(const Chain<double>& chain, const Vector<double>& theta) {
  std::vector<std::pair<double, double>> line{{0, 0}};
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const double t = theta(static_cast<Eigen::Index>(j));
    line.emplace_back(line.back().first + chain.length()[j] * std::cos(t),
                      line.back().second + chain.length()[j] * std::sin(t));
  }
  return line;
}

}  // namespace plumbline::verify
