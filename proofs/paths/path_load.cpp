#include "proofs/paths/path_load.hpp"

#include <fmt/format.h>

#include <plumbline/loaded/nominal_model.hpp>

namespace plumbline::proofs {
namespace {

/// As NominalModel does, also where the squares of lengths are not to be held.
void require_reach(const Chain<double>& chain, const Point<double>& p) {
  const auto [inner, outer] = reach(chain.length());
  const double distance = std::hypot(p.x, p.y);
  if (chain.size() > 1 && (!(distance < outer) || (inner > 0 && !(distance > inner))))
    throw Error(
        "end point", fmt::format("distance {:.6g} from the base", distance),
        fmt::format("between {:.6g} and {:.6g}, both excluded: the reach of the chain", inner, outer));
  const Measures m = measures_of(chain);
  NominalModel<double>(measured(chain, m)).require_reach({p.x / m.length, p.y / m.length});
}

}  // namespace

PathTask path_task(const Chain<Rational>& chain, const PathLoad& load, double step, int side) {
  const auto rounded = from_rational<double>(chain);
  const auto [loading, last] = loading_of(load, rounded);
  if (!(last > 0) || !is_finite(last)) throw Error("load", "nothing to do", "a finite load that is not zero");
  if (load.control == Control::end_point) require_reach(rounded, loading.at(last));
  return {rounded, loading, last, step, side};
}

JoinedBranches certify(const PathReport& report, const Chain<Rational>& chain, const PathLoad& load,
                       ProvedPoints points) {
  const auto enclosed = from_rational<Interval>(chain);
  return certify(report, enclosed, loading_of(load, enclosed).first,
                 symmetries(chain, load.control, load.direction()), points);
}

}  // namespace plumbline::proofs
