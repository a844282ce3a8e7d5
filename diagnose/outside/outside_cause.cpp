#include "diagnose/outside/outside_cause.hpp"

#include <cmath>

namespace plumbline::diagnose {

double log_outside(const Leftover& left) {
  std::vector<double> terms;
  for (const OutsideRow& row : outside_rows)
    terms.push_back(std::log(row.share) + row.make()->fit(left).log_likelihood);
  return log_sum(terms);
}

}  // namespace plumbline::diagnose
