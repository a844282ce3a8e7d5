#include "diagnose/report/report.hpp"

#include "diagnose/report/calibration_text.hpp"
#include "diagnose/report/law.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

Json effect_names(const Candidate& candidate) {
  Json names = Json::array();
  for (const EffectAt& at : candidate.effects) names.push_back(at.label());
  return names;
}

/// What the readings scatter by.
Json noise(const NoiseEstimate& estimate) {
  Json scale = Json::object(), correlation = Json::object();
  for (const ChannelNoise& one : estimate.channels) {
    scale[one.channel.label()] = one.scale;
    correlation[one.channel.label()] = one.correlation;
  }
  return {{"scale", scale}, {"correlation", correlation}};
}

Json by_label(const std::map<Channel, double>& values) {
  Json result = Json::object();
  for (const auto& [channel, value] : values) result[channel.label()] = value;
  return result;
}

Json outliers(const std::vector<Outlier>& all) {
  Json list = Json::array();
  for (const Outlier& one : all)
    list.push_back({{"run", one.run},
                    {"reading", one.reading},
                    {"channel", one.channel.label()},
                    {"deviation", one.deviation},
                    {"at_end", one.at_end}});
  return list;
}

/// Departures of the noise from an even one.
void add_departures(Json& report, const GapAnswer& answer, const NoiseShape& shape) {
  Json interference = Json::array(), proportional = Json::object(), runs = Json::array(),
       segments = Json::array();
  for (const ChannelInterference& one : answer.interference)
    interference.push_back(
        {{"run", one.run}, {"channel", one.channel.label()}, {"period", one.period}, {"rms", one.rms}});
  for (const auto& [name, ratio] : shape.proportional) proportional[std::string(kind_of(name).label)] = ratio;
  for (const NoisierReadings& one : answer.noisier) {
    Json entry = {{"run", one.run}, {"sensor", label(one.sensor)}};
    if (!one.whole_run) entry["from"] = one.from, entry["to"] = one.to;
    entry["factor"] = one.factor;
    (one.whole_run ? runs : segments).push_back(entry);
  }
  report["periodic_interference"] = interference;
  report["proportional_noise"] = proportional;
  report["noisier_runs"] = runs;
  report["noisier_segments"] = segments;
  report["quantised"] = shape.quantised;
}

Json gap(const GapAnswer& answer, const NoiseEstimate& estimate) {
  Json report = {{"present", answer.present},
                 {"probability", answer.probability},
                 {"chi2_per_dof", answer.chi2_per_value},
                 {"rms", by_label(answer.rms)},
                 {"noise", noise(estimate)}};
  add_departures(report, answer, estimate.shape);
  report["outliers"] = outliers(answer.outliers);
  report["assumed_weights"] = answer.taken_for_weights;
  report["continued_runs"] = Json::array(), report["interpolated"] = Json::array();
  for (const ContinuedRun& one : answer.continued)
    report["continued_runs"].push_back({{"run", one.run}, {"by", one.by}});
  for (const InterpolatedCovariate& one : answer.interpolated)
    report["interpolated"].push_back(
        {{"run", one.run}, {"covariate", one.covariate}, {"readings", one.count}, {"of", one.of}});
  report["thinned"] = Json::array(), report["other_branch"] = Json::array();
  for (const ThinnedRun& one : answer.thinned)
    report["thinned"].push_back({{"run", one.run}, {"readings", one.count}, {"of", one.of}});
  for (const OtherBranch& one : answer.other_branch)
    report["other_branch"].push_back({{"run", one.run}, {"from", one.reading}});
  return report;
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

Json effects(const Diagnosis& diagnosis) {
  Json list = Json::array();
  for (const EstimatedEffect& one : estimated_effects(diagnosis)) {
    Json parameters = Json::object();
    for (const Estimate& value : one.values)
      parameters[value.name] = {{"value", value.value},
                                {"low", value.low},
                                {"high", value.high},
                                {"at_bound", value.at_bound},
                                {"unit", value.unit}};
    list.push_back({{"id", one.at.effect->id},
                    {"joint", one.at.joint > 0 ? Json(one.at.joint) : Json(nullptr)},
                    {"parameters", parameters}});
  }
  return list;
}

/// Most probable first; a cause outside of the catalogue, which predicts nothing beyond the nominal model, in
/// its place.
Json ranking(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  Json list = Json::array();
  const Json outside = {{"effects", {"unknown"}},
                        {"probability", cause.unknown},
                        {"chi2_per_dof", diagnosis.gap.chi2_per_value}};
  bool placed = false;
  for (const RankedCause& one : cause.ranking) {
    if (!placed && cause.unknown > one.probability) list.push_back(outside), placed = true;
    list.push_back({{"effects", effect_names(one.cause)},
                    {"probability", one.probability},
                    {"chi2_per_dof", one.chi2_per_value}});
  }
  if (!placed) list.push_back(outside);
  return list;
}

/// What a partial cause leaves.
Json rest(const Cause& cause) {
  if (!cause.rest) return nullptr;
  return {{"share", cause.rest->share}, {"noise_floor", cause.rest->noise_floor}, {"why", cause.rest->why}};
}

Json cause(const Diagnosis& diagnosis) {
  const Cause& found = diagnosis.cause;
  Json equivalent = Json::array(), probabilities = Json::array(), idle = Json::array();
  for (std::size_t i = 1; i < found.named; ++i) equivalent.push_back(effect_names(found.ranking[i].cause));
  if (found.or_unknown) equivalent.push_back({"unknown"});
  for (const EffectProbability& one : found.effects)
    probabilities.push_back({{"effect", one.label}, {"probability", one.probability}});
  for (const EffectAt& at : diagnosis.not_excited) idle.push_back(at.label());
  return {
      {"verdict", verdict_word(found.verdict)},
      {"effects", effects(diagnosis)},
      {"tolerances", found.is_explained() && found.ranking.front().hypothesis.candidate.has_all_tolerances()},
      {"equivalent", equivalent},
      {"fails_to_predict", diagnosis.fails_to_predict},
      {"discrepancy", found.discrepancy},
      {"discrepancy_torque", found.discrepancy_torque},
      {"ranking", ranking(diagnosis)},
      {"effect_probabilities", probabilities},
      {"rest", rest(found)},
      {"too_few_readings", found.too_few_readings},
      {"not_excited", idle}};
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
                 {"heldout", measured.heldout},
                 {"rms_before", by_label(measured.rms_before)},
                 {"rms_after", by_label(measured.rms_after)},
                 {"ratio", measured.ratio},
                 {"ratio_low", measured.ratio_low},
                 {"ratio_high", measured.ratio_high},
                 {"noise_floor_ratio", measured.noise_floor_ratio},
                 {"chi2_per_dof_after", measured.chi2_per_value_after},
                 {"channels", channels}};
  if (measured.outliers > 0)
    result["outliers"] = {{"count", measured.outliers}, {"ratio_with", measured.ratio_with_outliers}};
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
  if (diagnosis.calibration) report["calibration"] = calibration_as_json(*diagnosis.calibration);
  if (diagnosis.assumed_density > 0) report["assumed_density"] = diagnosis.assumed_density;
  if (!diagnosis.joints.empty()) report["joint_names"] = diagnosis.joints;
  return report;
}

}  // namespace plumbline::diagnose
