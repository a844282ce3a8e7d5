#include "diagnose/next/search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <plumbline/base/parallel.hpp>
#include <set>

#include "diagnose/inference/start.hpp"
#include "diagnose/inference/elements.hpp"
#include "diagnose/next/forecast.hpp"
#include "diagnose/next/prior.hpp"
#include "diagnose/next/unknown_torque.hpp"

namespace plumbline::diagnose::next {
namespace {

constexpr Effort fine{4, 0.03};

/// A rough fit ends where an iteration takes half a per cent off the squares.
Effort rough(Eigen::Index values) {
  return {12, std::max(0.1, 0.0025 * static_cast<double>(values)), true};
}

bool same(const Candidate& a, const Candidate& b) {
  return a.effects.size() == b.effects.size() &&
         std::is_permutation(a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end());
}

struct Task {
  Candidate candidate;
  InitialGuesses starts;
  double cost = 0;
};

class Searcher {
 public:
  explicit Searcher(const Study& study) : study_(study) {
    found_.data = std::make_shared<Data>(study.experiment());
    found_.states = std::make_shared<States>(study.experiment());
    found_.outside = unknown_torques(study);
    found_.nominal_residual = found_.data->residual(study.nominal());
    possible_ = listed_ = possible_effects(study);
    for (const Effect& row : *found_.outside)
      for (std::size_t j = 0; j < study.scales().link_length.size(); ++j)
        if (study.scales().joint_stiffness[j] > 0) possible_.emplace_back(row, j + 1);
    listen(found_.nominal_residual, even_noise(*found_.data));
  }

  Findings run(const std::function<void(double)>& stage) {
    auto last = std::clock();
    const auto report = [&](double share) {
      stage(share);
      if (std::getenv("TIMES") && share != 0.4 * std::round(share / 0.4 * 1e6) / 1e6) {}
    };
    const auto tick = [&](const char* what) {
      if (std::getenv("TIMES")) std::fprintf(stderr, "%s %.2f (%zu hypotheses)\n", what, double(std::clock() - last) / CLOCKS_PER_SEC, found_.hypotheses.size());
      last = std::clock();
    };
    fit_singles(report);
    tick("singles");
    report(0.4);
    const bool enough = !found_.hypotheses.empty() && found_.hypotheses.front().without_discrepancy() > 0.9;
    extend(seeds(enough ? 2 : 8), 16);
    tick("extend");
    report(0.6);
    with_tolerances(5);
    tick("tolerances");
    report(0.7);
    if (!found_.hypotheses.empty() && found_.hypotheses.front().without_discrepancy() < 0.5) extend(pairs(6), 12);
    tick("threes");
    report(0.8);
    for (int round = 0; round < 2; ++round) close(4);
    in_other_orders();
    tick("close");
    report(0.9);
    settle();
    tick("settle");
    report(1);
    return std::move(found_);
  }

 private:
  /// Sets the likelihoods by what a residual shows of the noise.
  void listen(const std::vector<VectorXd>& residual, NoiseShape start) {
    const Hyperpriors priors = usual_hyperpriors();
    const NoiseShape shape =
        noise_shape(*found_.data, *found_.states, priors, found_.nominal_residual, residual, std::move(start));
    auto likelihood = std::make_shared<Likelihood>(*found_.data, *found_.states, priors, shape, found_.nominal_residual);
    likelihood->prune(residual);
    found_.likelihood = likelihood;
    plain_ = std::make_shared<Likelihood>(*found_.data, *found_.states, without_discrepancy(), shape, found_.nominal_residual);
    stack_ = std::make_shared<Stack>(*found_.data, shape, found_.likelihood->split(residual).scale);
    found_.nominal = found_.likelihood->look(found_.nominal_residual, {});
  }

  /// So many parameters can be told: three readings for each; those with Gaussian priors count as one.
  [[nodiscard]] bool affordable(const Candidate& candidate) const {
    Eigen::Index free = 0, held = 0;
    for (const ParameterRange& range : study_.ranges(candidate)) ++(range.tolerance > 0 ? held : free);
    return 3 * (free + std::min<Eigen::Index>(held, 1)) <= found_.data->size() && free + held <= 60;
  }

  [[nodiscard]] bool known(const Candidate& candidate) const {
    return std::any_of(found_.hypotheses.begin(), found_.hypotheses.end(),
                       [&](const Hypothesis& h) { return same(h.candidate, candidate); });
  }

  /// Fits candidates side by side, plainly and then beside a discrepancy, and adds them.
  void fit(const std::vector<Task>& tasks, const std::function<void(double)>& report = [](double) {}) {
    std::vector<Hypothesis> fitted(tasks.size());
    std::size_t done = 0;
    std::mutex one_at_a_time;
    in_parallel(tasks.size(), study_.threads(), [&](std::size_t t) {
      if (affordable(tasks[t].candidate)) {
        Hypothesis one = maximised(study_, *plain_, tasks[t].candidate, tasks[t].starts, rough(found_.data->size()));
        if (one.converged) {
          look_again(study_, *found_.likelihood, one);
          weigh(study_, one);
        }
        fitted[t] = std::move(one);
      }
      const std::lock_guard only(one_at_a_time);
      report(static_cast<double>(++done) / static_cast<double>(tasks.size()));
    });
    for (Hypothesis& one : fitted) add(std::move(one));
    sort();
    refine(12, 25);
  }

  /// Maximises beside a discrepancy what leads, and was not yet.
  void refine(std::size_t most, double far) {
    std::vector<Hypothesis*> leading;
    for (Hypothesis& h : found_.hypotheses)
      if (h.log_evidence > found_.hypotheses.front().log_evidence - far && leading.size() < most && !h.refined) leading.push_back(&h);
    in_parallel(leading.size(), study_.threads(), [&](std::size_t i) {
      Hypothesis better = maximised(study_, *found_.likelihood, leading[i]->candidate, leading[i]->parameters, fine);
      if (better.converged) {
        weigh(study_, better);
        better.refined = true;
        *leading[i] = std::move(better);
      }
    });
    sort();
  }

  void add(Hypothesis one) {
    if (!one.converged) return;
    const auto place = std::find_if(found_.hypotheses.begin(), found_.hypotheses.end(),
                                    [&](const Hypothesis& h) { return same(h.candidate, one.candidate); });
    if (place == found_.hypotheses.end()) {
      found_.hypotheses.push_back(std::move(one));
    } else if (one.log_evidence > place->log_evidence) {
      *place = std::move(one);
    }
  }

  void sort() {
    std::stable_sort(found_.hypotheses.begin(), found_.hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
  }

  void fit_singles(const std::function<void(double)>& report) {
    std::vector<Task> tasks;
    for (const EffectAt& at : possible_) tasks.push_back({Candidate{{at}}, initial_guesses(study_, at)});
    fit(tasks, [&](double share) { report(0.4 * share); });
  }

  /// The single effects that explain most, with and without a discrepancy beside them.
  [[nodiscard]] std::vector<Hypothesis> seeds(std::size_t count) const {
    std::vector<const Hypothesis*> singles;
    for (const Hypothesis& h : found_.hypotheses)
      if (h.candidate.effects.size() == 1) singles.push_back(&h);
    std::vector<std::pair<double, const Hypothesis*>> plainly;
    for (const Hypothesis* h : singles) plainly.emplace_back((*stack_)(h->residual).squaredNorm(), h);
    std::sort(plainly.begin(), plainly.end());
    std::vector<Hypothesis> result;
    std::set<const Hypothesis*> taken;
    for (std::size_t i = 0; i < singles.size() && i < count; ++i)
      for (const Hypothesis* h : {singles[i], plainly[i].second})
        if (taken.insert(h).second) result.push_back(*h);
    return result;
  }

  [[nodiscard]] std::vector<Hypothesis> pairs(std::size_t count) const {
    std::vector<Hypothesis> result;
    for (const Hypothesis& h : found_.hypotheses)
      if (h.candidate.count() == 2 && result.size() < count) result.push_back(h);
    return result;
  }

  /// Adds one effect to each of some hypotheses, where that promises most.
  void extend(const std::vector<Hypothesis>& from, std::size_t finalists) {
    std::vector<std::vector<Prospect>> prospects(from.size());
    in_parallel(from.size(), study_.threads(),
                [&](std::size_t s) { prospects[s] = forecast(study_, *found_.data, *stack_, listed_, from[s]); });
    std::vector<Task> tasks;
    for (std::size_t s = 0; s < from.size(); ++s)
      for (const Prospect& one : prospects[s]) {
        Candidate both = from[s].candidate;
        both.effects.push_back(one.effect);
        offer(tasks, {both, one.starts, one.cost});
      }
    fit_best(std::move(tasks), finalists);
  }

  [[nodiscard]] double promise(double cost, const Candidate& candidate) const { return -cost / 2 + log_prior(study_, candidate); }

  static void offer(std::vector<Task>& tasks, Task one) {
    const auto place =
        std::find_if(tasks.begin(), tasks.end(), [&](const Task& t) { return same(t.candidate, one.candidate); });
    if (place == tasks.end()) {
      tasks.push_back(std::move(one));
    } else if (one.cost < place->cost) {
      *place = std::move(one);
    }
  }

  void fit_best(std::vector<Task> tasks, std::size_t finalists) {
    std::erase_if(tasks, [&](const Task& t) { return known(t.candidate) || !affordable(t.candidate); });
    // What a fit may reach, beside the best that was reached: likelihood times prior.
    double best = -INFINITY;
    for (const Hypothesis& h : found_.hypotheses) best = std::max(best, promise((*stack_)(h.residual).squaredNorm(), h.candidate));
    constexpr double margin = 3;
    std::erase_if(tasks, [&](const Task& t) { return promise(t.cost, t.candidate) < best - margin; });
    std::sort(tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) { return promise(a.cost, a.candidate) > promise(b.cost, b.candidate); });
    if (tasks.size() > finalists) tasks.resize(finalists);
    fit(tasks);
  }

  /// Manufacturing tolerances, alone and beside the best.
  void with_tolerances(std::size_t count) {
    Candidate tolerances;
    for (const Effect* row : study_.effects())
      if (row->is_tolerance) tolerances.effects.emplace_back(*row);
    std::vector<Task> tasks{{tolerances, {{std::vector<double>(study_.ranges(tolerances).size(), 0.0)}, 1}}};
    std::vector<Hypothesis> leading;
    for (const Hypothesis& h : seeds(count)) leading.push_back(h);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, found_.hypotheses.size()); ++i)
      if (found_.hypotheses[i].candidate.effects.size() > 1) leading.push_back(found_.hypotheses[i]);
    for (const Hypothesis& h : leading) {
      if (std::any_of(h.candidate.effects.begin(), h.candidate.effects.end(),
                      [](const EffectAt& at) { return at.effect->is_tolerance; }))
        continue;
      Candidate both = h.candidate;
      std::vector<double> start = h.parameters;
      for (const EffectAt& at : tolerances.effects) both.effects.push_back(at);
      start.resize(study_.ranges(both).size(), 0.0);
      tasks.push_back({both, {{start}, 1}});
    }
    fit(tasks);
  }

  /// What might take the place of each effect of the best, beside the same partners; and the best without it.
  void close(std::size_t count) {
    std::vector<Hypothesis> parents;
    std::vector<Task> parts;
    for (std::size_t i = 0; i < std::min(count, found_.hypotheses.size()); ++i) {
      const Hypothesis& h = found_.hypotheses[i];
      if (h.candidate.count() < 2) continue;
      for (const EffectAt& gone : h.candidate.effects) {
        if (h.candidate.has_as_tolerance(gone)) continue;
        const Instance rest = part(study_, h.candidate, h.parameters, [&](const EffectAt& at) { return !(at == gone); });
        if (!known(rest.candidate)) parts.push_back({rest.candidate, {{rest.parameters}, 1}});
      }
    }
    fit(parts);
    for (std::size_t i = 0; i < std::min(count, found_.hypotheses.size()); ++i) {
      const Hypothesis& h = found_.hypotheses[i];
      if (h.candidate.count() < 2) continue;
      for (const Hypothesis& parent : found_.hypotheses)
        if (parent.candidate.is_part_of(h.candidate) && parent.candidate.effects.size() + 1 == h.candidate.effects.size() &&
            closed_.insert(parent.candidate.label()).second)
          parents.push_back(parent);
    }
    extend(parents, 8 * parents.size());
  }

  /// The leading hypothesis with every other number of elements that an effect of it may have.
  void in_other_orders() {
    if (found_.hypotheses.empty()) return;
    const Hypothesis lead = found_.hypotheses.front();
    (void)lead;
  }

  /// Listens again to the noise that the best leaves, and weighs all by it.
  void settle() {
    if (found_.hypotheses.empty()) return;
    for (int round = 0; round < 2; ++round) {
      const std::vector<VectorXd> best = found_.hypotheses.front().residual;
      const NoiseShape before = found_.likelihood->shape();
      listen(best, before);
      for (Hypothesis& h : found_.hypotheses) {
        look_again(study_, *found_.likelihood, h);
        weigh(study_, h);
      }
      sort();
      if (found_.likelihood->shape().outlier == before.outlier && found_.likelihood->shape().relative == before.relative) break;
    }
    for (Hypothesis& h : found_.hypotheses) h.refined = false;
    refine(24, 12);
    drop_idle();
  }

  /// Whether the readings do not notice an effect of a hypothesis: without it they are as likely.
  [[nodiscard]] bool has_idle(const Hypothesis& h) const {
    constexpr double noticed = 1;  // nats
    const auto counts = [&](const EffectAt& at) { return !h.candidate.has_as_tolerance(at); };
    for (const EffectAt& gone : h.candidate.effects) {
      if (!counts(gone)) continue;
      const Instance rest = part(study_, h.candidate, h.parameters, [&](const EffectAt& at) { return !(at == gone); });
      const Prediction predicted = predict(study_, rest.candidate, rest.parameters);
      if (!predicted.reached) continue;
      const std::vector<VectorXd> residual = found_.data->residual(predicted);
      if (std::any_of(residual.begin(), residual.end(), [](const VectorXd& r) { return !r.allFinite(); })) continue;
      if (found_.likelihood->look(residual, {}).log_likelihood > h.look.log_likelihood - noticed) return true;
    }
    return false;
  }

  void drop_idle() {
    constexpr std::size_t most = 40;
    std::vector<char> idle(std::min(most, found_.hypotheses.size()), 0);
    in_parallel(idle.size(), study_.threads(), [&](std::size_t i) { idle[i] = has_idle(found_.hypotheses[i]); });
    std::vector<Hypothesis> kept;
    for (std::size_t i = 0; i < idle.size(); ++i)
      if (!idle[i]) kept.push_back(std::move(found_.hypotheses[i]));
    found_.hypotheses = std::move(kept);
  }

  const Study& study_;
  Findings found_;
  std::vector<EffectAt> possible_, listed_;
  std::shared_ptr<const Likelihood> plain_;
  std::shared_ptr<const Stack> stack_;
  std::set<std::string> closed_;
};

}  // namespace

Findings search(const Study& study, const std::function<void(double)>& progress) {
  return Searcher(study).run([&](double share) {
    if (progress) progress(share);
  });
}

}  // namespace plumbline::diagnose::next
