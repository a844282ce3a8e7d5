#include "diagnose/motion/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/motion/judgement.hpp"
#include "diagnose/motion/repeats.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::motion {
namespace {

using diagnose::CauseVerdict, diagnose::Posterior;

std::vector<Estimate> estimates(const Hypothesis& h, std::size_t from, std::size_t to, double temper) {
  constexpr double two_sided = 1.959964;  // 95 %
  std::vector<Estimate> all;
  for (std::size_t p = from; p < to; ++p) {
    const diagnose::ParameterRange& range = h.parameters[p].range;
    const auto k = static_cast<Eigen::Index>(p);
    const double half = two_sided * std::sqrt(std::max(0.0, h.covariance(k, k)) / temper);
    all.push_back({std::string(range.name), std::string(range.unit), h.values[p],
                   std::max(range.low, h.values[p] - half), std::min(range.high, h.values[p] + half),
                   static_cast<bool>(h.at_bound[p])});
  }
  return all;
}

NamedCause named(const Study& study, const Hypothesis& h, double probability, double temper) {
  NamedCause cause{{}, probability, study.drive(h.parameters, h.values)};
  std::size_t from = study.unknowns();
  for (const Row* row : h.candidate.rows) {
    cause.effects.push_back({std::string(row->id), std::string(row->words),
                             estimates(h, from, from + row->parameters.size(), temper)});
    from += row->parameters.size();
  }
  return cause;
}

/// The rows of the leading hypothesis that are part of the cause whichever else acts, fitted without the
/// others; nothing where none is.
Hypothesis certain_part(const Study& study, const Findings& findings, const Posterior& posterior) {
  const Hypothesis& leading = findings.hypotheses[posterior.leading];
  Candidate candidate;
  Start start{
      {leading.values.begin(), leading.values.begin() + static_cast<std::ptrdiff_t>(study.unknowns())},
      leading.begins};
  std::size_t from = study.unknowns();
  for (const Row* row : leading.candidate.rows) {
    if (posterior.effects.at(std::string(row->id)) >= diagnose::priors::part_of_it) {
      candidate.rows.push_back(row);
      for (std::size_t p = 0; p < row->parameters.size(); ++p)
        start.values.push_back(leading.values[from + p]);
    }
    from += row->parameters.size();
  }
  return fitted(study, *findings.likelihood, candidate, start);
}

/// Why something is left beside a cause that is named; empty where nothing is.
std::string rest_of(const Diagnosis& d, const Hypothesis& named, double sigma) {
  for (std::size_t p = 0; p < named.values.size(); ++p)
    if (named.at_bound[p] && named.values[p] != 0) return "a value stands at the end of its range";
  const bool held_out =
      std::any_of(d.errors.begin(), d.errors.end(), [](const LogError& one) { return one.held_out; });
  const LogError mean = d.mean(held_out);
  const bool whole = mean.after <= std::max(diagnose::priors::whole_cause_leaves * mean.before, 2 * sigma);
  return whole ? "" : "the rest is outside the catalogue";
}

/// The rows that surely act beside a cause, too little to be named.
std::vector<MinorEffect> beside(const NamedCause& cause, const Study& study, const Posterior& posterior) {
  std::vector<MinorEffect> all;
  for (const Row& row : study.rows()) {
    const auto found = posterior.effects.find(std::string(row.id));
    const bool is_named = std::any_of(cause.effects.begin(), cause.effects.end(),
                                      [&](const NamedEffect& one) { return one.id == row.id; });
    if (found != posterior.effects.end() && found->second >= diagnose::priors::part_of_it && !is_named)
      all.push_back({std::string(row.id), std::string(row.words), std::min(1.0, found->second)});
  }
  return all;
}

std::optional<double> repeatability_of(const Bench& bench) {
  std::vector<const MotionLog*> all;
  for (const std::vector<MotionLog>* logs : {&bench.logs, &bench.held_out})
    for (const MotionLog& log : *logs) all.push_back(&log);
  return repeatability(all);
}

std::vector<LogError> errors_of(const Bench& bench, const Drive<double>& before, const Drive<double>& after) {
  std::vector<LogError> all;
  for (const bool held_out : {false, true})
    for (const MotionLog& log : held_out ? bench.held_out : bench.logs)
      all.push_back({log.name, held_out, error_of(before, log), error_of(after, log)});
  return all;
}

}  // namespace

LogError Diagnosis::mean(bool held_out) const {
  LogError sum{"", held_out, 0, 0};
  double count = 0;
  for (const LogError& one : errors)
    if (one.held_out == held_out) sum.before += one.before, sum.after += one.after, ++count;
  if (count > 0) sum.before /= count, sum.after /= count;
  return sum;
}

Diagnosis diagnose_motion(const Study& study, const std::function<void(double)>& progress) {
  const Findings findings = search(study, progress);
  const Posterior posterior = motion::posterior(study, findings);
  const diagnose::Verdict verdict = decide(posterior);
  Diagnosis result;
  result.name = study.bench().name;
  result.look = look_at(study.bench().logs);
  result.verdict = verdict.verdict;
  result.gap = 1 - posterior.no_gap;
  result.seen_gap = posterior.seen_gap;
  result.outside = posterior.outside;
  result.or_outside = verdict.or_outside;
  constexpr std::size_t most_ranked = 8;
  for (const diagnose::CauseProbability& one : posterior.causes)
    if (result.ranking.size() < most_ranked)
      result.ranking.push_back(
          named(study, findings.hypotheses[one.hypothesis], one.probability, posterior.temper));
  result.causes.assign(result.ranking.begin(), result.ranking.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                            verdict.named, most_ranked)));
  Hypothesis best =
      verdict.named > 0 ? findings.hypotheses[posterior.causes.front().hypothesis] : findings.nominal;
  if (result.verdict == CauseVerdict::unknown && posterior.leading != diagnose::Way::none) {
    Hypothesis part = certain_part(study, findings, posterior);
    if (!part.candidate.rows.empty()) {
      double least = 1;
      for (const Row* row : part.candidate.rows)
        least = std::min(least, posterior.effects.at(std::string(row->id)));
      result.verdict = CauseVerdict::partial;
      result.or_outside = false;
      result.causes = {named(study, part, least, posterior.temper)};
      best = std::move(part);
    }
  }
  if (!result.causes.empty()) result.beside = beside(result.causes.front(), study, posterior);
  result.before = estimates(findings.nominal, 0, study.unknowns(), posterior.temper);
  result.after = estimates(best, 0, study.unknowns(), posterior.temper);
  result.spread = best.look.best.amplitude;
  result.drive = study.drive(best.parameters, best.values);
  result.without = study.drive(findings.nominal.parameters, findings.nominal.values);
  result.errors = errors_of(study.bench(), result.without, result.drive);
  result.phases = errors_by_phase(study.bench().logs, result.without, result.drive);
  result.repeatability = repeatability_of(study.bench());
  result.channels = study.bench().channels;
  if (!result.causes.empty()) result.rest = rest_of(result, best, study.bench().sigma);
  if (result.verdict == CauseVerdict::identified && !result.rest.empty())
    result.verdict = CauseVerdict::partial;
  if (result.ranking.size() > 1)
    result.next = next_motion(study.bench(), result.ranking[0].drive, result.ranking[1].drive);
  return result;
}

}  // namespace plumbline::motion
