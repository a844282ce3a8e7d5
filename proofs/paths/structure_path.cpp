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
    throw Error("unloaded structure", "no rest within 20 000 linear systems of its flow",
                "a stable equilibrium");
  return *std::move(rest);
}

[[noreturn]] void refuse_singular() {
  throw Error("unloaded structure",
              "constraints that are dependent in this shape and not beside it, so that small motion does not "
              "tell whether it is stable",
              "supports, ends and axes that are independent, or dependent in every shape");
}

/// Where a path begins.
BentPoint<double> regular_start(BentTracer<double>& tracer, const BentStructure<double>& model) {
  BentPoint<double> start = unloaded(tracer, model);
  if (tracer.is_singular_at(start.x)) refuse_singular();
  return start;
}

BentTracer<double>::Judge judge_in(const BentStructure<Mpfr50>& wide) {
  return [&wide](const Vector<double>& x) { return is_singular(wide, x); };
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

/// Half a turn either way of a passive joint is one shape. A singular one is known to half the digits that
/// what is held is held to.
bool is_new(const BentStructure<double>& model, const std::vector<SampledEquilibrium>& known,
            const SampledEquilibrium& found) {
  return std::none_of(known.begin(), known.end(), [&](const SampledEquilibrium& one) {
    const double near = one.singular && found.singular ? 1e-4 : 1e-6;
    return (model.unwound(model.rest() + one.point.x - found.point.x) - model.rest()).norm() < near;
  });
}

}  // namespace

void require_regular_line(SpaceStructure<Rational> structure) {
  structure.loads.clear();
  structure.torque.reset();  // it has no energy, which is not asked for
  const auto wide = bent_structure(from_rational<Mpfr50>(structure));
  if (is_singular(wide, wide.rest())) refuse_singular();
}

StructurePath follow_slowly(const BentStructure<double>& model, const BentStructure<Mpfr50>& wide,
                            const StructureTask& task) {
  const BentLimits<double> limits = limits_of(task);
  BentTracer<double> tracer(model, limits, judge_in(wide));
  return {true, load_slowly(tracer, regular_start(tracer, model), limits, task.side), {}};
}

StructurePath follow_all(const BentStructure<double>& model, const BentStructure<Mpfr50>& wide,
                         const StructureTask& task) {
  constexpr std::size_t most = 200;
  const BentLimits<double> limits = limits_of(task);
  BentTracer<double> tracer(model, limits, judge_in(wide));
  StructurePath path{false, {}, {}};
  std::deque<std::pair<BentPoint<double>, bool>> starts{{regular_start(tracer, model), true}};
  while (!starts.empty() && path.branches.size() < most && !tracer.is_spent()) {
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
  if (!starts.empty())
    path.warnings.push_back("more than " +
                            (tracer.is_spent() ? std::to_string(limits.solves) + " linear systems"
                                               : std::to_string(most) + " branches") +
                            ": the rest is left out");
  return path;
}

std::vector<SampledEquilibrium> find_equilibria(const BentStructure<double>& model,
                                                const BentStructure<Mpfr50>& wide, double factor,
                                                std::size_t starts, double turn, std::uint64_t seed) {
  BentSolver<double> solver(model);
  std::mt19937_64 random(seed);
  std::vector<SampledEquilibrium> found;
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
    if ((point->x - rest).cwiseAbs().maxCoeff() > turn) continue;
    SampledEquilibrium one{*std::move(point), false};
    if (!is_new(model, found, one)) continue;
    one.singular = is_singular(wide, one.point.x);
    if (is_new(model, found, one)) found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return model.potential(a.point.x, factor) < model.potential(b.point.x, factor);
  });
  return found;
}

}  // namespace plumbline::proofs
