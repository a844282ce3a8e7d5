#include "diagnose/rig/torque.hpp"

#include <algorithm>

namespace plumbline::diagnose {

TorqueTable::TorqueTable(const std::vector<FreeLaw::Knot>& knots) : knots_(knots), energy_(knots.size(), 0) {
  for (std::size_t k = 1; k < knots.size(); ++k)
    energy_[k] = energy_[k - 1] + (knots[k].deflection - knots[k - 1].deflection) *
                                      (knots[k].torque + knots[k - 1].torque) / 2;
}

Torque TorqueTable::at(double deflection) const {
  if (knots_.size() == 1) {
    const double torque = knots_.front().torque;
    return {torque, 0, torque * (deflection - knots_.front().deflection)};
  }
  const auto beyond =
      std::upper_bound(knots_.begin() + 1, knots_.end() - 1, deflection,
                       [](double d, const FreeLaw::Knot& knot) { return d < knot.deflection; });
  const FreeLaw::Knot &left = *(beyond - 1), &right = *beyond;
  const double slope = (right.torque - left.torque) / (right.deflection - left.deflection),
               step = deflection - left.deflection;
  const auto number = static_cast<std::size_t>(beyond - knots_.begin()) - 1;
  return {left.torque + slope * step, slope, energy_[number] + step * (left.torque + slope * step / 2)};
}

double TorqueTable::work(double from, double to, double share_from, double share_to) const {
  if (from == to) return 0;
  if (from > to) return -work(to, from, share_to, share_from);
  const auto carried = [&](double d) {
    return at(d).value * (share_from + (share_to - share_from) * (d - from) / (to - from));
  };
  double sum = 0, begin = from;
  // Between knots a parabola, of which Simpson's rule is exact.
  const auto add_until = [&](double end) {
    sum += (end - begin) / 6 * (carried(begin) + 4 * carried((begin + end) / 2) + carried(end));
    begin = end;
  };
  for (const FreeLaw::Knot& knot : knots_)
    if (knot.deflection > from && knot.deflection < to) add_until(knot.deflection);
  add_until(to);
  return sum;
}

}  // namespace plumbline::diagnose
