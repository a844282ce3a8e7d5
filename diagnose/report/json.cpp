#include "diagnose/report/report.hpp"

#include <algorithm>
#include <numeric>

#include "diagnose/report/law.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

Json effect_names(const Candidate& candidate) {
  Json names = Json::array();
  for (const EffectAt& at : candidate.effects) names.push_back(at.label());
  return names;
}

/// Noise scales and autocorrelations of the measured channels.
Json noise(const NoiseModel& model, const std::map<Channel, double>& by_channel) {
  Json result = Json::object(), correlations = Json::object();
  double largest = 0;
  for (const Channel::Name name :
       {Channel::Name::x, Channel::Name::y, Channel::Name::Fx, Channel::Name::Fy, Channel::Name::q}) {
    const bool measured = std::any_of(by_channel.begin(), by_channel.end(),
                                      [&](const auto& one) { return one.first.name == name; });
    if (!measured) continue;
    const Channel channel{name};
    result[label(name)] = model.of(channel);
    correlations[label(channel.sensor())] = model.correlation_of(channel);
    largest = std::max(largest, model.correlation_of(channel));
  }
  result["correlation"] = largest;
  result["correlations"] = correlations;
  return result;
}

Json by_label(const std::map<Channel, double>& values) {
  Json result = Json::object();
  for (const auto& [channel, value] : values) result[channel.label()] = value;
  return result;
}

Json gap(const GapAnswer& answer, const NoiseModel& model) {
  Json sinusoids = Json::array(), proportional = Json::object(), runs = Json::array(),
       segments = Json::array(), other_branch = Json::array();
  for (const HummingChannel& one : answer.hum)
    sinusoids.push_back(
        {{"run", one.run}, {"channel", one.channel.label()}, {"period", one.period}, {"rms", one.rms}});
  for (const auto& [name, share] : answer.proportional) proportional[label(name)] = share;
  for (const RougherRun& one : answer.rougher)
    runs.push_back({{"run", one.run}, {"sensor", label(one.sensor)}, {"factor", one.times}});
  for (const RougherStretch& one : answer.rougher_stretches)
    segments.push_back({{"run", one.run},
                        {"sensor", label(one.sensor)},
                        {"from", one.from},
                        {"to", one.to},
                        {"factor", one.times}});
  for (const OtherBranch& one : answer.other_branch)
    other_branch.push_back({{"run", one.run}, {"from", one.reading}});
  return {{"present", answer.present},
          {"p_value", answer.test.p_value},
          {"chi2_per_dof", answer.chi2_per_value},
          {"rms", by_label(answer.rms)},
          {"noise", noise(model, answer.rms)},
          {"periodic_interference", sinusoids},
          {"proportional_noise", proportional},
          {"noisier_joints", by_label(answer.uneven)},
          {"noisier_runs", runs},
          {"noisier_segments", segments},
          {"assumed_weights", answer.taken_for_weights},
          {"other_branch", other_branch}};
}

Json where(const Where& places) {
  Json channels = Json::array(), runs = Json::array(), path = Json::array(), joints = Json::array();
  for (const auto& one : places.channels)
    channels.push_back({{"channel", one.channel.label()}, {"share", one.share}});
  for (const auto& one : places.runs) runs.push_back({{"run", one.run}, {"share", one.share}});
  for (const auto& one : places.load_path) {
    path.push_back({{"run", one.run},
                    {"from", one.from},
                    {"to", one.to},
                    {"share", one.share},
                    {"regime", regime_word(one.regime)}});
  }
  for (const auto& one : places.joints) joints.push_back({{"joint", one.joint}, {"share", one.share}});
  return {{"channels", channels},
          {"runs", runs},
          {"load_path", path},
          {"joints", joints},
          {"joint_evidence", joint_evidence_words(places.joint_evidence)}};
}

Json effects(const Candidate& candidate, const std::vector<std::vector<Estimate>>& estimates) {
  Json list = Json::array();
  for (std::size_t e = 0; e < candidate.effects.size(); ++e) {
    const EffectAt& at = candidate.effects[e];
    Json parameters = Json::object();
    for (const Estimate& one : estimates[e])
      parameters[one.name] = {{"value", one.value},
                              {"low", one.low},
                              {"high", one.high},
                              {"at_bound", one.at_bound},
                              {"unit", one.unit}};
    list.push_back({{"id", at.effect->id},
                    {"joint", at.joint > 0 ? Json(at.joint) : Json(nullptr)},
                    {"parameters", parameters}});
  }
  return list;
}

Json cause(const Diagnosis& diagnosis) {
  const Cause& found = diagnosis.cause;
  Json equivalent = Json::array(), ranking = Json::array(), idle = Json::array();
  for (const std::size_t place : found.equivalent)
    equivalent.push_back(effect_names(found.ranking[place].hypothesis.fit.candidate));
  if (found.reservation != Reservation::none) equivalent.push_back({"unknown"});
  for (const std::size_t place : listed_places(found)) {
    const Ranked& one = found.ranking[place];
    ranking.push_back({{"effects", effect_names(one.hypothesis.fit.candidate)},
                       {"probability", one.probability},
                       {"chi2_per_dof", one.chi2_per_dof}});
  }
  // An unknown cause predicts nothing beyond the nominal model.
  if (diagnosis.gap.present) {
    ranking.push_back({{"effects", {"unknown"}},
                       {"probability", found.unknown},
                       {"chi2_per_dof", diagnosis.gap.chi2_per_value}});
  }
  for (const EffectAt& at : diagnosis.not_excited) idle.push_back(at.label());
  const bool explained =
      found.verdict == CauseVerdict::identified || found.verdict == CauseVerdict::ambiguous;
  Json report = {
      {"verdict", verdict_word(found.verdict)},
      {"effects", explained ? effects(found.ranking[found.best].hypothesis.fit.candidate, diagnosis.estimates)
                            : Json::array()},
      {"equivalent", equivalent},
      {"ranking", ranking},
      {"not_excited", idle}};

  if (found.remainder > 0) report["discrepancy"] = found.remainder;
  return report;
}

/// The model whose residual reduction was measured.
const char* shrinks(const Diagnosis& diagnosis) {
  if (diagnosis.offers_law()) return "law";
  return diagnosis.cause.verdict == CauseVerdict::unknown ? "partial" : "cause";
}

Json shrink(const Diagnosis& diagnosis) {
  const Shrink& measured = *diagnosis.shrink;
  Json channels = Json::object();
  for (const auto& [channel, one] : measured.channels) {
    channels[channel.label()] = {{"ratio", one.ratio},
                                 {"ratio_low", one.ratio_low},
                                 {"ratio_high", one.ratio_high},
                                 {"noise_floor_ratio", one.noise_floor_ratio}};
  }
  Json result = {{"of", shrinks(diagnosis)},
                 {"tested", measured.tested()},
                 {"selected_without_heldout", measured.chosen_blind},
                 {"heldout", measured.heldout},
                 {"rms_before", by_label(measured.rms_before)},
                 {"rms_after", by_label(measured.rms_after)},
                 {"ratio", measured.ratio},
                 {"ratio_low", measured.ratio_low},
                 {"ratio_high", measured.ratio_high},
                 {"noise_floor_ratio", measured.noise_floor_ratio},
                 {"chi2_per_dof_after", measured.chi2_per_value_after},
                 {"channels", channels}};
  if (measured.left_out > 0)
    result["outliers"] = {{"count", measured.left_out}, {"ratio_with", measured.ratio_with_left_out}};
  return result;
}

Json missing(const Missing& what) {
  Json points = Json::array();
  for (const MissingPoint& point : what.points)
    points.push_back({point.at, point.value, point.t, point.falling});
  return {{"quantity", what.what},
          {"unit", what.unit},
          {"abscissa", what.against},
          {"variance_explained",
           {{"position", what.by_position}, {"direction", what.by_direction}, {"time", what.by_time}}},
          {"points", points}};
}

Json next(const std::vector<Proposal>& proposals) {
  Json list = Json::array();
  for (const Proposal& one : proposals)
    list.push_back({{"run", one.description}, {"expected_log_odds", one.log_odds}});
  return list;
}

}  // namespace

Json as_json(const Diagnosis& diagnosis) {
  Json places = where(diagnosis.where);
  if (diagnosis.missing) places["unexplained"] = missing(*diagnosis.missing);
  Json report = {{"format", "gap-diagnosis/2"},
                 {"experiment", diagnosis.experiment},
                 {"gap", gap(diagnosis.gap, diagnosis.noise)},
                 {"where", places},
                 {"cause", cause(diagnosis)},
                 {"shrink", diagnosis.shrink ? shrink(diagnosis) : Json(nullptr)},
                 {"next", next(diagnosis.proposals)}};
  if (diagnosis.law) report["law"] = law_as_json(*diagnosis.law);
  return report;
}

std::vector<std::size_t> listed_places(const Cause& cause) {
  constexpr std::size_t most = 10;
  std::vector<std::size_t> places(std::min(most, cause.ranking.size()));
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::vector<std::size_t> named = cause.equivalent;
  if (cause.verdict == CauseVerdict::identified || cause.verdict == CauseVerdict::ambiguous)
    named.push_back(cause.best);
  std::sort(named.begin(), named.end());
  for (const std::size_t place : named)
    if (place >= most) places.push_back(place);
  return places;
}

}  // namespace plumbline::diagnose
