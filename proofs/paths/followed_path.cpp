#include "proofs/paths/followed_path.hpp"

#include <fmt/core.h>

#include <plumbline/branch/branch_tree.hpp>
#include <plumbline/branch/point_at_load.hpp>
#include <plumbline/branch/slow_loading.hpp>
#include <plumbline/branch/straight_start.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/census/census.hpp"
#include "proofs/paths/measures.hpp"

namespace plumbline::proofs {
namespace {

using Model = NominalModel<double>;

constexpr std::size_t most_links_for_census = 5;
constexpr std::size_t most_points = 200000;      ///< of a branch, each way
constexpr std::size_t most_angles = 10'000'000;  ///< in all points of all branches: some 200 MB

/// The states that the paths begin with; the first is where the unloaded chain is, or goes.
std::vector<BranchPoint<double>> starts_of(Brancher<Model>& brancher, const PathTask& task) {
  const bool held = task.loading.control == Control::end_point;
  if (!held || !is_straight(task.chain)) return {brancher.start(0, absolute_angles(task.chain.rest()))};
  if (!(task.loading.direction.x < 0) || task.loading.direction.y != 0)
    throw Error("load", "a straight chain that is not pushed along its axis", "compression alone");
  auto starts = straight_starts(brancher, 1e-4 * task.last);
  if (task.side < 0) std::swap(starts[0], starts[1]);
  return starts;
}

/// Further starts, from branches that may hang together with no other.
void add_census(std::vector<BranchPoint<double>>& starts, Brancher<Model>& brancher, const PathTask& task,
                std::vector<std::string>& warnings) {
  if (task.chain.size() > most_links_for_census) {
    warnings.push_back(
        "no census for more than five links: branches apart from the unloaded shape are missing");
    return;
  }
  const auto exact = [](double x) { return Interval::from_double(x); };
  const auto middle = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const auto enclosed = convert<Interval>(task.chain, exact);
  for (const double load : {task.last, 0.50000013 * task.last, 0.02 * task.last}) {
    const Point<double> at = task.loading.at(load);
    const Point<Interval> load_exactly{exact(at.x), exact(at.y)};
    try {
      const Census census = task.loading.control == Control::end_point
                                ? census_at_end_point(enclosed, load_exactly)
                                : census_under_force(enclosed, load_exactly);
      for (const auto& one : census.equilibria) {
        std::vector<double> q;
        for (const Interval& angle : one.q) q.push_back(middle(angle));
        starts.push_back(brancher.start(load, absolute_angles(q), {middle(one.fx), middle(one.fy)}));
      }
    } catch (const Error& error) {
      warnings.push_back(fmt::format("no census at load {}: {}", load, error.what()));
    }
  }
}

std::vector<Branch<double>> slow_branches(const PathTask& task) {
  const Model model(task.chain);
  Brancher<Model> brancher(model, task.loading, absolute_angles(task.chain.rest()));
  const auto starts = starts_of(brancher, task);
  return load_slowly(brancher, starts[0], {starts[0].load, task.last, task.step, most_points}, task.side);
}

std::vector<Branch<double>> all_branches(const PathTask& task, std::vector<std::string>& warnings) {
  const Model model(task.chain);
  Brancher<Model> brancher(model, task.loading, absolute_angles(task.chain.rest()));
  auto starts = starts_of(brancher, task);
  const double first = starts[0].load;
  add_census(starts, brancher, task, warnings);
  const std::size_t most = most_angles / task.chain.size() + 1;
  const auto branches = branch_tree(brancher, std::move(starts),
                                    {first, task.last, task.step, std::min(most_points, most)}, most);
  std::size_t points = 0;
  for (const Branch<double>& branch : branches) points += branch.points.size();
  if (points >= most)
    warnings.push_back(
        fmt::format("stopped after {} branches of {} points in all: there may be more (a lower load or a "
                    "longer --step reaches them)",
                    branches.size(), points));
  return branches;
}

PathTask measured(PathTask task, const Measures& m) {
  task.last /= m.load(task.loading.control);
  task.chain = measured(task.chain, m);
  task.loading = measured(task.loading, m);
  return task;
}

PathReport reported(const PathTask& task, const Measures& m, bool history,
                    const std::vector<Branch<double>>& branches, std::vector<std::string> warnings) {
  PathReport report{"", task.loading, task.last, history, {}, std::move(warnings)};
  for (const Branch<double>& branch : branches)
    report.branches.push_back(measured(branch, m.inverse(), task.loading.control));
  return report;
}

}  // namespace

std::string_view name(BranchEnd end) {
  switch (end) {
    case BranchEnd::load:
      return "end of the load window";
    case BranchEnd::closed:
      return "closed";
    case BranchEnd::unstable:
      return "stability lost";
    case BranchEnd::unbounded:
      return "force unbounded: links in one line";
    case BranchEnd::degenerate:
      return "degenerate point";
    case BranchEnd::points:
      break;
  }
  return "limit of points";
}

PathReport follow_slowly(const PathTask& task) {
  const Measures m = measures_of(task.chain);
  return reported(task, m, true, slow_branches(measured(task, m)), {});
}

PathReport follow_all(const PathTask& task) {
  const Measures m = measures_of(task.chain);
  std::vector<std::string> warnings;
  const auto branches = all_branches(measured(task, m), warnings);
  return reported(task, m, false, branches, std::move(warnings));
}

BranchPoint<double> state_at(const PathTask& task, const Branch<double>& branch, double load) {
  return state_at(task, std::vector{branch}, load);
}

BranchPoint<double> state_at(const PathTask& task, const std::vector<Branch<double>>& stretches,
                             double load) {
  const Model model(task.chain);
  Brancher<Model> brancher(model, task.loading, absolute_angles(task.chain.rest()));
  if (const auto found = state_at_load(brancher, stretches, load)) return *found;
  const BranchPoint<double>* nearest = &stretches.front().points.front();
  for (const auto& stretch : stretches) {
    for (const auto& point : stretch.points)
      if (std::abs(point.load - load) < std::abs(nearest->load - load)) nearest = &point;
  }
  return *nearest;
}

}  // namespace plumbline::proofs
