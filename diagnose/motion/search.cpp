#include "diagnose/motion/search.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/priors.hpp"

namespace plumbline::motion {
namespace {

/// Hypotheses of each size beside which a further row is looked for, and the rows beside each of them whose
/// forecasts are fitted: more costs time alone.
constexpr std::size_t seeds = 4, fitted_beside = 7;
/// Hypotheses that are fitted again with rows left out.
constexpr std::size_t simplified = 3;

bool more_evidence(const Hypothesis& a, const Hypothesis& b) {
  return a.log_evidence() > b.log_evidence();
}

/// A likelihood in whose sizes the whole motion is the unit: for fits from far away.
Likelihood far_likelihood(const Study& study) {
  Quantities units{study.sizes().angle};
  std::copy(study.sizes().beside.begin(), study.sizes().beside.end(), units.begin() + 1);
  return Likelihood(units, study.sizes().angle);
}

/// The nominal model from several sizes of its unknown numbers.
Hypothesis nominal_fit(const Study& study, const Likelihood& likelihood) {
  Hypothesis best;
  for (const double factor : {0.1, 0.3, 1.0, 3.0}) {
    Start start{{}, study.rough_begins()};
    for (const Parameter& one : study.parameters({})) start.values.push_back(factor * one.guess);
    Hypothesis one = fitted(study, likelihood, {}, start);
    if (best.look.log_by_amplitude.empty() || more_evidence(one, best)) best = std::move(one);
    if (start.values.empty()) break;
  }
  if (!std::isfinite(best.look.log_likelihood))
    throw Error("the logs", "no start from which the drive's unknown numbers follow them",
                "commands in the unit of the position, and gains in duty per rad");
  return best;
}

/// Some of the logs of a bench, evenly spread: enough for fits that other ones begin at.
Bench some_of(const Bench& bench) {
  constexpr std::size_t logs_suffice = 12;
  const std::size_t every = (bench.logs.size() + logs_suffice - 1) / logs_suffice;
  Bench some = bench;
  some.logs.clear();
  for (std::size_t i = 0; i < bench.logs.size(); i += every) some.logs.push_back(bench.logs[i]);
  return some;
}

std::set<const Row*> rows_of(const Candidate& candidate) {
  return {candidate.rows.begin(), candidate.rows.end()};
}

class Searcher {
 public:
  explicit Searcher(const Study& study) : study_(study), short_study_(some_of(study.bench()), short_segment) {
    const Hypothesis rough =
        fitted(study, far_likelihood(study), {},
               {nominal_fit(short_study_, far_likelihood(study)).values, study.rough_begins()});
    Quantities units = sizes_of(study.left(rough.parameters, rough.values, rough.begins));
    const Quantities least = study.sigmas();
    for (std::size_t q = 0; q < quantity_count; ++q) units[q] = std::max(units[q], least[q]);
    found_.likelihood =
        std::make_shared<Likelihood>(units, diagnose::priors::typical_outside * study.sizes().angle,
                                     study.numerical_errors(rough.parameters, rough.values, rough.begins));
    short_likelihood_ = std::make_shared<Likelihood>(
        units, diagnose::priors::typical_outside * study.sizes().angle,
        short_study_.numerical_errors(rough.parameters, rough.values, short_study_.rough_begins()));
    found_.nominal = fitted(study, *found_.likelihood, {}, {rough.values, rough.begins});
  }

  Findings run(const std::function<void(double)>& report) {
    std::vector<const Hypothesis*> nominal{&found_.nominal};
    std::vector<Hypothesis> level = extended(nominal, [&](double share) { report(0.2 * share); });
    for (std::size_t size = 2; size <= diagnose::priors::causes.size(); ++size) {
      std::vector<const Hypothesis*> best;
      for (const Hypothesis& h : level)
        if (best.size() < seeds) best.push_back(&h);
      std::vector<Hypothesis> larger =
          extended(best, [&](double share) { report(0.2 + 0.4 * (static_cast<double>(size) - 2 + share)); });
      keep(std::move(level));
      level = std::move(larger);
    }
    keep(std::move(level));
    std::sort(found_.hypotheses.begin(), found_.hypotheses.end(), more_evidence);
    simplify();
    leave_out_idle();
    return std::move(found_);
  }

 private:
  /// A candidate to be fitted.
  struct Task {
    Candidate candidate;
    Start start;
    double promise = 0;
  };

  void keep(std::vector<Hypothesis> level) {
    for (Hypothesis& h : level) found_.hypotheses.push_back(std::move(h));
  }

  /// Fits what explains most again, each row left out in turn, and so on down to the nominal model: from the
  /// values of the richer cause the simpler one may be reached where from its own start it was not.
  void simplify() {
    std::vector<Hypothesis> richer(found_.hypotheses.begin(),
                                   found_.hypotheses.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                   simplified, found_.hypotheses.size())));
    std::set<std::set<const Row*>> tried;
    while (!richer.empty()) {
      const Hypothesis from = std::move(richer.back());
      richer.pop_back();
      for (std::size_t row = 0; row < from.candidate.rows.size(); ++row) {
        Task task = without(from, row);
        if (!tried.insert(rows_of(task.candidate)).second) continue;
        Hypothesis one = fitted(study_, *found_.likelihood, task.candidate, std::move(task.start));
        if (!std::isfinite(one.log_evidence())) continue;
        richer.push_back(one);
        replace(std::move(one));
      }
    }
    std::sort(found_.hypotheses.begin(), found_.hypotheses.end(), more_evidence);
  }

  /// Leaves out rows alone that the logs would not show at their typical size, and rows together that are no
  /// likelier than without one of them.
  void leave_out_idle() {
    constexpr double noticed = 1;  // nat
    const auto is_idle = [&](const Hypothesis& one) {
      if (one.candidate.rows.size() == 1) return !one.shows;
      const std::set<const Row*> rows = rows_of(one.candidate);
      return std::any_of(found_.hypotheses.begin(), found_.hypotheses.end(), [&](const Hypothesis& other) {
        const std::set<const Row*> some = rows_of(other.candidate);
        return some.size() < rows.size() &&
               std::includes(rows.begin(), rows.end(), some.begin(), some.end()) &&
               other.look.log_likelihood > one.look.log_likelihood - noticed;
      });
    };
    std::vector<Hypothesis> noticed_ones;
    for (const Hypothesis& one : found_.hypotheses)
      if (!is_idle(one)) noticed_ones.push_back(one);
    found_.hypotheses = std::move(noticed_ones);
  }

  Task without(const Hypothesis& from, std::size_t row) const {
    Task task{from.candidate, {from.values, from.begins}};
    std::size_t first = study_.unknowns();
    for (std::size_t i = 0; i < row; ++i) first += from.candidate.rows[i]->parameters.size();
    const auto begin = task.start.values.begin() + static_cast<std::ptrdiff_t>(first);
    task.start.values.erase(begin,
                            begin + static_cast<std::ptrdiff_t>(from.candidate.rows[row]->parameters.size()));
    task.candidate.rows.erase(task.candidate.rows.begin() + static_cast<std::ptrdiff_t>(row));
    return task;
  }

  /// In the place of the fit of the same rows, where it has more evidence.
  void replace(Hypothesis one) {
    if (one.candidate.rows.empty()) {
      if (more_evidence(one, found_.nominal)) found_.nominal = std::move(one);
      return;
    }
    const auto same = std::find_if(
        found_.hypotheses.begin(), found_.hypotheses.end(),
        [&](const Hypothesis& other) { return rows_of(other.candidate) == rows_of(one.candidate); });
    if (same == found_.hypotheses.end()) {
      found_.hypotheses.push_back(std::move(one));
    } else if (more_evidence(one, *same)) {
      *same = std::move(one);
    }
  }

  /// Each of these with one row more; most evidence first.
  std::vector<Hypothesis> extended(const std::vector<const Hypothesis*>& from,
                                   const std::function<void(double)>& report) {
    std::vector<Hypothesis> level;
    std::set<std::set<const Row*>> tried;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::vector<Task> tasks = tasks_beside(*from[i], tried);
      for (std::size_t k = 0; k < tasks.size(); ++k) {
        report((static_cast<double>(i) + static_cast<double>(k) / static_cast<double>(tasks.size())) /
               static_cast<double>(from.size()));
        Hypothesis one = from_afar(tasks[k]);
        if (std::isfinite(one.log_evidence())) level.push_back(std::move(one));
      }
    }
    std::sort(level.begin(), level.end(), more_evidence);
    return level;
  }

  /// A fit; of a row alone, whose numbers may be far from those without it, by way of short segments.
  Hypothesis from_afar(const Task& task) const {
    Start start = task.start;
    if (task.candidate.rows.size() == 1)
      start.values = fitted(short_study_, *short_likelihood_, task.candidate,
                            {start.values, short_study_.rough_begins()})
                         .values;
    return fitted(study_, *found_.likelihood, task.candidate, std::move(start));
  }

  /// Every row beside the nominal model; the most promising ones beside a cause.
  std::vector<Task> tasks_beside(const Hypothesis& lead, std::set<std::set<const Row*>>& tried) const {
    std::vector<Task> tasks;
    for (const Row& row : study_.rows()) {
      Task task{lead.candidate, {lead.values, lead.begins}};
      task.candidate.rows.push_back(&row);
      for (const Parameter& one : row.parameters) task.start.values.push_back(one.guess);
      if (lead.candidate.has(row) || shares_a_term(lead.candidate, row) ||
          task.start.values.size() > most_parameters || tried.count(rows_of(task.candidate)) > 0)
        continue;
      if (!lead.candidate.rows.empty())
        task.promise = forecast(study_, *found_.likelihood, task.candidate, task.start, lead.look.best);
      tasks.push_back(std::move(task));
    }
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const Task& a, const Task& b) { return a.promise > b.promise; });
    if (!lead.candidate.rows.empty() && tasks.size() > fitted_beside) tasks.resize(fitted_beside);
    for (const Task& task : tasks) tried.insert(rows_of(task.candidate));
    return tasks;
  }

  /// Whether a row changes what another one of these changes already: then they are forms of one cause.
  static bool shares_a_term(const Candidate& candidate, const Row& row) {
    const std::set<Term> own = terms_of(row);
    return std::any_of(candidate.rows.begin(), candidate.rows.end(), [&](const Row* other) {
      const std::set<Term> theirs = terms_of(*other);
      return std::any_of(own.begin(), own.end(), [&](Term t) { return theirs.count(t) > 0; });
    });
  }

  const Study& study_;
  const Study short_study_;
  std::shared_ptr<const Likelihood> short_likelihood_;
  Findings found_;
};

}  // namespace

Findings search(const Study& study, const std::function<void(double)>& progress) {
  return Searcher(study).run([&](double share) {
    if (progress) progress(share);
  });
}

}  // namespace plumbline::motion
