#include "proofs/census/census_task.hpp"

namespace plumbline::proofs {

Chain<Interval> enclosed_chain(const CensusTask& task) {
  const auto chain = from_rational<Interval>(task.chain);
  if (!task.rest_in_pi) return chain;
  auto rest = chain.rest();
  for (Interval& angle : rest) angle *= Interval::pi();
  return Chain<Interval>(chain.length(), chain.stiffness(), rest);
}

Point<Interval> enclosed_load(const CensusTask& task) {
  const Point<Interval> load{Interval(task.load.x), Interval(task.load.y)};
  if (task.given != Given::deflection) return load;
  const Chain<Interval> chain = enclosed_chain(task);
  const Point<Interval> rest = end_point(chain, chain.rest());
  return {rest.x - load.x, rest.y + load.y};
}

Census take_census(const CensusTask& task) {
  const Chain<Interval> chain = enclosed_chain(task);
  const Point<Interval> load = enclosed_load(task);
  return task.given == Given::force ? census_under_force(chain, load)
                                    : census_at_end_point(chain, load, unwound(chain, task.turns));
}

}  // namespace plumbline::proofs
