#pragma once
/// \file
/// The errata of the paper: claims that are not confirmed, those of one cause together, the gravest first.

#include <string>
#include <vector>

#include "verify/judging/judge.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

struct Erratum {
  Cause cause;                    ///< its id and, where paper.hpp has it, title, correction and effect
  Severity severity;              ///< of the gravest of its claims
  std::vector<Judged> claims;     ///< in the order of the paper
  std::vector<Judged> unchanged;  ///< what does not depend on it, as judged; only what is among those judged
};

/// By severity, then in the order of the paper.
std::vector<Erratum> errata(const std::vector<Judged>& judged);

/// "30 errata: 12 change a result, 1 a number, 9 the wording, 8 a convention".
std::string count_of(const std::vector<Erratum>& errata);

/// The errata as a document to send: by severity, each with place, print, truth, evidence and effect on the
/// paper's results.
std::string errata_as_markdown(const std::vector<Judged>& judged);
/// The same for LaTeX: a whole document, for any engine.
std::string errata_as_latex(const std::vector<Judged>& judged);

}  // namespace plumbline::verify
