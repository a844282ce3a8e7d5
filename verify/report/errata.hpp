#pragma once
/// \file
/// The errata of a paper, each held by checks: what errata.toml says, less what is not so.

#include <map>
#include <string>
#include <vector>

#include "verify/judging/judge.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

struct JudgedErratum {
  Erratum erratum;                    ///< what of it holds: nothing else is to be printed
  Severity severity;                  ///< by what it changes
  std::vector<Judged> claims;         ///< not confirmed for this reason, in the order of the paper
  std::vector<std::string> problems;  ///< what it says and nothing holds, with the reason
};

struct Errata {
  std::vector<JudgedErratum> items;  ///< the gravest first, remarks last
  std::vector<Judged> open;          ///< claims that are not confirmed and belong to none: conventions

  /// Of all items. Empty where everything that is said holds.
  [[nodiscard]] std::vector<std::string> problems() const;
};

/// The errata that have a claim among those judged. A correction has to be confirmed by its claim's own
/// check; a sentence is held by the claims and facts that it names, which are judged here where they were not
/// yet, and each number with a point in it by one of their prints; what is said to stand has to be confirmed,
/// what is said to change not. \param paper  with its checks
Errata errata(const Paper& paper, const std::vector<Judged>& judged);

/// "14 errata: 6 of a formula or number, 8 of a statement; 5 remarks; 20 more claims fix a convention or lack
/// a condition".
std::string count_of(const Errata& errata);

/// The errata as a document to send, in Markdown and in LaTeX.
std::string errata_as_markdown(const Paper& paper, const std::vector<Judged>& judged);
/// A whole document, for any engine.
std::string errata_as_latex(const Paper& paper, const std::vector<Judged>& judged);

}  // namespace plumbline::verify
