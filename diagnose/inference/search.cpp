#include "diagnose/inference/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <plumbline/base/parallel.hpp>
#include <set>

#include "diagnose/discrepancy/unknown_torque.hpp"
#include "diagnose/inference/elements.hpp"
#include "diagnose/inference/forecast.hpp"
#include "diagnose/inference/idle.hpp"
#include "diagnose/inference/likelihoods.hpp"
#include "diagnose/inference/prior.hpp"
#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {
namespace {

// ---- Extent of the search: more costs time alone ----
/// Effects beside which a second is looked for; fewer where one leaves nothing to explain.
constexpr std::size_t seeds = 8, seeds_of_enough = 2;
/// Effects beside which tolerances are fitted, pairs beside which a third is looked for, hypotheses that are
/// taken apart.
constexpr std::size_t beside_tolerances = 5, pairs = 6, taken_apart = 4;
/// Forecasts that are fitted: of pairs, of threes, for each effect that is replaced.
constexpr std::size_t fitted_pairs = 16, fitted_threes = 12, fitted_replacements = 8;
/// Hypotheses within so many nats of the best are maximised beside a discrepancy, so many at most.
constexpr double near_best = 25;
constexpr std::size_t refined_at_once = 12, refined_at_last = 24;

constexpr Effort fine{12, 0.03};

/// A rough fit ends where an iteration takes half a per cent off the squares.
Effort rough(std::size_t values) {
  return {12, std::max(0.1, 0.0025 * static_cast<double>(values)), true};
}

bool same(const Candidate& a, const Candidate& b) {
  return a.effects.size() == b.effects.size() &&
         std::is_permutation(a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end());
}

/// A candidate to be fitted.
struct Task {
  Candidate candidate;
  InitialGuesses starts;
  double promise = 0;  ///< forecast of the logarithm of its evidence, at most
};

class Searcher {
 public:
  explicit Searcher(const Study& study)
      : study_(study), nominal_residual_(study.nominal_residual()), listed_(possible_effects(study)) {
    found_.states = std::make_shared<CommandStates>(study.experiment());
    found_.outside = unknown_torques(study);
    found_.untimed = untimed_effects(study);
    listed_.insert(listed_.end(), found_.untimed.begin(), found_.untimed.end());
    set(likelihoods(nominal_residual_, NoiseShape(study.measurements()), Departures::ignored));
  }

  Findings run(const std::function<void(double)>& report) {
    fit_singles([&](double share) { report(0.4 * share); });
    const bool enough = one_cause_is_enough();
    extend(leading_singles(enough ? seeds_of_enough : seeds), fitted_pairs);
    report(0.6);
    fit_beside_tolerances();
    report(0.7);
    if (!found_.hypotheses.empty() && nothing_left(found_.hypotheses.front()) < 0.5)
      extend(leading_pairs(), fitted_threes);
    report(0.8);
    for (int round = 0; round < 2; ++round) take_apart();
    fit_other_orders();
    report(0.9);
    settle();
    simplify();
    drop_idle();
    report(1);
    return std::move(found_);
  }

 private:
  [[nodiscard]] Likelihoods likelihoods(const VectorXd& residual, NoiseShape start, Departures sought) const {
    return {study_, *found_.states, residual, std::move(start), sought};
  }

  void set(Likelihoods likelihoods) {
    in_noise_ = std::move(likelihoods);
    found_.likelihood = in_noise_->full;
    found_.nominal = found_.likelihood->look(nominal_residual_);
  }

  Hypothesis* find(const Candidate& candidate) {
    const auto place = std::find_if(found_.hypotheses.begin(), found_.hypotheses.end(),
                                    [&](const Hypothesis& h) { return same(h.candidate, candidate); });
    return place == found_.hypotheses.end() ? nullptr : &*place;
  }

  /// Probability that nothing is left beside a hypothesis.
  [[nodiscard]] double nothing_left(const Hypothesis& one) const {
    return std::exp(
        log_posterior(one.look.log_by_amplitude, found_.likelihood->priors().log_amplitude).front());
  }

  /// Whether nothing is left beside the leading single cause. Values at every joint imitate several causes at
  /// once, and do not end the search for those.
  [[nodiscard]] bool one_cause_is_enough() const {
    const auto imitates = [](const EffectAt& at) { return !at.effect->within_values.empty(); };
    for (const Hypothesis& one : found_.hypotheses)
      if (std::none_of(one.candidate.effects.begin(), one.candidate.effects.end(), imitates))
        return nothing_left(one) > 0.9;
    return false;
  }

  /// Fits side by side, in white noise and then weighed beside a discrepancy; maximises there what leads.
  void fit(
      const std::vector<Task>& tasks, const std::function<void(double)>& report = [](double) {}) {
    std::vector<Hypothesis> fitted(tasks.size());
    std::size_t done = 0;
    std::mutex one_at_a_time;
    in_parallel(tasks.size(), study_.threads(), [&](std::size_t t) {
      if (affordable(study_, tasks[t].candidate)) {
        fitted[t] = fitted_roughly(tasks[t], *in_noise_->rough);
        // An outlier may be what an effect does, which a fit without it does not see.
        if (in_noise_->all_readings && tasks[t].candidate.effects.size() == 1)
          if (Hypothesis other = fitted_roughly(tasks[t], *in_noise_->all_readings);
              other.converged && !(other.log_evidence < fitted[t].log_evidence && fitted[t].converged))
            fitted[t] = std::move(other);
      }
      const std::lock_guard only(one_at_a_time);
      report(static_cast<double>(++done) / static_cast<double>(tasks.size()));
    });
    for (Hypothesis& one : fitted) add(std::move(one));
    sort();
    refine(refined_at_once, near_best);
  }

  /// Fitted in white noise, and weighed beside a discrepancy.
  [[nodiscard]] Hypothesis fitted_roughly(const Task& task, const Likelihood& white) const {
    Hypothesis one =
        maximised(study_, white, task.candidate, task.starts, rough(study_.measurements().size()));
    if (one.converged) look_again(study_, *found_.likelihood, one);
    return one;
  }

  /// Keeps the better of two fits of one candidate.
  void add(Hypothesis one) {
    if (!one.converged) return;
    if (Hypothesis* const known = find(one.candidate); known == nullptr)
      found_.hypotheses.push_back(std::move(one));
    else if (one.log_evidence > known->log_evidence)
      *known = std::move(one);
  }

  void sort() {
    std::stable_sort(
        found_.hypotheses.begin(), found_.hypotheses.end(),
        [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
  }

  /// Maximises beside a discrepancy what leads, and was not yet.
  void refine(std::size_t most, double near) {
    std::vector<Hypothesis*> leading;
    for (Hypothesis& h : found_.hypotheses)
      if (!h.refined && leading.size() < most &&
          h.log_evidence > found_.hypotheses.front().log_evidence - near)
        leading.push_back(&h);
    in_parallel(leading.size(), study_.threads(), [&](std::size_t i) {
      Hypothesis better =
          maximised(study_, *found_.likelihood, leading[i]->candidate, leading[i]->parameters, fine);
      better.refined = true;
      if (better.converged) *leading[i] = std::move(better);
    });
    sort();
  }

  void fit_singles(const std::function<void(double)>& report) {
    std::vector<Task> tasks;
    for (const EffectAt& at : listed_) tasks.push_back({Candidate{{at}}, initial_guesses(study_, at)});
    for (const Effect& row : *found_.outside)
      for (std::size_t j = 0; j < study_.scales().link_length.size(); ++j)
        if (study_.scales().joint_stiffness[j] > 0)
          tasks.push_back({Candidate{{EffectAt(row, j + 1)}}, initial_guesses(study_, EffectAt(row, j + 1))});
    fit(tasks, report);
    for (const Hypothesis& h : found_.hypotheses)
      if (h.candidate.effects.size() == 1 && !h.candidate.effects.front().effect->outside &&
          h.jacobian.cwiseAbs().maxCoeff() == 0)
        found_.not_excited.push_back(h.candidate.effects.front());
  }

  [[nodiscard]] double squares(const Hypothesis& h) const {
    return in_noise_->weight.cwiseProduct(h.residual).squaredNorm();
  }

  /// The single effects that explain most, those by evidence and those by least squares.
  [[nodiscard]] std::vector<Hypothesis> leading_singles(std::size_t count) const {
    std::vector<const Hypothesis*> by_evidence, by_squares;
    for (const Hypothesis& h : found_.hypotheses)
      if (h.candidate.effects.size() == 1) by_evidence.push_back(&h);
    by_squares = by_evidence;
    std::stable_sort(by_squares.begin(), by_squares.end(),
                     [&](const Hypothesis* a, const Hypothesis* b) { return squares(*a) < squares(*b); });
    std::vector<Hypothesis> result;
    std::set<const Hypothesis*> taken;
    for (std::size_t i = 0; i < std::min(count, by_evidence.size()); ++i)
      for (const Hypothesis* h : {by_evidence[i], by_squares[i]})
        if (taken.insert(h).second) result.push_back(*h);
    return result;
  }

  [[nodiscard]] std::vector<Hypothesis> leading_pairs() const {
    std::vector<Hypothesis> result;
    for (const Hypothesis& h : found_.hypotheses)
      if (h.candidate.count() == 2 && result.size() < pairs) result.push_back(h);
    return result;
  }

  /// Adds an effect of the catalogue to each of some hypotheses, where that promises most.
  void extend(const std::vector<Hypothesis>& from, std::size_t most) {
    std::vector<std::vector<Prospect>> prospects(from.size());
    in_parallel(from.size(), study_.threads(),
                [&](std::size_t s) { prospects[s] = forecast(study_, in_noise_->weight, listed_, from[s]); });
    std::vector<Task> tasks;
    for (std::size_t s = 0; s < from.size(); ++s)
      for (const Prospect& one : prospects[s]) {
        Candidate both = from[s].candidate;
        both.effects.push_back(one.effect);
        if (find(both) == nullptr && affordable(study_, both))
          offer(tasks, {both, one.starts, promise(one.cost, log_prior(study_, both), from[s].log_volume)});
      }
    fit_most_promising(std::move(tasks), most);
  }

  /// Keeps the better of two ways to one candidate.
  static void offer(std::vector<Task>& tasks, Task one) {
    const auto place = std::find_if(tasks.begin(), tasks.end(),
                                    [&](const Task& t) { return same(t.candidate, one.candidate); });
    if (place == tasks.end()) {
      tasks.push_back(std::move(one));
    } else if (one.promise > place->promise) {
      *place = std::move(one);
    }
  }

  /// Log evidence in white noise. The volume of what is extended stands for that of the whole, which is no
  /// larger.
  [[nodiscard]] static double promise(double squares, double log_prior, double log_volume) {
    return -squares / 2 + log_prior + log_volume;
  }

  void fit_most_promising(std::vector<Task> tasks, std::size_t most) {
    constexpr double margin = 3;  // nats, of a linear forecast
    double reached = -std::numeric_limits<double>::infinity();
    for (const Hypothesis& h : found_.hypotheses)
      reached = std::max(reached, promise(squares(h), h.log_prior, h.log_volume));
    std::erase_if(tasks, [&](const Task& t) { return t.promise < reached - margin; });
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const Task& a, const Task& b) { return a.promise > b.promise; });
    if (tasks.size() > most) tasks.resize(most);
    fit(tasks);
  }

  /// Manufacturing tolerances, alone and beside what leads. Those of a joint alone are its own stiffness and
  /// rest, which are causes; those of a calibrated arm are summed out.
  void fit_beside_tolerances() {
    if (study_.scales().axes == 1 || study_.experiment().arm_bench.calibration) return;
    std::vector<Hypothesis> leading = leading_singles(beside_tolerances);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, found_.hypotheses.size()); ++i)
      if (found_.hypotheses[i].candidate.effects.size() > 1) leading.push_back(found_.hypotheses[i]);
    leading.push_back({});  // alone
    std::vector<Task> tasks;
    for (const Hypothesis& h : leading) {
      const bool has_some = std::any_of(h.candidate.effects.begin(), h.candidate.effects.end(),
                                        [](const EffectAt& at) { return at.effect->is_tolerance; });
      if (has_some) continue;
      Candidate both = h.candidate;
      for (const Effect* row : study_.effects())
        if (row->is_tolerance) both.effects.emplace_back(*row);
      std::vector<double> start = h.parameters;
      start.resize(study_.ranges(both).size(), 0.0);
      tasks.push_back({both, {{start}, 1}});
    }
    fit(tasks);
  }

  /// The leading hypotheses without each of their effects, and with every other effect in its place: a set of
  /// hypotheses that lacks an alias of the best would be too sure of it.
  void take_apart() {
    std::vector<Task> parts;
    const auto for_each_leading = [&](const auto& use) {
      for (std::size_t i = 0; i < std::min(taken_apart, found_.hypotheses.size()); ++i)
        if (found_.hypotheses[i].candidate.count() > 1) use(found_.hypotheses[i]);
    };
    for_each_leading([&](const Hypothesis& h) {
      for (const EffectAt& gone : h.candidate.effects) {
        if (h.candidate.has_as_tolerance(gone)) continue;
        const Instance rest =
            part(study_, h.candidate, h.parameters, [&](const EffectAt& at) { return !(at == gone); });
        if (from_whole_.insert(rest.candidate.label()).second)
          parts.push_back({rest.candidate, {{rest.parameters}, 1}});
      }
    });
    fit(parts);
    std::vector<Hypothesis> rests;
    for_each_leading([&](const Hypothesis& h) {
      for (const Hypothesis& rest : found_.hypotheses)
        if (rest.candidate.is_part_of(h.candidate) && rest.candidate.count() + 1 == h.candidate.count() &&
            replaced_.insert(rest.candidate.label()).second)
          rests.push_back(rest);
    });
    extend(rests, fitted_replacements * rests.size());
  }

  /// Where an effect of the leading hypothesis may have other numbers of elements: that hypothesis with every
  /// one of those, and so the best with this effect of each smaller number of causes, since what stands
  /// beside too few elements in place of the others makes the right number of them no better.
  void fit_other_orders() {
    if (found_.hypotheses.empty()) return;
    const Hypothesis lead = found_.hypotheses.front();
    for (const EffectAt& at : lead.candidate.effects) {
      if (!at.effect->orders) continue;
      std::vector<Hypothesis> best{lead};
      for (const Hypothesis& h : found_.hypotheses)
        if (h.candidate.has(at) && h.candidate.count() < best.back().candidate.count()) best.push_back(h);
      for (const Hypothesis& h : best)
        fit_other_orders(h, static_cast<std::size_t>(
                                std::find(h.candidate.effects.begin(), h.candidate.effects.end(), at) -
                                h.candidate.effects.begin()));
    }
  }

  /// One element fewer at a time, down to one, and one more at a time from there.
  void fit_other_orders(const Hypothesis& lead, std::size_t e) {
    const std::vector<const Effect*> rows = lead.candidate.effects[e].effect->orders();
    const auto own = std::find(rows.begin(), rows.end(), lead.candidate.effects[e].effect);
    Hypothesis last = lead;
    const auto step_on = [&](const Effect* row) {
      Task task{last.candidate, initial_guesses_of_order(study_, last, e, *row)};
      task.candidate.effects[e] = EffectAt(*row, last.candidate.effects[e].joint);
      fit({task});
      if (const Hypothesis* found = find(task.candidate)) last = *found;
    };
    std::for_each(std::make_reverse_iterator(own), rows.rend(), step_on);
    std::for_each(rows.begin() + 1, rows.end(), step_on);
  }

  /// The noise beside the best hypothesis. A discrepancy beside a poor one may be more probable than a better
  /// one in the noise of the poor one: the hypothesis of least squares is tried in its own noise too.
  void settle_noise(const NoiseShape& start) {
    const Hypothesis& lead = found_.hypotheses.front();
    const Hypothesis& closest =
        *std::min_element(found_.hypotheses.begin(), found_.hypotheses.end(),
                          [&](const Hypothesis& a, const Hypothesis& b) { return squares(a) < squares(b); });
    Likelihoods noise = likelihoods(lead.residual, start, Departures::sought);
    if (&closest != &lead) {
      const auto evidence = [&](Hypothesis h, const Likelihoods& in) {
        look_again(study_, *in.full, h);
        return h.log_evidence;
      };
      Likelihoods other = likelihoods(closest.residual, start, Departures::sought);
      if (evidence(closest, other) > evidence(lead, noise)) noise = std::move(other);
    }
    set(std::move(noise));
  }

  /// Estimates the noise again where the best hypothesis is taken away, and weighs all by it.
  void settle() {
    if (found_.hypotheses.empty()) return;
    for (int round = 0; round < 2; ++round) {
      const NoiseShape before = found_.likelihood->shape();
      NoiseShape start(study_.measurements());
      start.outlier = before.outlier;
      settle_noise(start);
      for (Hypothesis& h : found_.hypotheses) look_again(study_, *found_.likelihood, h);
      sort();
      const NoiseShape& now = found_.likelihood->shape();
      if (now.outlier == before.outlier && now.relative == before.relative) break;
    }
    for (Hypothesis& h : found_.hypotheses) h.refined = false;
    refine(refined_at_last, near_best / 2);
  }

  /// The leading hypotheses without each of their effects, fitted from what the others are there: a simpler
  /// one lacks no evidence for the place where its own fit began.
  void simplify() {
    std::vector<Instance> parts;
    for (std::size_t i = 0; i < std::min(taken_apart, found_.hypotheses.size()); ++i)
      for (const EffectAt& gone : found_.hypotheses[i].candidate.effects)
        if (const Hypothesis& h = found_.hypotheses[i];
            h.candidate.count() > 1 && !h.candidate.has_as_tolerance(gone))
          parts.push_back(
              part(study_, h.candidate, h.parameters, [&](const EffectAt& at) { return !(at == gone); }));
    std::vector<Hypothesis> simpler(parts.size());
    in_parallel(parts.size(), study_.threads(), [&](std::size_t i) {
      simpler[i] = maximised(study_, *found_.likelihood, parts[i].candidate, parts[i].parameters, fine);
    });
    for (Hypothesis& one : simpler) add(std::move(one));
    sort();
  }

  /// A hypothesis with an idle effect is another, simpler one. Unknown torques stay: they tell joints apart.
  void drop_idle() {
    std::vector<char> idle(found_.hypotheses.size(), 0);
    in_parallel(idle.size(), study_.threads(), [&](std::size_t i) {
      const Hypothesis& h = found_.hypotheses[i];
      const bool outside = h.candidate.effects.size() == 1 && h.candidate.effects.front().effect->outside;
      idle[i] = i < 40 ? has_idle_effect(study_, *found_.likelihood, h) : !outside;
    });
    std::vector<Hypothesis> kept;
    for (std::size_t i = 0; i < idle.size(); ++i)
      if (!idle[i]) kept.push_back(std::move(found_.hypotheses[i]));
    found_.hypotheses = std::move(kept);
  }

  const Study& study_;
  VectorXd nominal_residual_;
  std::vector<EffectAt> listed_;  ///< of the catalogue and the user's
  Findings found_;
  std::optional<Likelihoods> in_noise_;
  std::set<std::string> from_whole_, replaced_;  ///< labels: fitted from a larger one; extended by all
};

}  // namespace

Findings search(const Study& study, const std::function<void(double)>& progress) {
  return Searcher(study).run([&](double share) {
    if (progress) progress(share);
  });
}

}  // namespace plumbline::diagnose
