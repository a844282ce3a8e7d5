#include "trial/simulator/make_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <plumbline/base/error.hpp>

#include "trial/simulator/bench.hpp"
#include "trial/simulator/nominal_error.hpp"

namespace plumbline::simulator {
namespace {

/// The channels where the gap shows most.
std::string channels_of(const std::vector<Excess>& values) {
  std::map<std::string, double> share;
  for (const Excess& one : values) share[one.channel] += one.value * one.value;
  double largest = 0;
  for (const auto& [channel, square] : share) largest = std::max(largest, square);
  constexpr double nearly = 0.7;
  std::string names;
  for (const auto& [channel, square] : share)
    if (square >= nearly * largest) names += (names.empty() ? "" : ", ") + channel;
  return names;
}

/// The effect at about the wanted strength; nothing where its size would be unusual.
std::optional<Outcome> tuned(const Bench& bench, const Effect& drawn, double wanted) {
  constexpr double smallest = 5e-3;
  double factor = 1;
  for (int attempt = 0; attempt < 5; ++attempt) {
    Outcome outcome = outcome_of(bench, {drawn.scaled(factor)});
    const double strength = rms(outcome.gap);
    if (strength > 0.8 * wanted && strength < 1.25 * wanted) return outcome;
    const double next =
        std::clamp(factor * (strength > 0 ? wanted / strength : 10), smallest, drawn.kind->reach);
    if (next == factor) break;
    factor = next;
  }
  return std::nullopt;
}

/// Similarity of two gaps up to a factor.
double likeness(const std::vector<Excess>& one, const std::vector<Excess>& other) {
  double product = 0;
  for (std::size_t i = 0; i < one.size(); ++i) product += one[i].value * other[i].value;
  return std::abs(product) / (rms(one) * rms(other) * static_cast<double>(one.size()));
}

trial::TrueEffect label_of(const Bench& bench, const Effect& effect, double strength) {
  const bool known = effect.kind->id != "unknown";
  trial::TrueEffect label{
      std::string(effect.kind->id), effect.kind->at_joint ? effect.joint + 1 : 0, {}, strength};
  for (std::size_t p = 0; p < effect.values.size() && known; ++p)
    label.parameters.emplace_back(effect.kind->name(bench.plan, p), effect.values[p]);
  return label;
}

/// The simulated effects, the strength of each alone, and the tolerances beside them.
struct Cast {
  std::vector<Outcome> alone;
  std::vector<Effect> tolerances;
  double tolerance_strength = 0;
};

/// Nothing where the bench cannot have the requested effect. An effect beside tolerances is half as large
/// again as they are.
std::optional<Cast> cast(const Wish& wish, const Bench& bench, Random& random) {
  const Scene scene = scene_of(bench);
  Cast cast;
  if (wish.tolerances) {
    cast.tolerances = draw_tolerances(scene, random);
    cast.tolerance_strength = rms(outcome_of(bench, cast.tolerances).gap);
  }
  constexpr double clear = 1.5, noticed = 3;
  if (wish.tolerances && wish.kinds.empty() && cast.tolerance_strength < noticed) return std::nullopt;
  for (std::size_t e = 0; e < wish.kinds.size(); ++e) {
    const Effect effect = draw_effect(*wish.kinds[e], scene, random);
    if (!effect.kind) return std::nullopt;
    std::optional<Outcome> part =
        tuned(bench, effect, std::max(wish.strengths[e], clear * cast.tolerance_strength));
    if (!part) return std::nullopt;
    cast.alone.push_back(std::move(*part));
  }
  constexpr double too_alike = 0.9;
  if (cast.alone.size() > 1 && likeness(cast.alone[0].gap, cast.alone[1].gap) > too_alike)
    return std::nullopt;
  return cast;
}

Outcome together(const Bench& bench, const Cast& cast) {
  std::vector<Effect> all;
  for (const Outcome& one : cast.alone) all.push_back(one.effects.front());
  all.insert(all.end(), cast.tolerances.begin(), cast.tolerances.end());
  if (all.empty()) return {{}, bench.shown, {}};
  return all.size() == 1 ? cast.alone.front() : outcome_of(bench, all);
}

/// Naming tolerances or not is both right beside a cause; without a cause one of them must be named.
void allow_tolerances(trial::Label& label, const Bench& bench, const std::vector<Effect>& tolerances) {
  std::vector<std::string> cause;
  for (const trial::TrueEffect& effect : label.effects)
    cause.push_back(trial::effect_key(effect.id, effect.joint));
  std::vector<std::vector<std::string>> causes = label.equivalent;
  causes.push_back(cause);
  for (std::size_t subset = 1; subset < std::size_t{1} << tolerances.size(); ++subset) {
    for (std::vector<std::string> said : causes) {
      for (std::size_t t = 0; t < tolerances.size(); ++t)
        if ((subset >> t & 1U) != 0) said.push_back(key_of(tolerances[t]));
      label.equivalent.push_back(said);
    }
  }
  if (!cause.empty() || tolerances.empty()) return;
  for (const Effect& one : tolerances) label.effects.push_back(label_of(bench, one, 0));
}

std::string family(const Wish& wish) {
  if (wish.kinds.empty()) return wish.tolerances ? "tolerances alone" : "no effect";
  if (wish.kinds.size() > 1) return "two effects";
  const Kind& kind = *wish.kinds.front();
  if (kind.id == "unknown") return "outside the catalogue";
  return wish.tolerances ? "one effect beside tolerances" : std::string(kind.family);
}

trial::Label label(const Wish& wish, const Bench& bench, const Cast& cast, const Outcome& outcome,
                   const std::string& name) {
  trial::Label label;
  label.name = name;
  label.family = family(wish);
  label.noise = bench.scatter.kind;
  label.noise_scale = bench.scatter.sigma.force / bench.scatter.declared.force;
  label.strength = outcome.effects.empty() ? 0 : significant(rms(outcome.gap), 4);
  for (const Outcome& one : cast.alone) {
    label.effects.push_back(label_of(bench, one.effects.front(), significant(rms(one.gap), 4)));
    label.description += one.effects.front().kind->description;
  }
  if (!label.description.empty()) label.channel = channels_of(outcome.gap);
  if (cast.alone.size() == 1) {
    label.equivalent = aliases(bench, cast.alone.front());
  } else if (cast.alone.size() > 1) {
    label.equivalent = aliases(bench, outcome);
  }
  allow_tolerances(label, bench, cast.tolerances);
  return label;
}

std::optional<Experiment> attempt(const Wish& wish, const std::string& name, Random& random) {
  const std::optional<Bench> bench = draw_bench(random, wish.rough);
  if (!bench) return std::nullopt;
  const std::optional<Cast> parts = cast(wish, *bench, random);
  if (!parts) return std::nullopt;
  const Outcome outcome = together(*bench, *parts);
  Experiment made{name, bench->plan, bench->scatter, {}, {}, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t r = 0; r < bench->plan.runs.size(); ++r)
    made.runs.push_back(scattered(bench->plan.runs[r], outcome.shown[r], bench->scatter, random));
  made.label = label(wish, *bench, *parts, outcome, name);
  const Sigma& sigma = bench->scatter.sigma;
  if (bench->plan.nominal.mass.empty())
    made.nominal_error =
        nominal_error(bench->plan, bench->states,
                      {sigma.force, sigma.position, bench->plan.angles_measured ? sigma.angle : 0});
  return made;
}

}  // namespace

Experiment make_experiment(const Wish& wish, const std::string& name, Random& random) {
  constexpr int patience = 400;
  for (int i = 0; i < patience; ++i) {
    try {
      if (std::optional<Experiment> made = attempt(wish, name, random)) return std::move(*made);
    } catch (const Error&) {  // a chain that buckles where it must not, or does not come to rest: another one
    }
  }
  std::string wished;
  for (const Kind* kind : wish.kinds) wished += (wished.empty() ? "" : " + ") + std::string(kind->id);
  throw Error("simulator: no bench for experiment " + name + " (" + wished + ") in " +
              std::to_string(patience) + " attempts");
}

/// The wish is drawn before the bench, so that every wish keeps its probability; a wish that hundreds of
/// benches cannot grant is replaced.
Experiment make_experiment(Trial trial, std::uint64_t seed, std::size_t number, const std::string& name) {
  Random random(seed, number);
  constexpr int wishes = 4;
  for (int i = 1;; ++i) {
    const Wish wish = trial == Trial::first ? draw_wish(random) : draw_second_wish(random);
    try {
      return make_experiment(wish, name, random);
    } catch (const Error&) {
      if (i == wishes) throw;
    }
  }
}

}  // namespace plumbline::simulator
