#include "diagnose/rig/user_effects/stated_effect.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

std::vector<ParameterRange> ranges(const StatedEffect& stated) {
  std::vector<ParameterRange> all;
  for (const StatedParameter& one : stated.parameters)
    all.push_back({one.name, one.unit, Coordinate::plain, one.scale, one.low, one.high, one.tolerance});
  return all;
}

std::vector<std::size_t> growing(const StatedEffect& stated) {
  std::vector<std::size_t> places;
  for (std::size_t p = 0; p < stated.parameters.size(); ++p)
    if (stated.parameters[p].grows()) places.push_back(p);
  return places;
}

/// A value between the bounds, geometrically.
double between(const StatedParameter& shape, double share) {
  return shape.low * std::pow(shape.high / shape.low, share);
}

/// A grid over the shape parameters, with the growing ones zero; a single point for three shape parameters
/// and more, whose grid would be too large.
std::vector<std::vector<double>> shapes(const StatedEffect& stated) {
  const bool few = stated.parameters.size() - growing(stated).size() <= 2;
  const std::vector<double> shares =
      few ? std::vector<double>{0.1, 0.3, 0.5, 0.7, 0.9} : std::vector<double>{0.5};
  std::vector<std::vector<double>> all{{}};
  for (const StatedParameter& one : stated.parameters) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& head : all) {
      for (const double share : one.grows() ? std::vector<double>{0} : shares) {
        longer.push_back(head);
        longer.back().push_back(one.grows() ? 0 : between(one, share));
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// Whether joints may stick: a small amount of the effect then acts otherwise than a large one.
bool sticks(const StatedEffect& stated) {
  return stated.torque && stated.uses("s");
}

/// Initial guesses one scale to either side at every point of the grid, and zero where no joint sticks.
InitialGuesses guesses_of(const StatedEffect& stated) {
  InitialGuesses guesses{{}, 2};
  for (const std::vector<double>& shape : shapes(stated)) {
    if (growing(stated).size() == shape.size() && !sticks(stated)) guesses.points.push_back(shape);
    for (const double side : {1.0, -1.0}) {
      std::vector<double> one = shape;
      for (const std::size_t p : growing(stated)) {
        const StatedParameter& range = stated.parameters[p];
        one[p] = std::clamp(side * range.scale, range.low, range.high);
      }
      if (one != shape) guesses.points.push_back(std::move(one));
    }
  }
  return guesses;
}

/// Shape parameters keep the value of the initial guess.
Perturbation perturbation_of(const StatedEffect& stated) {
  Perturbation perturbation;
  if (growing(stated).size() < stated.parameters.size()) perturbation.growing = growing(stated);
  perturbation.large_step = sticks(stated);
  return perturbation;
}

bool possible(const StatedEffect& stated, const Place& at) {
  if (stated.uses("t") && !at.scales.clock) return false;
  if (stated.torque) return !stated.at_joint || !stated.uses("k") || at.scales.joint_stiffness[at.joint] > 0;
  return std::any_of(stated.readings.begin(), stated.readings.end(),
                     [&](const StatedReading& one) { return at.scales.measures(one.channel); });
}

void add(const StatedEffect& stated, const Addition& to) {
  const std::vector<double> values(to.value, to.value + stated.parameters.size());
  for (const StatedReading& one : stated.readings)
    to.rig.stated_corrections.push_back({one.channel, one.joint, one.formula, values});
  if (!stated.torque) return;
  for (std::size_t i = 0; i < to.rig.length.size(); ++i)
    if (!stated.at_joint || i == to.joint) to.rig.stated_torques.push_back({i, stated.torque, values});
}

}  // namespace

bool StatedEffect::uses(std::string_view variable) const {
  return (torque && torque->uses(variable)) ||
         std::any_of(readings.begin(), readings.end(),
                     [&](const StatedReading& one) { return one.formula->uses(variable); });
}

Effect row_of(std::shared_ptr<const StatedEffect> stated) {
  return {.id = "user:" + stated->id,
          .words = stated->words,
          .at_joint = stated->at_joint,
          .dissipates = stated->uses("s") || (stated->torque && stated->uses("t")),
          .parameters = [stated](const Place&) { return ranges(*stated); },
          .add = [stated](const Addition& to) { plumbline::diagnose::add(*stated, to); },
          .possible = [stated](const Place& at) { return plumbline::diagnose::possible(*stated, at); },
          .initial_guesses = [stated](const Place&, const Excitation&) { return guesses_of(*stated); },
          .perturbation = perturbation_of(*stated)};
}

}  // namespace plumbline::diagnose
