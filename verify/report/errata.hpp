#pragma once
/// \file
/// The errata of a paper: what errata.toml names, in the words of the paper and of the checks.

#include <string>
#include <vector>

#include "verify/judging/judge.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

/// An erratum as far as it holds: nothing else is to be printed.
struct JudgedErratum {
  std::string id;
  bool remark = false;
  Severity severity;                    ///< by what it changes
  std::vector<Judged> claims;           ///< not confirmed for this reason, in the order of the paper
  std::vector<Correction> corrections;  ///< confirmed by their claims' own checks
  std::vector<std::string> reason;      ///< sentences that checks made of what they found
  std::vector<std::string> stands;      ///< passages that are confirmed all the same, as the paper has them
  std::vector<std::string> changes;     ///< passages that are not
  std::vector<std::string> problems;    ///< what it says and nothing holds, with the reason
};

struct Errata {
  std::vector<JudgedErratum> items;  ///< the gravest first, remarks last
  std::vector<Judged> open;          ///< claims that are not confirmed and belong to none: conventions

  /// Of all items. Empty where everything that is said holds.
  [[nodiscard]] std::vector<std::string> problems() const;
};

/// The errata that have a claim among those judged. A correction has to be confirmed by its claim's own
/// check. A reason is what a check found: of a claim that is not confirmed the truth, of a confirmed fact its
/// statement. Passages that are said to stand have to be confirmed, those said to change not.
/// \param paper  with its checks
Errata errata(const Paper& paper, const std::vector<Judged>& judged);

/// "4.2, after (34); also Nomenclature".
std::string place_of(const Claim& claim);

/// "14 errata: 6 of a formula or number, 8 of a statement; 5 remarks; 20 more claims fix a convention or lack
/// a condition".
std::string count_of(const Errata& errata);

/// What is confirmed in all that was judged about it: equations, tables and figures, by name.
std::string confirmed_by_name(const std::vector<Judged>& judged);

/// The errata as a document to send, in Markdown and in LaTeX.
std::string errata_as_markdown(const Paper& paper, const std::vector<Judged>& judged);
/// A whole document, for any engine.
std::string errata_as_latex(const Paper& paper, const std::vector<Judged>& judged);

}  // namespace plumbline::verify
