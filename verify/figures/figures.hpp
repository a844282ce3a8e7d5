#pragma once
/// \file
/// The paper's figures 2 to 16, from computation.

#include <string>
#include <utility>
#include <vector>

#include "support/page/plot.hpp"
#include "verify/judging/judge.hpp"

namespace plumbline::verify {

struct Figure {
  int number;
  std::string title;
  std::size_t columns;  ///< panels in a row
  std::vector<page::Panel> (*draw)();
  std::vector<std::string> further_claims =
      {};  ///< ids, beside those whose place in the paper is this figure
};

/// The claims about a figure.
std::vector<Claim> claims_about(const Figure& figure);

/// Ids of claims by the verdict on them.
using Verdicts = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// The verdicts on the claims about a figure, found among judged ones.
Verdicts verdicts_about(const Figure& figure, const std::vector<Judged>& judged);

/// "confirmed: fig-8-smooth; refuted: fig-8-jump, fig-8-shapes".
std::string in_words(const Verdicts& verdicts);

/// All figures that are drawn, ascending.
const std::vector<Figure>& figures();

// Two links, and three links with a passive base (two_and_three_links.cpp).
std::vector<page::Panel> draw_figure_2();
std::vector<page::Panel> draw_figure_3();
std::vector<page::Panel> draw_figure_4();
std::vector<page::Panel> draw_figure_5();
std::vector<page::Panel> draw_figure_6();
std::vector<page::Panel> draw_figure_7();
std::vector<page::Panel> draw_figure_8();
std::vector<page::Panel> draw_figure_9();
// Four links (four_links.cpp).
std::vector<page::Panel> draw_figure_10();
std::vector<page::Panel> draw_figure_11();
std::vector<page::Panel> draw_figure_12();
std::vector<page::Panel> draw_figure_13();
std::vector<page::Panel> draw_figure_14();
std::vector<page::Panel> draw_figure_15();
std::vector<page::Panel> draw_figure_16();

}  // namespace plumbline::verify
