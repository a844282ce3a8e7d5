#include "proofs/paths/measures.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::proofs {
namespace {

double unit_near(const std::vector<double>& values) {
  const double most = *std::max_element(values.begin(), values.end());
  if (!(most > 0)) return 1;
  if (!std::isfinite(most)) return most;
  return std::ldexp(1, 32 * static_cast<int>(std::lround(std::log2(most) / 32)));
}

void divide(BranchPoint<double>& point, const Measures& m, Control control) {
  point.load /= m.load(control);
  point.force = {point.force.x / m.force(), point.force.y / m.force()};
  point.end_point = {point.end_point.x / m.length, point.end_point.y / m.length};
  point.energy /= m.stiffness;
  point.stiffness /= m.force() / m.length;
  point.tangent.force = {point.tangent.force.x / m.force(), point.tangent.force.y / m.force()};
  point.tangent.load /= m.load(control);
}

}  // namespace

Measures measures_of(const Chain<double>& chain) {
  const Measures m{unit_near(chain.length()), unit_near(chain.stiffness())};
  const auto ordinary = [](double x) { return x > 1e-280 && x < 1e280; };
  if (!ordinary(m.length) || !ordinary(m.stiffness) || !ordinary(m.force()) ||
      !ordinary(m.force() / m.length))
    throw Error("chain", "forces or stiffnesses that double precision does not hold", "other units");
  return m;
}

Branch<double> measured(Branch<double> branch, const Measures& m, Control control) {
  for (BranchPoint<double>& point : branch.points) divide(point, m, control);
  for (BranchEvent<double>& event : branch.events) {
    divide(event.point, m, control);
    event.crossing.force = {event.crossing.force.x / m.force(), event.crossing.force.y / m.force()};
    event.crossing.load /= m.load(control);
  }
  return branch;
}

double load_unit(const Chain<Interval>& chain, Control control) {
  const auto largest = [](const std::vector<Interval>& values) {
    double most = 0;
    for (const Interval& x : values) most = std::max(most, static_cast<double>(x.middle()));
    return most;
  };
  const double reach = largest(chain.length());
  return control == Control::end_point ? reach : largest(chain.stiffness()) / reach;
}

std::pair<Chain<Interval>, Loading<Interval>> without_units(const Chain<Interval>& chain,
                                                            const Loading<Interval>& loading) {
  const double length = load_unit(chain, Control::end_point),
               stiffness = load_unit(chain, Control::force) * length;
  const auto measured = [](std::vector<Interval> values, double unit) {
    for (Interval& x : values) x = x / Interval::from_double(unit);
    return values;
  };
  const Interval unit = Interval::from_double(load_unit(chain, loading.control));
  return {
      Chain<Interval>(measured(chain.length(), length), measured(chain.stiffness(), stiffness), chain.rest()),
      {loading.control, {loading.start.x / unit, loading.start.y / unit}, loading.direction}};
}

}  // namespace plumbline::proofs
