#pragma once
/// \file
/// What `plumbline verify` says, for people and for machines.

#include <nlohmann/json.hpp>
#include <string>

#include "verify/judging/judge.hpp"

namespace plumbline::verify {

/// A table by section, one line a claim; a summary; then the errata: every claim that is not confirmed as
/// printed, with the true statement. At most 80 columns. \param colour with terminal colours
std::string as_table(const std::vector<Judged>& judged, bool colour);

/// Everything about one claim.
std::string as_detail(const Judged& judged, bool colour);

/// A list of objects with the keys id, where, statement, verdict, truth, evidence (a list of kind and
/// detail), value. A claim that could not be judged has the verdict "unjudged" and the reason as its truth.
nlohmann::ordered_json as_json(const std::vector<Judged>& judged);

/// A figure of the paper, redrawn.
struct DrawnFigure {
  int number;
  std::string title, sentence;  ///< what is drawn; what the paper's drawing shows, and whether it agrees
  std::string svg;
};

/// A page for people to look at, whole in one file: the claims by section, to be filtered by verdict, each at
/// the anchor of its id, and the figures.
std::string as_html(const std::vector<Judged>& judged, const std::vector<DrawnFigure>& figures);

}  // namespace plumbline::verify
