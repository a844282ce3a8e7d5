#include "diagnose/rig/branches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::diagnose {
namespace {

constexpr double imperfection = 0.01;  // rad: angles are assembled to a degree
constexpr double elsewhere = 0.05;     // rad: farther than the imperfection itself moves a joint
constexpr double noticed = 9;          // mean square in declared noise: three deviations
constexpr double clearly = 16;         // squares: a quarter of the residual

/// One run of the experiment, on its own.
Experiment alone(const Experiment& experiment, const Run& run) {
  Experiment one = experiment;
  one.runs = {run};
  return one;
}

/// Mean square residual of a prediction, in declared sigmas; infinite where the prediction fails.
double left(const Study& study, const Prediction& predicted) {
  if (!predicted.reached) return std::numeric_limits<double>::infinity();
  double sum = 0, count = 0;
  for (const double z : study.residual(predicted)) sum += z * z, count += 1;
  return count > 0 ? sum / count : 0;
}

/// Joint angles of one run.
auto angles(const Trace& trace, Eigen::Index joints) {
  return trace.middleCols(column_q, joints);
}

/// The sides to which two paths of the one run go; nothing where they are the same.
std::optional<Branch> branch_of(const Trace& there, const Trace& other, Eigen::Index joints) {
  Branch branch{{}, angles(there, joints), angles(other, joints), there.middleCols(column_Fx, 2)};
  for (Eigen::Index r = 0; r < there.rows(); ++r)
    branch.differs.push_back((branch.angles.row(r) - branch.other_angles.row(r)).abs().maxCoeff() >
                             elsewhere);
  return branch.first() < branch.differs.size() ? std::optional(branch) : std::nullopt;
}

/// The branch of the readings of a single run; nothing where the nominal chain follows it by itself.
std::optional<Branch> branch_of(const Experiment& one) {
  const Study study(one);
  const double now = left(study, study.nominal());
  if (now < noticed) return std::nullopt;
  double least = now / clearly;
  std::optional<Branch> best;
  const auto try_branch = [&](const Prediction& there, const Prediction& other) {
    if (!there.reached || !other.reached) return;
    Experiment aside = one;
    aside.runs.front().branch =
        branch_of(there.runs.front(), other.runs.front(), std::ssize(one.link_length));
    if (!aside.runs.front().branch) return;
    const Study on_it(aside);
    const double then = left(on_it, on_it.nominal());
    if (then < least) least = then, best = aside.runs.front().branch;
  };
  for (std::size_t j = 0; j < one.link_length.size(); ++j) {
    Experiment up = one, down = one;
    up.runs.front().rest[j] += imperfection;
    down.runs.front().rest[j] -= imperfection;
    const Study above(up), below(down);
    try_branch(above.nominal(), below.nominal());
    try_branch(below.nominal(), above.nominal());
  }
  return best;
}

}  // namespace

Experiment on_observed_branches(const Study& study) {
  Experiment experiment = study.experiment();
  for (Run& run : experiment.runs) run.branch = branch_of(alone(study.experiment(), run));
  return experiment;
}

}  // namespace plumbline::diagnose
