#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnose/report/charts.hpp"
#include "diagnose/report/law.hpp"
#include "diagnose/report/page_texts.hpp"
#include "diagnose/report/report.hpp"
#include "support/page/markup.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

/// The style of a number by its place in the report.
page::NumberStyle style_of(const std::string& pointer) {
  const std::string key = pointer.substr(pointer.rfind('/') + 1);
  if (key == "share" || key == "discrepancy") return page::NumberStyle::share;
  if (key == "probability" || pointer.find("/explained/") != std::string::npos ||
      pointer.find("/proportional_noise/") != std::string::npos || key.find("ratio") != std::string::npos)
    return page::NumberStyle::percent;
  if (key == "from" || key == "to" || key == "joint" || key == "reading") return page::NumberStyle::count;
  if (key == "value" || key == "low" || key == "high") return page::NumberStyle::precise;
  return key == "expected_log_odds" ? page::NumberStyle::odds : page::NumberStyle::figures;
}

Json section(Json list) {
  const bool any = !list.empty();
  return {{"any", any}, {"list", std::move(list)}};
}

/// Adds to each entry of a list the width of its bar.
void add_bars(Json& list, const Json& report, const char* key) {
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i]["bar"] = fmt::format("{:.1f}", 100 * report[i][key].get<double>());
}

Json charts(const std::vector<PageChart>& drawings, bool angles) {
  Json list = Json::array();
  for (const PageChart& one : drawings)
    if (one.angle == angles) list.push_back({{"caption", one.caption}, {"svg", one.svg}});
  return list;
}

/// The measured channels of the gap, with the marked numbers of the report.
Json gap_channels(const GapAnswer& gap, const Json& marked) {
  Json list = Json::array();
  for (const auto& [channel, rms] : gap.rms)
    list.push_back({{"channel", channel.label()},
                    {"unit", channel.unit()},
                    {"rms", marked[channel.label()]},
                    {"last", false}});
  if (!list.empty()) list.back()["last"] = true;
  return list;
}

/// The noise by channel, and its part in proportion to the readings.
void add_noise(Json& view, const NoiseEstimate& noise) {
  const Json& marked = view["gap"]["noise"];
  Json channels = Json::array();
  for (const ChannelNoise& one : noise.channels) {
    const std::string label = one.channel.label();
    channels.push_back({{"channel", label},
                        {"scale", marked["scale"][label]},
                        {"correlation", marked["correlation"][label]},
                        {"last", false}});
  }
  channels.back()["last"] = true;
  view["noise"] = std::move(channels);
  for (const auto& [sensor, share] : view["gap"]["proportional_noise"].items())
    view["proportional"].push_back({{"sensor", sensor}, {"share", share}});
}

/// What has no weight, the largest first.
void add_outliers(Json& view, const GapAnswer& gap) {
  view["outliers"] = section(view["gap"]["outliers"]);
  if (gap.outliers.empty()) return;
  view["outliers"]["count"] = std::to_string(gap.outliers.size());
  view["outliers"]["several"] = gap.outliers.size() > 1;
  view["outliers"]["largest"] = view["gap"]["outliers"].front();
}

Json shrink_channels(const Shrink& shrink, const Json& marked) {
  Json list = Json::array();
  for (const auto& one : shrink.channels) {
    const Channel& channel = one.first;
    const std::string label = channel.label();
    Json row = marked["channels"][label];
    row["channel"] = label;
    row["unit"] = channel.unit();
    row["before"] = marked["rms_before"][label];
    row["after"] = marked["rms_after"][label];
    list.push_back(row);
  }
  return list;
}

/// The parameters of all effects of the leading cause, one a row.
Json parameters(const Json& effects, const Diagnosis& diagnosis) {
  Json rows = Json::array();
  const std::vector<EstimatedEffect> estimated = estimated_effects(diagnosis);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const EffectAt& at = estimated[e].at;
    for (const Estimate& one : estimated[e].values) {
      Json row = effects[e]["parameters"][one.name];
      row["effect"] = at.effect->id;
      row["place"] = at.joint > 0 ? effects[e]["joint"] : Json("–");
      row["name"] = one.name;
      row["unit"] = one.unit;
      row["no_bounds"] = !(one.low < one.high);
      row["last"] = false;
      rows.push_back(row);
    }
  }
  if (!rows.empty()) rows.back()["last"] = true;
  return rows;
}

/// Effects that change no measured value on this bench.
std::string out_of_sight(const Study& study) {
  const std::vector<EffectAt> possible = possible_effects(study);
  std::vector<std::string> parts;
  for (const Effect* row : study.effects()) {
    if (std::none_of(possible.begin(), possible.end(), [&](const EffectAt& at) { return at.effect == row; }))
      parts.push_back(row->id);
  }
  return joined(parts, ", ", ", ");
}

/// \param ranking  of the report, numbers marked
Json not_excluded(const Explained& explained, const Json& ranking) {
  constexpr double noticeable = 0.01;
  Json list = Json::array();
  const Cause& cause = explained.diagnosis.cause;
  const auto add = [&](const std::string& who, const std::string& why) {
    if (!who.empty()) list.push_back({{"names", who}, {"why", why}});
  };
  std::size_t place = 0;
  for (const Json& entry : ranking) {
    const std::string probability = entry["probability"].get<std::string>();
    if (entry["unknown"].get<bool>()) {
      if (cause.is_explained() && (cause.or_unknown || cause.unknown >= noticeable))
        add("unknown", "a cause outside the catalogue, with probability " + probability);
      continue;
    }
    const RankedCause& one = cause.ranking[place];
    if (place > 0 && place < cause.named)
      add(one.cause.name(), "these readings do not distinguish it from the best; probability " + probability);
    else if (place >= cause.named && cause.is_explained() && one.probability >= noticeable)
      add(one.cause.name(), "less probable, with " + probability);
    ++place;
  }
  std::vector<std::string> idle;
  for (const EffectAt& at : explained.diagnosis.not_excited) idle.push_back(at.name());
  add(joined(idle, ", ", ", "), "not excited: no reading of these runs depends on it");
  add(out_of_sight(explained.study),
      "not considered: on this bench, with these channels, they change no measured value");
  return list;
}

/// Adds names, bars and the place of the unknown cause to the ranking.
void complete_ranking(Json& view, const Json& report) {
  Json& ranking = view["cause"]["ranking"];
  for (Json& one : ranking) {
    std::string names;
    for (const Json& effect : one["effects"])
      names += (names.empty() ? "" : " + ") + effect.get<std::string>();
    one["names"] = names;
    one["unknown"] = names == "unknown";
    if (one["unknown"].get<bool>()) view["outside"] = one["probability"];
  }
  add_bars(ranking, report["cause"]["ranking"], "probability");
}

/// Adds the cause, in the words of the verdict's sentence.
void add_cause(Json& view, const Json& report, const Explained& explained) {
  const Diagnosis& diagnosis = explained.diagnosis;
  const Cause& cause = diagnosis.cause;
  view["verdict"] = Json{{verdict_word(cause.verdict), true}};
  view["best"] = false;
  if (explained.best != nullptr) {
    const Candidate& best = explained.best->cause;
    view["best"] = {
        {"names", best.name()},
        {"words", in_words(best)},
        {"model", explained.model},
        {"drawn", diagnosis.offers_law() ? explained.model : explained.model + ": " + best.name()}};
    view["beside_tolerances"] = shows_tolerances(*explained.best);
  }
  Json rows = parameters(view["cause"]["effects"], diagnosis);
  const bool any = !rows.empty();
  view["explained"] = {{"any", any}, {"parameters", std::move(rows)}};
  view["discrepancy"] = cause.discrepancy > 0 ? view["cause"]["discrepancy"] : Json(false);
  std::vector<std::string> alternatives;
  for (std::size_t i = 1; i < cause.named; ++i) alternatives.push_back(in_words(cause.ranking[i].cause));
  if (cause.or_unknown)
    alternatives.push_back("a cause outside the catalogue" +
                           std::string(outside_is_likelier(cause) ? ", which is more probable" : ""));
  view["alternatives"] = joined(alternatives, ", ", " or ");
  Json parts = Json::array();
  for (std::size_t i = 0; i < told_effects(cause); ++i)
    parts.push_back({{"words", effect_in_words(cause, cause.effects[i].label)},
                     {"probability", view["cause"]["effect_probabilities"][i]["probability"]}});
  view["parts"] = section(std::move(parts));
  complete_ranking(view, report);
  view["open"] = section(not_excluded(explained, view["cause"]["ranking"]));
}

void add_where(Json& view, const Json& report, const Explained& explained) {
  const Where& where = explained.diagnosis.where;
  for (const char* list : {"channels", "runs", "load_path", "joints"})
    add_bars(view["where"][list], report["where"][list], "share");
  for (std::size_t i = 0; i < where.joints.size() && !explained.diagnosis.joints.empty(); ++i)
    view["where"]["joints"][i]["named"] = explained.diagnosis.joints[where.joints[i].joint - 1];
  view["where"]["has_path"] = !where.load_path.empty();
  view["joint_evidence"] = joint_evidence_words(where.joint_evidence);
  view["most"] = {
      {"channel", where.channels.front().channel.label()}, {"run", where.runs.front().run}, {"joint", false}};
  if (where.joint_evidence == JointEvidence::measured && where.joints.front().share > 0.5)
    view["most"]["joint"] = std::to_string(where.joints.front().joint);
  if (!explained.diagnosis.missing) return;
  const PageChart chart = missing_chart(*explained.diagnosis.missing);
  view["unexplained"] = view["where"]["unexplained"];
  view["unexplained"].erase("points");
  view["unexplained"]["chart"] = {{"caption", chart.caption}, {"svg", chart.svg}};
}

void add_charts(Json& view, const Explained& explained) {
  std::vector<DrawnModel> models{{"nominal", &explained.nominal}};
  if (explained.best != nullptr) models.push_back({"corrected", &explained.corrected});
  const std::vector<PageChart> curves = curve_charts(explained.study, models, heldout_of(explained)),
                               residuals = residual_charts(explained);
  view["tips"] = section(charts(tip_charts(explained.study, models), false));
  view["curves"] = charts(curves, false);
  view["some_heldout"] = !heldout_of(explained).empty();
  view["angle_curves"] = section(charts(curves, true));
  view["residuals"] = charts(residuals, false);
  view["angle_residuals"] = section(charts(residuals, true));
  const std::vector<PageChart> drawn = shape_charts(explained);
  view["shapes"] = charts(drawn, false);
  view["has_shapes"] = !drawn.empty();
  view["rings"] = at_joints(explained);
  view["loops"] = section(charts(loop_charts(explained), false));
  if (!view.contains("law")) return;
  view["law"]["charts"] = charts(law_charts(explained), false);
  view["law"]["what_it_does"] = what_it_does(*explained.diagnosis.law);
  for (std::size_t i = 0; i < explained.diagnosis.law->pictures.size(); ++i)
    view["law"]["laws"][i]["whose"] = joint_words(explained.diagnosis.law->pictures[i].joints);
}

}  // namespace

std::string as_html(const Study& study, const Diagnosis& diagnosis) {
  const Explained explained(study, diagnosis);
  const Json report = as_json(diagnosis);
  Json view = page::with_marked_numbers(report, style_of);
  add_noise(view, diagnosis.noise);
  add_outliers(view, diagnosis.gap);
  if (const auto& runs = diagnosis.gap.taken_for_weights; !runs.empty())
    view["weights"] = fmt::format("{}", fmt::join(runs, ", "));
  view["channels_rms"] = gap_channels(diagnosis.gap, view["gap"]["rms"]);
  add_where(view, report, explained);
  add_cause(view, report, explained);
  if (diagnosis.shrink) {
    if (!view["shrink"].contains("outliers")) view["shrink"]["outliers"] = false;
    view["shrink"]["by_channel"] = shrink_channels(*diagnosis.shrink, view["shrink"]);
    view["shrink"]["model"] = tested_model(diagnosis);
    view["shrink"]["heldout_names"] = joined(diagnosis.shrink->heldout, ", ", ", ");
  }
  view["arm"] = explained.experiment.arm != nullptr;
  view["planar"] = explained.experiment.is_planar();
  view["torque_unit"] = std::string(diagnosis.cause.torque_unit);
  view["proposals"] = {{"any", !diagnosis.proposals.empty()}};
  add_charts(view, explained);
  return page::document("Diagnosis of " + diagnosis.experiment,
                        "Where the gap between experiment and model lies, what causes it, how far it shrinks",
                        page::filled(diagnosis_template, view));
}

}  // namespace plumbline::diagnose
