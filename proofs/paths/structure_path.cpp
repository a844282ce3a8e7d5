#include "proofs/paths/structure_path.hpp"

#include <deque>
#include <random>

namespace plumbline::proofs {
namespace {

BentPoint<double> unloaded(BentTracer<double>& tracer, const BentStructure<double>& model) {
  const auto found = tracer.solver().at_factor(model.rest(), 0, Vector<double>::Constant(model.held(), 0.0));
  if (found && found->negative_directions == 0) return *found;
  auto rest = tracer.solver().settle(model.rest(), 0);
  if (!rest)
    throw Error("unloaded structure", "no rest within 5000 steps of its flow", "a stable equilibrium");
  return *std::move(rest);
}

BentLimits<double> limits_of(const StructureTask& task) {
  BentLimits<double> limits{0, task.last};
  limits.longest = task.step;
  return limits;
}

/// Whether a point lies on a branch: between two of its points at its factor.
bool on(const BentBranch<double>& branch, const BentPoint<double>& point, double last) {
  const auto between = [&](const BentPoint<double>& a, const BentPoint<double>& b) {
    const double span = b.factor - a.factor, near = 1e-9 * last;
    if ((point.factor - a.factor) * (point.factor - b.factor) > near * near) return false;
    const double share = std::abs(span) > near ? (point.factor - a.factor) / span : 0.5;
    const double chord = (b.x - a.x).norm() + 1e-6;
    return (a.x + share * (b.x - a.x) - point.x).norm() < 0.1 * chord + 1e-5;
  };
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    if (between(branch.points[i - 1], branch.points[i])) return true;
  }
  return false;
}

/// Half a turn either way of a passive joint is one shape.
bool is_new(const BentStructure<double>& model, const std::vector<BentPoint<double>>& known,
            const BentPoint<double>& point) {
  return std::none_of(known.begin(), known.end(), [&](const BentPoint<double>& one) {
    return (model.unwound(model.rest() + one.x - point.x) - model.rest()).norm() < 1e-6;
  });
}

}  // namespace

StructurePath follow_slowly(const BentStructure<double>& model, const StructureTask& task) {
  const BentLimits<double> limits = limits_of(task);
  BentTracer<double> tracer(model, limits);
  return {true, load_slowly(tracer, unloaded(tracer, model), limits, task.side), {}};
}

StructurePath follow_all(const BentStructure<double>& model, const StructureTask& task) {
  constexpr std::size_t most = 200;
  const BentLimits<double> limits = limits_of(task);
  BentTracer<double> tracer(model, limits);
  StructurePath path{false, {}, {}};
  std::deque<std::pair<BentPoint<double>, bool>> starts{{unloaded(tracer, model), true}};
  while (!starts.empty() && path.branches.size() < most) {
    const auto [start, growing] = starts.front();
    starts.pop_front();
    const bool known = std::any_of(path.branches.begin(), path.branches.end(),
                                   [&](const auto& branch) { return on(branch, start, task.last); });
    if (known) continue;
    BentBranch<double> branch = tracer.run(start, growing);
    if (branch.end == BentEnd::stuck) path.warnings.emplace_back("a branch could not be followed to its end");
    for (const auto& event : branch.events) {
      if (event.kind != BentEventKind::bifurcation) continue;
      for (const auto& beside : tracer.leave(event, 1e-3)) {
        starts.emplace_back(beside, true);
        starts.emplace_back(beside, false);
      }
    }
    path.branches.push_back(std::move(branch));
  }
  if (!starts.empty() && path.branches.size() == most)
    path.warnings.emplace_back("more than 200 branches: the rest is left out");
  return path;
}

std::vector<BentPoint<double>> find_equilibria(const BentStructure<double>& model, double factor,
                                               std::size_t starts, double turn, std::uint64_t seed) {
  BentSolver<double> solver(model);
  std::mt19937_64 random(seed);
  std::vector<BentPoint<double>> found;
  const Vector<double> rest = model.rest(), none = Vector<double>::Constant(model.held(), 0.0);
  for (std::size_t s = 0; s < starts; ++s) {
    Vector<double> x = rest;
    if (s > 0) {
      for (Eigen::Index i = 0; i < x.size(); ++i)
        x(i) += turn * (2.0 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1);
    }
    auto point = solver.at_factor(x, factor, none);
    if (!point) continue;
    point->x = model.unwound(point->x);
    if ((point->x - rest).cwiseAbs().maxCoeff() <= turn && is_new(model, found, *point))
      found.push_back(*point);
  }
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return model.potential(a.x, factor) < model.potential(b.x, factor);
  });
  return found;
}

}  // namespace plumbline::proofs
