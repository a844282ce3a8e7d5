#include "trial/simulator/draw_scatter.hpp"

#include <algorithm>

namespace plumbline::simulator {
namespace {

/// Ratio of the true to the declared sigma.
void draw_sigmas(Scatter& scatter, const Plan& plan, double force, double wrong, Random& random) {
  const Sigma is{force / random.log_uniform(60, 900), plan.reach() * random.log_uniform(1e-4, 6e-4),
                 random.log_uniform(7e-4, 2e-3)};
  scatter.declared = {significant(is.force, 3), significant(is.position, 3), significant(is.angle, 3)};
  scatter.sigma = {scatter.declared.force * wrong, scatter.declared.position * wrong,
                   scatter.declared.angle * wrong};
  scatter.missing = random.chance(0.1) ? random.uniform(0.02, 0.06) : 0;
  scatter.resolution = random.uniform(0.1, 0.5);
}

/// A channel that is measured in every run with an imposed end point.
std::string draw_channel(const Plan& plan, Random& random) {
  std::vector<std::string> names{"Fx"};
  if (plan.cross_force_measured) names.emplace_back("Fy");
  for (std::size_t j = 0; j < plan.size() && plan.angles_measured; ++j)
    names.push_back("q" + std::to_string(j + 1));
  return random.one_of(names);
}

void remember(Scatter& scatter, double correlation) {
  scatter.correlation = {correlation, correlation, correlation};
}

/// A filter in one sensor alone: load cell, encoders or camera.
void forget_but_one(Scatter& scatter, const Plan& plan, Random& random) {
  const auto is_loaded = [](const PlannedRun& run) { return run.force_controlled; };
  std::vector<double Sigma::*> has;
  if (!std::all_of(plan.runs.begin(), plan.runs.end(), is_loaded)) has.push_back(&Sigma::force);
  if (plan.angles_measured) has.push_back(&Sigma::angle);
  if (std::any_of(plan.runs.begin(), plan.runs.end(), is_loaded)) has.push_back(&Sigma::position);
  double Sigma::*filtered = random.one_of(has);
  const double correlation = scatter.correlation.*filtered;
  scatter.correlation = {};
  scatter.correlation.*filtered = correlation;
}

}  // namespace

Scatter draw_scatter(const Plan& plan, double force, Random& random) {
  Scatter scatter;
  const double kind = random.uniform(0, 1);
  double wrong = 1;
  if (kind < 0.18) {
    scatter.kind = "misdeclared";
    wrong = random.log_uniform(1 / 1.5, 1.5);
  } else if (kind < 0.30) {
    scatter.kind = "outliers";
    scatter.outliers = random.uniform(0.01, 0.02);
  } else if (kind < 0.40) {
    scatter.kind = "ar1";
    remember(scatter, random.uniform(0.4, 0.8));
  }
  draw_sigmas(scatter, plan, force, wrong, random);
  return scatter;
}

Scatter draw_rough_scatter(const Plan& plan, double force, Random& random) {
  Scatter scatter;
  const double kind = random.uniform(0, 1);
  double wrong = 1;
  if (kind < 0.15) {
    scatter.kind = "larger than declared";
    wrong = random.log_uniform(1.5, 3);
  } else if (kind < 0.25) {
    scatter.kind = "smaller than declared";
    wrong = random.log_uniform(1.0 / 3, 0.5);
  } else if (kind < 0.37) {
    scatter.kind = "outliers";
    scatter.outliers = random.uniform(0.02, 0.08);
  } else if (kind < 0.49) {
    scatter.kind = "ar1";
    remember(scatter, random.uniform(0.7, 0.9));
    if (random.chance(0.5)) {
      scatter.kind = "ar1 of one sensor";
      forget_but_one(scatter, plan, random);
    }
  } else if (kind < 0.59) {
    scatter.kind = "proportional";
  } else if (kind < 0.69) {
    scatter.kind = "interference";
    scatter.interference = random.log_uniform(1, 4);
    scatter.interference_period = random.log_uniform(1.5, 40);
  } else if (kind < 0.79) {
    scatter.kind = "one channel";
    scatter.bad_channel = draw_channel(plan, random);
    scatter.bad_factor = random.log_uniform(2, 4);
  }
  draw_sigmas(scatter, plan, force, wrong, random);
  if (scatter.kind == "proportional") {
    const double at_largest = random.log_uniform(2, 8);  // sigmas
    constexpr double widest = 1;                         // rad
    scatter.proportional = {at_largest * scatter.sigma.force / force,
                            at_largest * scatter.sigma.position / plan.reach(),
                            at_largest * scatter.sigma.angle / widest};
  }
  return scatter;
}

}  // namespace plumbline::simulator
