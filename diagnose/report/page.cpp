#include <fmt/format.h>
#include <algorithm>

#include "diagnose/beliefs.hpp"
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
  if (key == "p_value") return page::NumberStyle::chance;
  if (key == "probability" || pointer.find("/explained/") != std::string::npos ||
      pointer.find("/proportional_noise/") != std::string::npos || key.find("ratio") != std::string::npos)
    return page::NumberStyle::percent;
  if (key == "from" || key == "to" || key == "joint") return page::NumberStyle::count;
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

/// The parameters of all effects of the best explanation, one a row.
Json parameters(const Json& effects, const Candidate& best,
                const std::vector<std::vector<Estimate>>& estimates) {
  Json rows = Json::array();
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const EffectAt& at = best.effects[e];
    for (const Estimate& one : estimates[e]) {
      Json row = effects[e]["parameters"][one.name];
      row["effect"] = at.effect->id;
      row["place"] = at.joint > 0 ? effects[e]["joint"] : Json("–");
      row["name"] = one.name;
      row["unit"] = one.unit;
      row["no_bounds"] = !(one.low < one.high);
      rows.push_back(row);
    }
  }
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

Json not_excluded(const Explained& explained, const Json& ranking) {
  Json list = Json::array();
  const Cause& cause = explained.diagnosis.cause;
  const auto add = [&](const std::string& who, const std::string& why) {
    if (!who.empty()) list.push_back({{"names", who}, {"why", why}});
  };
  for (const std::size_t place : cause.equivalent)
    add(cause.ranking[place].hypothesis.fit.candidate.name(),
        "these readings do not distinguish it from the best");
  const std::vector<std::size_t> places = listed_places(cause);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t place = places[i];
    const bool named =
        place == cause.best || std::count(cause.equivalent.begin(), cause.equivalent.end(), place) > 0;
    if (!named && cause.verdict != CauseVerdict::unknown && cause.ranking[place].probability >= 0.01)
      add(cause.ranking[place].hypothesis.fit.candidate.name(),
          "less probable, with " + ranking[i]["probability"].get<std::string>());
  }
  if (cause.reservation != Reservation::none) {
    add("unknown", reservation_words(cause.reservation));
  } else if (cause.verdict != CauseVerdict::unknown && cause.unknown >= 0.01) {
    add("unknown", "a cause outside the catalogue, with probability " +
                       ranking.back()["probability"].get<std::string>());
  }
  std::vector<std::string> idle;
  for (const EffectAt& at : explained.diagnosis.not_excited) idle.push_back(at.name());
  add(joined(idle, ", ", ", "), "not excited: no reading of these runs depends on it");
  add(out_of_sight(explained.study),
      "not considered: on this bench, with these channels, they change no measured value");
  return list;
}

/// Adds the cause, in the words of the verdict's sentence.
void add_cause(Json& view, const Json& report, const Explained& explained) {
  const Cause& cause = explained.diagnosis.cause;
  view["verdict"] = Json{{verdict_word(cause.verdict), true}};
  view["best"] = false;
  if (explained.best != nullptr) {
    const Candidate& best = explained.best->candidate;
    view["best"] = {
        {"names", best.name()},
        {"words", in_words(best)},
        {"model", explained.model},
        {"drawn", explained.diagnosis.offers_law() ? explained.model : explained.model + ": " + best.name()}};
    Json rows = parameters(view["cause"]["effects"], best, explained.diagnosis.estimates);
    const bool any = !rows.empty();
    view["explained"] = {{"any", any}, {"parameters", std::move(rows)}};
  }
  std::vector<std::string> alternatives;
  for (const std::size_t place : cause.equivalent)
    alternatives.push_back(in_words(cause.ranking[place].hypothesis.fit.candidate));
  if (cause.reservation != Reservation::none) alternatives.emplace_back("a cause outside the catalogue");
  view["alternatives"] = joined(alternatives, ", ", " or ");
  Json& ranking = view["cause"]["ranking"];
  for (Json& one : ranking) {
    std::string names;
    for (const Json& effect : one["effects"])
      names += (names.empty() ? "" : " + ") + effect.get<std::string>();
    one["names"] = names;
  }
  add_bars(ranking, report["cause"]["ranking"], "probability");
  // For `unknown`, that entry comes first.
  if (cause.verdict == CauseVerdict::unknown) std::rotate(ranking.begin(), ranking.end() - 1, ranking.end());
  view["ranked"] = {{"any", !ranking.empty()}};
  view["open"] = section(not_excluded(explained, ranking));
}

void add_where(Json& view, const Json& report, const Explained& explained) {
  const Where& where = explained.diagnosis.where;
  for (const char* list : {"channels", "runs", "load_path", "joints"})
    add_bars(view["where"][list], report["where"][list], "share");
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
  const std::vector<PageChart> curves = curve_charts(explained), residuals = residual_charts(explained);
  view["curves"] = charts(curves, false);
  view["some_heldout"] = !heldout_of(explained).empty();
  view["angle_curves"] = section(charts(curves, true));
  view["residuals"] = charts(residuals, false);
  view["angle_residuals"] = section(charts(residuals, true));
  view["shapes"] = charts(shape_charts(explained), false);
  view["rings"] = at_joints(explained);
  view["loops"] = section(charts(loop_charts(explained), false));
  if (!view.contains("law")) return;
  view["law"]["charts"] = charts(law_charts(explained), false);
  view["law"]["what_it_does"] = what_it_does(*explained.diagnosis.law);
  for (std::size_t i = 0; i < explained.diagnosis.law->pictures.size(); ++i) {
    const LawPicture& picture = explained.diagnosis.law->pictures[i];
    view["law"]["laws"][i]["whose"] = joint_words(picture.joints);
    view["law"]["laws"][i]["looks_like"] = resemblance_words(picture);
    view["law"]["laws"][i]["has_similar"] = !picture.resembles.empty();
  }
}

}  // namespace

std::string as_html(const Study& study, const Diagnosis& diagnosis) {
  const Explained explained(study, diagnosis);
  const Json report = as_json(diagnosis);
  Json view = page::with_marked_numbers(report, style_of);
  view["gap_level"] = fmt::format("{:g}", beliefs::gap_level);
  for (const auto& [sensor, scale] : view["gap"]["noise"].items())
    if (!sensor.starts_with("correlation")) view["noise"].push_back({{"sensor", sensor}, {"scale", scale}});
  for (const auto& [sensor, value] : view["gap"]["noise"]["correlations"].items())
    view["correlations"].push_back({{"sensor", sensor}, {"value", value}, {"last", false}});
  view["correlations"].back()["last"] = true;
  view["may_hide_ripple"] = diagnosis.may_hide_ripple();
  for (const auto& [sensor, share] : view["gap"]["proportional_noise"].items())
    view["proportional"].push_back({{"sensor", sensor}, {"share", share}});
  for (const auto& [sensor, times] : view["gap"]["noisier_joints"].items())
    view["uneven"].push_back({{"sensor", sensor}, {"factor", times}});
  if (const auto& runs = diagnosis.gap.taken_for_weights; !runs.empty())
    view["weights"] = fmt::format("{}", fmt::join(runs, ", "));
  view["channels_rms"] = gap_channels(diagnosis.gap, view["gap"]["rms"]);
  add_where(view, report, explained);
  add_cause(view, report, explained);
  view["nothing_predicts"] = diagnosis.nothing_predicts;
  if (diagnosis.shrink) {
    view["shrink"]["by_channel"] = shrink_channels(*diagnosis.shrink, view["shrink"]);
    const CauseVerdict verdict = diagnosis.cause.verdict;
    view["shrink"]["explains"] = verdict == CauseVerdict::identified || verdict == CauseVerdict::ambiguous;
    view["shrink"]["of_law"] = diagnosis.offers_law();
    view["shrink"]["grows"] = !(diagnosis.shrink->ratio < 1);
    view["shrink"]["heldout_names"] = joined(diagnosis.shrink->heldout, ", ", ", ");
  }
  view["proposals"] = {{"any", !diagnosis.proposals.empty()}};
  add_charts(view, explained);
  return page::document("Diagnosis of " + diagnosis.experiment,
                        "Where the gap between experiment and model lies, what causes it, how far it shrinks",
                        page::filled(diagnosis_template, view));
}

}  // namespace plumbline::diagnose
