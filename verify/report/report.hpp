#pragma once
/// \file
/// What `plumbline verify` says, for people and for machines.

#include <nlohmann/json.hpp>
#include <string>

#include "verify/figures/figures.hpp"
#include "verify/judging/judge.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

struct Style {
  bool colour = false;      ///< terminal colours
  std::size_t columns = 0;  ///< of the terminal, 0 where there is none: then no reading is cut
};

/// Whether the proofs of the theorems were checked in this build, by what, and how many.
std::string proofs_checked();

/// A table by section, one line a claim; a summary; then the errata, those of one cause together.
/// \param paper  with its checks
std::string as_table(const Paper& paper, const std::vector<Judged>& judged, const Style& style);

/// Everything about one claim.
std::string as_detail(const Judged& judged, bool colour);

/// A list of objects with the keys id, where, quote, reading, charity, printed, favoured (the print in the
/// favourable reading that was judged; empty where literal), given, verdict, severity and cause
/// (null where there is nothing to correct), truth, evidence (a list of kind, detail, for a theorem its
/// name and the names of its proofs in Coq), value. A claim that could not be judged has the verdict
/// "unjudged" and the reason as its truth.
nlohmann::ordered_json as_json(const std::vector<Judged>& judged);

/// A figure of the paper, redrawn.
struct DrawnFigure {
  int number;
  std::string title;
  Verdicts verdicts;  ///< of the claims about it
  std::string svg;
};

/// A page for people to look at, whole in one file: the claims by section, to be filtered by verdict, each at
/// the anchor of its id, and the figures.
std::string as_html(const Paper& paper, const std::vector<Judged>& judged,
                    const std::vector<DrawnFigure>& figures);

}  // namespace plumbline::verify
