#include "proofs/census/found_equilibria.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "proofs/exact/as_double.hpp"
#include "proofs/exact/span.hpp"
#include "proofs/exact/units.hpp"

namespace plumbline::proofs {
namespace {

constexpr std::size_t most_equilibria = 1000;

/// A number in units of its own, in those of the chain.
Interval::End times(double x, const Interval& unit) {
  return (Interval::from_double(x) * unit).middle();
}

/// As NominalModel does, in the units of the chain.
/// \param unit  of length, that the model is measured in
void require_reach(const NominalModel<double>& model, const Point<double>& place, const Interval& unit) {
  const auto [inner, outer] = reach(model.chain().length());
  const double distance = std::hypot(place.x, place.y);
  const auto text = [&](double x) { return times(x, unit).str(6); };
  if (model.size() > 1 && (!(distance < outer) || (inner > 0 && !(distance > inner))))
    throw Error("end point", "distance " + text(distance) + " from the base",
                "between " + text(inner) + " and " + text(outer) + ", both excluded: the reach of the chain");
  model.require_reach(place);
}

/// What differs by more than full turns of passive joints.
class DistinctShapes {
 public:
  DistinctShapes(const Chain<double>& chain, const Window& window) : chain_(&chain), window_(&window) {}

  void add(Equilibrium<double> one) {
    auto q = joint_angles(one.theta);
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (chain_->passive_joint(i)) q[i] = std::remainder(q[i], 2 * M_PI);
    }
    if (!counted(q) ||
        std::any_of(all.begin(), all.end(), [&](const auto& other) { return same(q, other.second); }))
      return;
    all.emplace_back(std::move(one), std::move(q));
  }

  std::vector<std::pair<Equilibrium<double>, std::vector<double>>> all;

 private:
  [[nodiscard]] bool counted(const std::vector<double>& q) const {
    for (std::size_t i = 0; i < window_->size(); ++i) {
      const Span range((*window_)[i]);
      if (!chain_->passive_joint(i) && !range.contains(q[i])) return false;
    }
    return true;
  }
  [[nodiscard]] bool same(const std::vector<double>& a, const std::vector<double>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double apart = a[i] - b[i];
      if (std::abs(chain_->passive_joint(i) ? std::remainder(apart, 2 * M_PI) : apart) > 1e-6) return false;
    }
    return true;
  }

  const Chain<double>* chain_;
  const Window* window_;
};

}  // namespace

FoundEquilibria find_equilibria(const CensusTask& task) {
  const Chain<Interval> given = enclosed_chain(task);
  const Units units = own_units(given);
  const auto chain = convert<double>(in_units(given, units), as_double);
  const Point<Interval> measured = in_units(enclosed_load(task), task.control(), units);
  const NominalModel<double> model(chain);
  EquilibriumSolver<NominalModel<double>> solver(model);
  const Point<double> at{as_double(measured.x), as_double(measured.y)};
  const bool held = task.control() == Control::end_point;
  if (held) require_reach(model, at, units.length);
  FoundEquilibria answer{{}, {}, 0, false};
  if (held) answer.window = unwound(given, task.turns);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> turn(-3.14159, 3.14159);
  DistinctShapes found(chain, answer.window);
  const std::size_t trials = 1000 * chain.size();
  for (; answer.starts < trials && found.all.size() < most_equilibria; ++answer.starts) {
    std::vector<double> q = chain.rest();
    for (double& angle : q) angle += turn(random) * (answer.starts % 3 == 0 ? 1 : 0.4) * (1 + 2 * task.turns);
    if (answer.starts == 0) q = chain.rest();
    try {
      const auto theta = absolute_angles(q);
      found.add(held ? solver.at_end_point(at, theta) : solver.under_force(at, theta));
    } catch (const Error&) {  // this start leads to no equilibrium
    }
  }
  answer.exhausted = answer.starts == trials;
  std::sort(found.all.begin(), found.all.end(),
            [](const auto& a, const auto& b) { return a.first.energy < b.first.energy; });
  for (const auto& [one, q] : found.all)
    answer.equilibria.push_back({q, times(one.end_point.x, units.length),
                                 times(one.end_point.y, units.length), times(one.force.x, units.force()),
                                 times(one.force.y, units.force()), times(one.energy, units.stiffness),
                                 one.negative_directions});
  return answer;
}

}  // namespace plumbline::proofs
