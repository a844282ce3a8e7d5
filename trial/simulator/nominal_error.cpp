#include "trial/simulator/nominal_error.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/loaded/equilibrium.hpp>
#include <plumbline/loaded/nominal_model.hpp>

namespace plumbline::simulator {

double nominal_error(const Plan& plan, const std::vector<std::vector<State>>& states, const Sigma& sigma) {
  std::vector<Point<double>> weight;
  for (const double mass : plan.nominal.mass)
    weight.push_back({mass * plan.nominal.gravity[0], mass * plan.nominal.gravity[1]});
  double worst = 0;
  const auto compare = [&](double one, double other, double unit) {
    if (unit > 0) worst = std::max(worst, std::abs(one - other) / unit);
  };
  for (std::size_t r = 0; r < states.size(); ++r) {
    const PlannedRun& run = plan.runs[r];
    const NominalModel<double> model(Chain<double>(plan.nominal.length, plan.nominal.stiffness, run.rest),
                                     weight);
    EquilibriumSolver solver(model);
    for (std::size_t i = 0; i < states[r].size(); ++i) {
      const State& state = states[r][i];
      const Pair& told = run.commands[i].value;
      const std::vector<double> theta = orientations(state.q);
      Vector<double> guess =
          Eigen::Map<const Vector<double>>(theta.data(), static_cast<Eigen::Index>(theta.size()));
      const Equilibrium<double> exact =
          run.force_controlled
              ? solver.under_force({told[0], told[1]}, guess)
              : solver.at_end_point({told[0], told[1]}, guess, {state.force[0], state.force[1]});
      if (run.force_controlled) {
        compare(state.end_point[0], exact.end_point.x, sigma.position);
        compare(state.end_point[1], exact.end_point.y, sigma.position);
      } else {
        compare(state.force[0], exact.force.x, sigma.force);
        compare(state.force[1], exact.force.y, sigma.force);
      }
      for (std::size_t j = 0; j < theta.size(); ++j)
        compare(state.q[j],
                exact.theta(static_cast<Eigen::Index>(j)) -
                    (j > 0 ? exact.theta(static_cast<Eigen::Index>(j) - 1) : 0),
                sigma.angle);
    }
  }
  return worst;
}

}  // namespace plumbline::simulator
