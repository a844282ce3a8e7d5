#include "diagnose/report/law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnose/beliefs.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;
using Kind = page::Layer::Kind;

Json as_json(const std::vector<FreeLaw::Knot>& knots) {
  Json all = Json::array();
  for (const FreeLaw::Knot& one : knots) all.push_back({one.deflection, one.torque});
  return all;
}

Json picture_as_json(const LawPicture& picture) {
  Json sliders = Json::array(), arms = Json::array();
  for (const auto& one : picture.sliders)
    sliders.push_back({{"slips_at", one.slips_at},
                       {"torque", one.torque},
                       {"growth", one.growth},
                       {"profile", as_json(one.profile)}});
  for (const auto& one : picture.arms)
    arms.push_back({{"time_constant", one.time_constant}, {"stiffness", one.stiffness}});
  return {{"joints", picture.joints},     {"knots", as_json(picture.knots)},
          {"sliders", sliders},           {"relaxation", arms},
          {"description", picture.words}, {"similar_effects", picture.resembles}};
}

std::vector<std::string> beside(const OfferedLaw& offered) {
  std::vector<std::string> names;
  for (const EffectAt& at : offered.law.base.candidate.effects) names.push_back(at.label());
  return names;
}

/// The law, the nominal spring, and the runs of one joint.
page::Chart law_chart(const Explained& explained, std::size_t law, std::size_t joint) {
  const OfferedLaw& offered = *explained.diagnosis.law;
  const double k = explained.experiment.joint_stiffness[joint - 1];
  const double share = k / offered.law.laws[law].stiffness;
  page::Layer spring{Kind::line, "nominal", {}}, bare{Kind::rings, "corrected", {}, 2.4};
  for (const FreeLaw::Knot& knot : offered.pictures[law].knots) {
    spring.points.push_back({knot.deflection, k * knot.deflection});
    bare.points.push_back({knot.deflection, share * knot.torque});
  }
  page::Chart chart{fmt::format("law-{}", joint),
                    fmt::format("Torque law of joint {}", joint),
                    "Torque of the joint over its deflection: knots of the law without memory as rings, "
                    "the runs as bold lines, the nominal spring as a thin one.",
                    fmt::format("deflection of joint {}, rad", joint),
                    "torque, N m",
                    {spring}};
  for (const LawTrace& trace : offered.traces) {
    if (trace.joint != joint) continue;
    page::Layer path{Kind::line, "corrected", {}};
    for (Eigen::Index i = 0; i < trace.torque.size(); ++i)
      path.points.push_back({trace.deflection(i), trace.torque(i)});
    chart.layers.push_back(std::move(path));
  }
  chart.layers.push_back(bare);
  return chart;
}

/// The torque that the law adds to the nominal spring, over time.
page::Chart memory_chart(const Explained& explained, const LawTrace& trace) {
  const Run& run = explained.experiment.runs[trace.run];
  const double k = explained.experiment.joint_stiffness[trace.joint - 1];
  page::Layer path{Kind::line, "corrected", {}};
  for (Eigen::Index i = 0; i < trace.torque.size(); ++i)
    path.points.push_back(
        {run.readings[static_cast<std::size_t>(i)].t, trace.torque(i) - k * trace.deflection(i)});
  return {fmt::format("law-memory-{}-{}", trace.joint, trace.run + 1),
          fmt::format("Torque that the law adds at joint {} in run {}", trace.joint, run.id),
          "Torque of the law minus that of the nominal spring, over time.",
          "t, s",
          fmt::format("added at joint {}, N m", trace.joint),
          {path}};
}

}  // namespace

nlohmann::ordered_json law_as_json(const OfferedLaw& offered) {
  Json laws = Json::array();
  for (const LawPicture& picture : offered.pictures) laws.push_back(picture_as_json(picture));
  Json result = {{"id", "torque_law"},
                 {"with_effects", beside(offered)},
                 {"laws", laws},
                 {"cross_validated", offered.law.cross_validated}};
  if (!offered.shrink) return result;
  result["heldout"] = offered.shrink->heldout;
  result["ratio"] = offered.shrink->ratio;
  result["ratio_low"] = offered.shrink->ratio_low;
  result["ratio_high"] = offered.shrink->ratio_high;
  result["noise_floor_ratio"] = offered.shrink->noise_floor_ratio;
  return result;
}

std::string joint_words(const std::vector<std::size_t>& joints) {
  std::string text = joints.size() == 1 ? "joint " : "joints ";
  for (std::size_t i = 0; i < joints.size(); ++i) text += (i > 0 ? ", " : "") + std::to_string(joints[i]);
  return text;
}

std::string what_it_does(const OfferedLaw& offered) {
  constexpr double nearly = 2;
  if (!offered.shrink || !(offered.shrink->ratio < 1)) return "fitted to";
  const double floor = offered.shrink->noise_floor_ratio;
  return offered.shrink->ratio <= std::max(nearly * floor, beliefs::closed) ? "that closes" : "that narrows";
}

std::string resemblance_words(const LawPicture& picture) {
  std::vector<std::string> features;
  for (const std::vector<std::string>& alike : picture.resembles)
    features.push_back(fmt::format("{}", fmt::join(alike, " or ")));
  return fmt::format("{}", fmt::join(features, ", with "));
}

std::string law_as_text(const OfferedLaw& offered) {
  std::string text = "  a torque law " + what_it_does(offered) + " the gap (a description, not a cause)";
  const std::vector<std::string> base = beside(offered);
  for (std::size_t i = 0; i < base.size(); ++i) text += (i == 0 ? ", together with " : " + ") + base[i];
  text += ":\n";
  for (const LawPicture& picture : offered.pictures) {
    text += fmt::format("    {}: {}\n", joint_words(picture.joints), picture.words);
    if (!picture.resembles.empty()) text += "      similar to " + resemblance_words(picture) + "\n";
  }
  if (!offered.shrink)
    return text +
           fmt::format(
               "    not tested: the other readings never bend the joints as far as the held-out ones; in "
               "cross-validation over the readings used, {:.2g} of the residual remains\n",
               offered.law.cross_validated);
  return text +
         fmt::format(
             "    leaves {:.3g} of the residual on the held-out readings (95 %: {:.3g} to {:.3g}; noise "
             "floor {:.3g})\n",
             offered.shrink->ratio, offered.shrink->ratio_low, offered.shrink->ratio_high,
             offered.shrink->noise_floor_ratio);
}

std::vector<PageChart> law_charts(const Explained& explained) {
  std::vector<PageChart> charts;
  const std::optional<OfferedLaw>& offered = explained.diagnosis.law;
  if (!offered) return charts;
  for (std::size_t law = 0; law < offered->pictures.size(); ++law) {
    const LawPicture& picture = offered->pictures[law];
    for (const std::size_t joint : picture.joints)
      charts.push_back({fmt::format("Joint {}: torque over deflection", joint),
                        page::drawn(law_chart(explained, law, joint))});
    if (picture.sliders.empty() && picture.arms.empty()) continue;
    for (const LawTrace& trace : offered->traces)
      if (trace.joint == picture.joints.front())
        charts.push_back({fmt::format("{}: torque that the law adds at joint {}",
                                      explained.experiment.runs[trace.run].id, trace.joint),
                          page::drawn(memory_chart(explained, trace))});
  }
  return charts;
}

}  // namespace plumbline::diagnose
