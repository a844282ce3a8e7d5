#include "diagnose/inference/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <plumbline/base/parallel.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/rival.hpp"
#include "diagnose/inference/elements.hpp"
#include "diagnose/inference/screen.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

bool better(const Fit& a, const Fit& b) {
  return a.cost < b.cost;
}

bool same(const Candidate& a, const Candidate& b) {
  return std::is_permutation(a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end());
}

/// Adds fits, best first; of two of the same candidate the better.
void add(std::vector<Fit>& fits, std::vector<Fit> more) {
  for (Fit& one : more) {
    const auto known = std::find_if(fits.begin(), fits.end(),
                                    [&](const Fit& other) { return same(other.candidate, one.candidate); });
    if (known == fits.end()) {
      fits.push_back(std::move(one));
    } else if (better(one, *known)) {
      *known = std::move(one);
    }
  }
  std::sort(fits.begin(), fits.end(), better);
}

/// How far a search goes. A second effect is looked for beside the twenty best effects alone: of two causes
/// one is among them unless both hide behind more than a score that mimic their sum. A third is looked for
/// beside the ten best pairs. The two dozen that promise most are fitted. Where an effect with two values or
/// more fits, fewer will do: it is held against two with few values, and against what machining leaves, alone
/// and beside one effect more.
constexpr std::size_t single_seeds = 20, pair_seeds = 10, few_valued_seeds = 10, finalists = 24;

/// So many of the best combinations are examined for simpler ones.
constexpr std::size_t examined = 3;

/// Effects that might act together, and where their fit may start.
struct Combination {
  Candidate candidate;
  InitialGuesses guesses;
  double cost;  ///< forecast
};

class Searcher {
 public:
  explicit Searcher(const Study& study) : study_(study) {
    // What the readings scatter, and nothing of how they hang together: the gap is still in them.
    settings_.noise.scale =
        estimate_noise(study.measurements(), without_outliers(study.measurements(), study.nominal_residual()))
            .scale;
  }

  /// \param report  called with the share of them that is fitted
  [[nodiscard]] std::vector<Fit> singles(const std::function<void(double)>& report) const {
    const std::vector<EffectAt> effects = possible_effects(study_);
    std::mutex one_at_a_time;
    std::size_t done = 0;
    std::vector<Fit> fits = side_by_side(effects.size(), [&](std::size_t e) {
      Fit fitted = fit(study_, Candidate{{effects[e]}}, settings_);
      const std::lock_guard only(one_at_a_time);
      report(static_cast<double>(++done) / static_cast<double>(effects.size()));
      return fitted;
    });
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

  /// Friction or play at every joint leaves hollows, in which one joint has what is another's: the best of
  /// the kind, with what neighbours have exchanged, or the next but one. Of 160 benches of five links on
  /// which unequal friction was planted 32 went astray, and so none.
  [[nodiscard]] std::vector<Fit> exchanged(const std::vector<Fit>& singles) const {
    constexpr std::size_t seeds = 6;
    std::vector<const Fit*> from;
    for (std::size_t s = 0; s < std::min(seeds, singles.size()); ++s) {
      const std::vector<ParameterRange> ranges = study_.ranges(singles[s].candidate);
      if (std::all_of(ranges.begin(), ranges.end(), [](const ParameterRange& range) {
            return range.coordinate == Coordinate::plain && range.low == 0;
          }))
        from.push_back(&singles[s]);
    }
    return side_by_side(from.size(), [&](std::size_t i) { return exchanged(*from[i]); });
  }

  /// Those of which no effect has many values.
  [[nodiscard]] std::vector<Fit> few_valued(std::vector<Fit> fits) const {
    std::erase_if(fits, [&](const Fit& one) { return many_valued(study_, one.candidate) > 0; });
    return fits;
  }

  /// What is known already, from where it stands.
  [[nodiscard]] std::vector<Fit> again(const Findings& known) const {
    return side_by_side(known.hypotheses.size(), [&](std::size_t h) {
      const Fit& one = known.hypotheses[h].fit;
      return fit_from(study_, one.candidate, settings_, one.parameters);
    });
  }

  /// Adds one more effect to each of the best so far.
  /// \param most  so many of the effects may have many values
  [[nodiscard]] std::vector<Fit> extended(const std::vector<Fit>& from, std::size_t seeds,
                                          std::size_t most = 1) const {
    std::vector<std::vector<Prospect>> prospects(std::min(seeds, from.size()));
    in_parallel(prospects.size(), study_.threads(),
                [&](std::size_t s) { prospects[s] = screen(study_, from[s], settings_); });
    std::vector<Combination> combinations;
    for (std::size_t s = 0; s < prospects.size(); ++s) {
      for (const Prospect& prospect : prospects[s])
        // Two effects with many values follow anything.
        if (Combination both = joined(from[s], prospect); many_valued(study_, both.candidate) <= most)
          offer(combinations, std::move(both));
    }
    std::sort(combinations.begin(), combinations.end(),
              [](const Combination& a, const Combination& b) { return a.cost < b.cost; });
    std::vector<Fit> fits = side_by_side(std::min(finalists, combinations.size()), [&](std::size_t c) {
      return fit(study_, combinations[c].candidate, settings_, combinations[c].guesses);
    });
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

  /// Everything that machining leaves, at once, also of a single joint, of which one kind alone would be a
  /// wrong stiffness or rest angle; nothing where it has too many values to be fitted in time.
  [[nodiscard]] std::vector<Fit> machined() const {
    constexpr std::size_t most_values = 40;
    Candidate candidate;
    for (const Effect* row : study_.effects())
      if (row->is_tolerance) candidate.effects.emplace_back(*row);
    const bool can_be = study_.ranges(candidate).size() <= most_values;
    return side_by_side(can_be ? 1 : 0, [&](std::size_t) { return fit(study_, candidate, settings_); });
  }

  /// The best combinations with one effect left out, started where the combination stands: a search that went
  /// astray alone may have found its place in company. A kind of machining is not left out where the others
  /// are no rows by themselves.
  [[nodiscard]] std::vector<Fit> parts(const std::vector<Fit>& combinations) const {
    const std::vector<EffectAt> possible = possible_effects(study_);
    const bool has_kinds =
        std::all_of(study_.effects().begin(), study_.effects().end(), [&](const Effect* row) {
          return !row->is_tolerance ||
                 std::find(possible.begin(), possible.end(), EffectAt(*row)) != possible.end();
        });
    std::vector<std::pair<const Fit*, EffectAt>> cuts;
    for (std::size_t c = 0; c < std::min(examined, combinations.size()); ++c) {
      const Candidate& whole = combinations[c].candidate;
      for (const EffectAt& left_out : whole.effects)
        if (whole.effects.size() > 1 && (has_kinds || !whole.has_as_tolerance(left_out)))
          cuts.emplace_back(&combinations[c], left_out);
    }
    std::vector<Fit> fits =
        side_by_side(cuts.size(), [&](std::size_t i) { return without(*cuts[i].first, cuts[i].second); });
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

  /// What leaves more than a part of it that is known has gone astray, for with the rest at nothing it is
  /// that part: fitted again from there.
  [[nodiscard]] std::vector<Fit> from_parts(const std::vector<Fit>& fits) const {
    constexpr double sizeable = 1;  // of the cost; less is where an iteration ended
    std::vector<std::pair<const Fit*, const Fit*>> astray;
    for (const Fit& whole : fits) {
      const auto better_part = std::find_if(fits.begin(), fits.end(), [&](const Fit& one) {
        return one.cost + sizeable < whole.cost && one.candidate.is_part_of(whole.candidate);
      });
      if (better_part != fits.end()) astray.emplace_back(&whole, &*better_part);
    }
    return side_by_side(astray.size(), [&](std::size_t i) {
      const auto& [whole, known] = astray[i];
      return fit_from(study_, whole->candidate, settings_, completed(*whole, *known));
    });
  }

  /// The same with every other number of elements that an effect of it may have, each from the one before.
  [[nodiscard]] std::vector<Fit> in_other_numbers(const Fit& fitted) const {
    std::vector<Fit> fits;
    for (std::size_t e = 0; e < fitted.candidate.effects.size(); ++e) {
      const EffectAt& at = fitted.candidate.effects[e];
      if (!at.effect->orders) continue;
      const std::vector<const Effect*> rows = at.effect->orders();
      const auto own = std::find(rows.begin(), rows.end(), at.effect);
      const auto step_on = [&, last = fitted](const Effect* row) mutable {
        if (!last.converged) return;
        const InitialGuesses from = in_number(study_, last, e, *row);
        last.candidate.effects[e] = EffectAt(*row, at.joint);
        fits.push_back(last = fit(study_, last.candidate, settings_, from));
      };
      std::for_each(std::make_reverse_iterator(own), rows.rend(), step_on);
      std::for_each(own + 1, rows.end(), step_on);
    }
    std::erase_if(fits, [&](const Fit& one) { return !of_use(one); });
    return fits;
  }

  /// The best combinations with one effect made a special case of it: a tare of each run that is alike in
  /// all, say, is one tare.
  [[nodiscard]] std::vector<Fit> plainer(const std::vector<Fit>& combinations) const {
    std::vector<Candidate> plain_ones;
    for (std::size_t c = 0; c < std::min(examined, combinations.size()); ++c) {
      const Candidate& whole = combinations[c].candidate;
      for (std::size_t e = 0; e < whole.effects.size(); ++e) {
        if (whole.has_as_tolerance(whole.effects[e])) continue;
        for (const EffectAt& plain : possible_effects(study_)) {
          if (!covers(whole.effects[e], plain) || whole.has(plain)) continue;
          plain_ones.push_back(whole);
          plain_ones.back().effects[e] = plain;
        }
      }
    }
    return side_by_side(plain_ones.size(),
                        [&](std::size_t i) { return fit(study_, plain_ones[i], settings_); });
  }

 private:
  /// Neighbours, and their next neighbours.
  static std::vector<std::pair<std::size_t, std::size_t>> near_pairs(std::size_t count) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const std::size_t apart : {1U, 2U})
      for (std::size_t p = 0; p + apart < count; ++p) pairs.emplace_back(p, p + apart);
    return pairs;
  }

  [[nodiscard]] Fit exchanged(Fit best) const {
    constexpr double sizeable = 1;  // of the cost
    for (double before = std::numeric_limits<double>::infinity(); best.cost < before - sizeable;) {
      before = best.cost;
      for (const auto& [one, other] : near_pairs(best.parameters.size())) {
        std::vector<double> start = best.parameters;
        std::swap(start[one], start[other]);
        if (Fit there = fit_from(study_, best.candidate, settings_, start);
            there.converged && better(there, best))
          best = std::move(there);
      }
    }
    return best;
  }

  [[nodiscard]] Fit without(const Fit& combination, const EffectAt& left_out) const {
    const Instance rest = part(study_, combination.candidate, combination.parameters,
                               [&](const EffectAt& at) { return at != left_out; });
    return fit_from(study_, rest.candidate, settings_, rest.parameters);
  }

  /// Parameters of the whole: those of the part where it has them, nothing for tolerances that it has not,
  /// and its own for the rest.
  [[nodiscard]] std::vector<double> completed(const Fit& whole, const Fit& known) const {
    std::vector<double> parameters;
    for (const EffectAt& at : whole.candidate.effects) {
      const Fit& from = known.candidate.has(at) ? known : whole;
      std::vector<double> own = part(study_, from.candidate, from.parameters, [&](const EffectAt& one) {
                                  return one == at;
                                }).parameters;
      const std::vector<ParameterRange> ranges = study_.ranges(at);
      for (std::size_t i = 0; i < own.size(); ++i)
        if (&from == &whole && ranges[i].tolerance > 0) own[i] = 0;
      parameters.insert(parameters.end(), own.begin(), own.end());
    }
    return parameters;
  }

  /// So many fits, shared among the cores; in their order those that are of use.
  template <class Make>
  [[nodiscard]] std::vector<Fit> side_by_side(std::size_t count, const Make& make) const {
    std::vector<Fit> fits(count);
    in_parallel(count, study_.threads(), [&](std::size_t i) { fits[i] = make(i); });
    std::erase_if(fits, [&](const Fit& one) { return !of_use(one); });
    return fits;
  }

  /// What converged, unless its parameters are too many for so few readings: three for each. Those that are
  /// held by tolerances count as one.
  [[nodiscard]] bool of_use(const Fit& one) const {
    std::size_t free = 0, held = 0;
    for (const ParameterRange& range : study_.ranges(one.candidate)) ++(range.tolerance > 0 ? held : free);
    return one.converged && 3 * (free + std::min<std::size_t>(held, 1)) <= study_.measurements().size();
  }

  static Combination joined(const Fit& base, const Prospect& prospect) {
    Combination both{base.candidate, {prospect.from, 1}, prospect.cost};
    both.candidate.effects.push_back(prospect.effect);
    return both;
  }

  /// Keeps the better of two ways to the same combination.
  static void offer(std::vector<Combination>& combinations, Combination one) {
    const auto known = std::find_if(combinations.begin(), combinations.end(), [&](const Combination& other) {
      return same(other.candidate, one.candidate);
    });
    if (known == combinations.end()) {
      combinations.push_back(std::move(one));
    } else if (one.cost < known->cost) {
      *known = std::move(one);
    }
  }

  const Study& study_;
  FitSettings settings_;
};

/// Noise so wide that neighbouring readings that share it weigh together as one.
NoiseModel shared_by_neighbours(NoiseModel noise) {
  for (double& scale : noise.scale) scale *= std::sqrt(beliefs::share_a_misfit);
  return noise;
}

}  // namespace

void weigh(const Study& study, Findings& findings) {
  auto& hypotheses = findings.hypotheses;
  if (hypotheses.empty()) return;
  const auto best = std::min_element(hypotheses.begin(), hypotheses.end(),
                                     [](const auto& a, const auto& b) { return better(a.fit, b.fit); });
  findings.noise =
      findings.tolerance
          ? shared_by_neighbours(*findings.tolerance)
          : estimate_noise(study.measurements(), without_outliers(study.measurements(), best->fit.residual));
  in_parallel(hypotheses.size(), study.threads(), [&](std::size_t h) {
    Hypothesis& one = hypotheses[h];
    one.log_likelihood = log_likelihood(study.measurements(), one.fit.residual, findings.noise);
    one.log_evidence = log_evidence(study, one.fit, findings.noise);
  });
  std::sort(hypotheses.begin(), hypotheses.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
}

namespace {

Findings weighed(const Study& study, std::vector<Fit> fits) {
  Findings findings;
  for (Fit& one : fits) findings.hypotheses.push_back({std::move(one), 0, 0, {}});
  weigh(study, findings);
  return findings;
}

/// Adds what machining leaves to the fits. \returns that with one effect more, and what else the best of
/// these may act with: alone it may have been too far behind to be looked at.
std::vector<Fit> beside_machining(const Searcher& searcher, const std::vector<Fit>& singles,
                                  std::vector<Fit>& fits) {
  add(fits, searcher.machined());
  add(fits, searcher.from_parts(fits));
  std::vector<Fit> machined = fits;
  std::erase_if(machined, [](const Fit& one) { return !one.candidate.has_all_tolerances(); });
  std::vector<Fit> more = searcher.extended(machined, 1);
  if (more.empty() || singles.size() <= single_seeds) return more;
  const EffectAt partner = more.front().candidate.effects.back();
  const auto passed_over = std::find_if(singles.begin() + single_seeds, singles.end(), [&](const Fit& one) {
    return one.candidate == Candidate{{partner}};
  });
  if (passed_over != singles.end()) add(more, searcher.extended({*passed_over}, 1));
  return more;
}

/// Adds what leads with every other number of elements that it may have.
Findings in_their_numbers(const Study& study, const Searcher& searcher, Findings findings) {
  if (findings.hypotheses.empty()) return findings;
  std::vector<Fit> others = searcher.in_other_numbers(findings.hypotheses.front().fit);
  std::erase_if(others, [&](const Fit& one) {
    return std::any_of(findings.hypotheses.begin(), findings.hypotheses.end(),
                       [&](const Hypothesis& known) { return same(known.fit.candidate, one.candidate); });
  });
  if (others.empty()) return findings;
  for (Fit& one : others) findings.hypotheses.push_back({std::move(one), 0, 0, {}});
  weigh(study, findings);
  return findings;
}

}  // namespace

Findings search(const Study& study, const std::function<void(double)>& progress, const Findings& known) {
  const auto report = [&](double share) {
    if (progress) progress(share);
  };
  const Searcher searcher(study);
  std::vector<Fit> singles = searcher.singles([&](double share) { report(0.5 * share); });
  add(singles, searcher.exchanged(singles));
  std::vector<Fit> fits = singles;
  add(fits, searcher.again(known));
  const auto p_value = [&] { return structure_p_value(study.measurements(), fits.front().residual); };
  constexpr double look_further = 0.05;  // a search more costs time alone
  if (!fits.empty() && p_value() < look_further) add(fits, searcher.in_other_numbers(fits.front()));
  if (!fits.empty() && p_value() < look_further) {
    std::vector<Fit> pairs = searcher.extended(singles, single_seeds);
    add(fits, pairs);
    add(fits, searcher.parts(pairs));
    add(fits, searcher.plainer(pairs));
    report(0.7);
    add(pairs, beside_machining(searcher, singles, fits));
    add(fits, pairs);
    report(0.8);
    if (p_value() < beliefs::fit_level) {
      const std::vector<Fit> threes = searcher.extended(pairs, pair_seeds);
      add(fits, threes);
      add(fits, searcher.parts(threes));
      add(fits, searcher.plainer(threes));
    }
    add(fits, searcher.from_parts(fits));
    // What came out best may hold a plainer one that was passed over: of three, one. What machining leaves is
    // not taken apart beside another cause.
    std::vector<Fit> fewer = fits;
    std::erase_if(fewer, [](const Fit& one) { return one.candidate.has_all_tolerances(); });
    for (int cut = 0; cut < 2; ++cut) {
      fewer = searcher.parts(fewer);
      add(fits, fewer);
    }
  } else if (!fits.empty()) {
    const Candidate best = weighed(study, fits).hypotheses.front().fit.candidate;
    if (study.ranges(best).size() > 1) {
      add(fits, searcher.extended(searcher.few_valued(singles), few_valued_seeds, 0));
      add(fits, beside_machining(searcher, singles, fits));
      add(fits, searcher.from_parts(fits));
    }
  }
  Findings findings = in_their_numbers(study, searcher, weighed(study, std::move(fits)));
  report(1);
  return findings;
}

}  // namespace plumbline::diagnose
