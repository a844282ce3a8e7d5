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
  const std::string name = fmt::format("Fig. {}", figure.number);
  std::vector<Claim> about;
  for (Claim& claim : all_claims()) {
    const std::size_t at = claim.where.find(name);
    const bool mentioned = at != std::string::npos && (at + name.size() == claim.where.size() ||
                                                       std::isdigit(claim.where[at + name.size()]) == 0);
    const auto& more = figure.further_claims;
    if (mentioned || std::find(more.begin(), more.end(), claim.id) != more.end())
      about.push_back(std::move(claim));
  }
  return about;
}

std::string sentence(const Figure& figure, const std::vector<Judged>& judged) {
  std::vector<std::string> agreed, others;
  for (const Claim& claim : claims_about(figure)) {
    const auto one =
        std::find_if(judged.begin(), judged.end(), [&](const Judged& j) { return j.claim.id == claim.id; });
    if (one == judged.end() || !one->judgement) continue;
    const Judgement& judgement = *one->judgement;
    if (judgement.verdict == Verdict::confirmed)
      agreed.push_back(claim.statement);
    else
      others.push_back(
          fmt::format("{}: \"{}\"; rather: {}", name(judgement.verdict), claim.statement, judgement.truth));
  }
  std::string text = "The paper is ";
  if (!agreed.empty()) text += fmt::format("confirmed: \"{}\"", fmt::join(agreed, "\", \""));
  if (!agreed.empty() && !others.empty()) text += ". It is ";
  return text + fmt::format("{}.", fmt::join(others, ". It is "));
}

}  // namespace plumbline::verify
