#include "diagnose/exchange/corrected.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/rig/nominal.hpp"
#include "tests/diagnose/exchange/found.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::Candidate, diagnose::EffectAt, diagnose::Experiment, diagnose::Study,
    diagnose::test::full_bench, test::found, test::sizeable;

bool same(const diagnose::Prediction& a, const diagnose::Prediction& b) {
  if (!a.reached || !b.reached) return a.reached == b.reached;
  for (std::size_t r = 0; r < a.runs.size(); ++r)
    if (!(a.runs[r] - b.runs[r]).isZero(1e-12)) return false;
  return true;
}

}  // namespace

TEST_CASE("a corrected model, written and read again, predicts what the effect predicts: every row") {
  const Study study(full_bench());
  for (const EffectAt& at : possible_effects(study)) {
    CAPTURE(at.label());
    const std::vector<double> amount = sizeable(study, at);
    const auto models = corrected_models(study, found(study, at, amount));
    REQUIRE(models.size() == 1);
    const Written file = written(models.front().model, Format::toml);
    Experiment again = full_bench();
    static_cast<diagnose::NominalChain&>(again) = diagnose::parse_nominal(file.text, "corrected.toml");
    REQUIRE(again.effects.size() == 1);
    CHECK(again.effects.front().label() == at.label());
    // Coordinates of a logarithm or reciprocal come back but for their last digit.
    CHECK(same(Study(again).nominal(), predict(study, {{at}}, amount)));
  }
}

TEST_CASE("an effect of the user's goes by its id into our own format, and into no other") {
  diagnose::Effect own = diagnose::effect("gravity");
  own.id = "user:sag";
  const Study study(full_bench());
  diagnose::Diagnosis diagnosis = found(study, own, {0.1});
  const Model model = corrected_models(study, diagnosis).front().model;
  const Written file = written(model, Format::toml);
  CHECK(diagnose::parse_nominal(file.text, "corrected.toml").effects == model.experiment.effects);
  CHECK(model.experiment.effects.front().label() == "user:sag");
  CHECK(file.effects.front().effect == "user:sag");
  CHECK_FALSE(written(model, Format::urdf).effects.front().carried);
  // a file a candidate, by a name that every system allows
  diagnosis.cause.verdict = diagnose::CauseVerdict::ambiguous;
  diagnosis.cause.ranking.push_back(diagnosis.cause.ranking.front());
  diagnosis.cause.named = 2;
  CHECK(corrected_models(study, diagnosis).front().cause == "user-sag");
}

TEST_CASE("an effect beside the same one of the nominal model adds to it") {
  const Study study(full_bench());
  for (const EffectAt& at :
       {EffectAt("backlash", 2), EffectAt("rest_angle", 1), EffectAt("gravity"), EffectAt("joint_friction"),
        EffectAt("base_compliance"), EffectAt("position_offset"), EffectAt("force_bias"),
        EffectAt("run_rest"), EffectAt("run_tare"), EffectAt("play")}) {
    CAPTURE(at.label());
    const std::vector<double> amount = sizeable(study, at);
    std::vector<double> twice = amount;
    for (double& value : twice) value *= 2;
    Experiment half = full_bench();
    half.effects = corrected_models(study, found(study, at, amount)).front().model.experiment.effects;
    CHECK(same(predict(Study(half), {{at}}, amount), predict(study, {{at}}, twice)));
  }
}

TEST_CASE("as many arms and sliders as an effect of the nominal model has go beside those of three others") {
  Experiment experiment = full_bench();
  const Study bare(experiment);
  const auto amount_of = [&](const EffectAt& at) {
    const bool elements = at.effect->id == "hysteresis";
    return elements ? std::vector<double>{0.2, 0.01, 0.2, 0.02, 0.2, 0.03, 0.2, 0.05, 0.2, 0.1}
                    : sizeable(bare, at);
  };
  const EffectAt all(*diagnose::effect("hysteresis").orders().back()),
      one_joint(*diagnose::effect("hysteresis", 2).orders().back(), 2);
  for (const EffectAt& at : {all, one_joint, EffectAt("relaxation_spectrum"), EffectAt("viscoelasticity")}) {
    const auto one = corrected_models(bare, found(bare, at, amount_of(at)));
    experiment.effects.push_back(one.front().model.experiment.effects.front());
  }
  const Study study(experiment);
  const Candidate three{{all, one_joint, {"relaxation_spectrum"}}};
  std::vector<double> amount;
  for (const EffectAt& at : three.effects)
    for (const double value : amount_of(at)) amount.push_back(value);
  CHECK(predict(study, three, amount).reached);
}

TEST_CASE("an effect that is none is refused in one line that names it") {
  const auto says = [](diagnose::NominalEffect effect, const std::vector<std::string>& words) {
    Experiment experiment = full_bench();
    experiment.effects = {std::move(effect)};
    try {
      static_cast<void>(diagnose::nominal_rig(experiment));
    } catch (const Error& error) {
      const std::string text = error.what();
      return std::all_of(words.begin(), words.end(),
                         [&](const std::string& word) { return text.find(word) != text.npos; });
    }
    return false;
  };
  CHECK(says({"rust", 0, {}}, {"nominal.effect[1].id", "rust", "catalogue"}));
  CHECK(says({"backlash", 0, {{"b", 0.1}}}, {"nominal.effect[1].joint", "none"}));
  CHECK(says({"backlash", 4, {{"b", 0.1}}}, {"joint", "4", "from 1 to 3"}));
  CHECK(says({"gravity", 2, {{"rho", 0.1}}}, {"joint", "not at one joint"}));
  CHECK(says({"backlash", 2, {{"c", 0.1}}}, {"parameters.b", "no such key"}));
  CHECK(says({"backlash", 2, {{"b", 0.1}, {"c", 0.1}}}, {"parameters", "b alone"}));
  CHECK(says({"backlash", 2, {{"b", -0.1}}}, {"parameters.b", "-0.1", "zero or more"}));
  CHECK(says({"viscoelasticity", 0, {{"m", 0.1}, {"tau", 0}}}, {"parameters.tau", "positive"}));
  CHECK(says({"joint_stiffness", 2, {{"a", -1.5}}}, {"stiffness", "joint 2"}));
  CHECK(says({"link_length", 2, {{"a", -1.5}}}, {"length", "link 2"}));
}

TEST_CASE("an ambiguous cause gives a file a candidate, an unknown one the nominal model") {
  const Study study(full_bench());
  diagnose::Diagnosis diagnosis = found(study, {"rest_angle", 1}, {0.05});
  diagnosis.cause.verdict = diagnose::CauseVerdict::ambiguous;
  diagnosis.cause.ranking.push_back(test::ranked({{{"backlash", 1}, {"gravity"}}}, {0.05, 0.1}));
  diagnosis.cause.ranking.push_back(test::ranked({{"force_gain"}}, {0.1}));  // too improbable to be named
  diagnosis.cause.named = 2;
  const auto models = corrected_models(study, diagnosis);
  REQUIRE(models.size() == 2);
  CHECK(models[0].cause == "rest_angle-1");
  CHECK(models[1].cause == "backlash-1-gravity");
  CHECK(models[1].model.experiment.effects[1].parameters.at("rho") == 0.1);
  diagnosis.cause.verdict = diagnose::CauseVerdict::unknown;
  CHECK(corrected_models(study, diagnosis).front().model.experiment.effects.empty());
}

}  // namespace plumbline::exchange
