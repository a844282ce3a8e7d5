#include "verify/figures/figures.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verify/claims/claims.hpp"

namespace plumbline::verify {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {2,
       "two links, straight: force and energy over deflection",
       2,
       draw_figure_2,
       {"straight-curve", "straight-stable"}},
      {3,
       "two links, bent at rest by pi/6: force and energy over deflection",
       2,
       draw_figure_3,
       {"curved-monotonic", "curved-single-minimum"}},
      {4, "three links on a passive base", 1, draw_figure_4, {"eq-4", "eq-5", "eq-7", "eq-9-angles"}},
      {5,
       "three links, straight and nearly straight: force over deflection",
       2,
       draw_figure_5,
       {"u-curve-stable"}},
      {6, "three links, straight: shapes after buckling", 2, draw_figure_6},
      {7, "three links, U-shaped at rest: force over deflection", 2, draw_figure_7},
      {8, "three links, Z-shaped at rest: force over deflection", 2, draw_figure_8},
      {9, "three links, Z-shaped at rest: energy over the first angle", 3, draw_figure_9},
      {10,
       "four links, bent at rest: the chains of Table 1",
       2,
       draw_figure_10,
       {"eq-11", "redundancy", "table-1-u", "table-1-z", "table-1-u-shape", "table-1-z-shape"}},
      {11, "four links, U-shaped at rest: energy surface at 0.4 L", 2, draw_figure_11},
      {12, "four links, U-shaped at rest: forces over deflection", 2, draw_figure_12},
      {13, "four links, Z-shaped at rest: energy surface at 0.4 L", 2, draw_figure_13},
      {14, "four links, Z-shaped at rest: forces over deflection", 2, draw_figure_14},
      {15,
       "four links, straight: shapes after buckling",
       2,
       draw_figure_15,
       {"four-link-shapes", "table-3-signs", "table-3-stability"}},
      {16, "four links, straight: energy surface at 0.5 L", 2, draw_figure_16},
  };
  return all;
}

std::vector<Claim> claims_about(const Figure& figure) {
  const std::string own =
      fmt::format(", Fig. {}", figure.number);  // where a claim stands at the figure itself
  std::vector<Claim> about;
  for (Claim& claim : all_claims()) {
    const std::size_t at = claim.where.find(own);
    const bool there = at != std::string::npos && (at + own.size() == claim.where.size() ||
                                                   std::isdigit(claim.where[at + own.size()]) == 0);
    const auto& more = figure.further_claims;
    if (there || std::find(more.begin(), more.end(), claim.id) != more.end())
      about.push_back(std::move(claim));
  }
  return about;
}

Verdicts verdicts_about(const Figure& figure, const std::vector<Judged>& judged) {
  Verdicts all{{"confirmed", {}}, {"refuted", {}}, {"imprecise", {}}, {"convention", {}}};
  for (const Claim& claim : claims_about(figure)) {
    const auto one =
        std::find_if(judged.begin(), judged.end(), [&](const Judged& j) { return j.claim.id == claim.id; });
    if (one == judged.end() || !one->judgement) continue;
    for (auto& [verdict, ids] : all)
      if (verdict == name(one->judgement->verdict)) ids.push_back(claim.id);
  }
  std::erase_if(all, [](const auto& part) { return part.second.empty(); });
  return all;
}

std::string in_words(const Verdicts& verdicts) {
  std::vector<std::string> parts;
  for (const auto& [verdict, ids] : verdicts)
    parts.push_back(fmt::format("{}: {}", verdict, fmt::join(ids, ", ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace plumbline::verify
