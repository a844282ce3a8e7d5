#pragma once
/// \file
/// How a printed formula, decimal or word is compared with what was computed.

#include <map>
#include <plumbline/base/interval.hpp>

#include "proofs/exact/expression.hpp"
#include "verify/judging/claim.hpp"

namespace plumbline::verify {

/// Printed formulas against computed expressions, entry by entry; `names` label the entries.
/// Confirmed when all are identical. Else refuted, with the computed expression of each wrong entry as the
/// truth.
/// \throws Error when the counts differ
Judgement judge_formulas(const proofs::Formulas& formulas, const Printed& printed,
                         const std::vector<GiNaC::ex>& computed, const std::vector<std::string>& names,
                         const std::string& how);

/// Printed sides of equations "side = 0" against computed ones: confirmed when each is its own, times a
/// number other than zero.
Judgement judge_equations(const proofs::Formulas& formulas, const Printed& printed,
                          const std::vector<GiNaC::ex>& computed, const std::vector<std::string>& names,
                          const std::string& how);

/// A printed word against the computed one: confirmed or refuted, with the truth as a full sentence.
Judgement judge_word(const std::string& printed, const std::string& computed, const std::string& truth,
                     std::vector<Evidence> evidence);

/// A printed list against the computed one, complete and in its order: confirmed or refuted.
Judgement judge_list(const Printed& printed, const std::vector<std::string>& computed,
                     const std::string& truth, std::vector<Evidence> evidence);

/// A printed table of rows of so many entries against the computed one, the rows in any order.
Judgement judge_rows(const Printed& printed, const std::vector<std::string>& computed, std::size_t width,
                     const std::string& truth, std::vector<Evidence> evidence);

/// Counts of things such as "2 minima, 1 saddle", in any order, the things that there are none of left out.
class Counts {
 public:
  Counts() = default;
  /// \throws Error that quotes what are no counts
  explicit Counts(const std::string& text);
  void add(const std::string& thing) { ++count_[thing]; }
  /// Of one thing; 0 where there is none.
  [[nodiscard]] std::size_t of(const std::string& thing) const;
  [[nodiscard]] std::size_t total() const;
  /// In the order in which the things are best read.
  [[nodiscard]] std::string text() const;
  bool operator==(const Counts&) const = default;

 private:
  std::map<std::string, std::size_t> count_;
};

/// Printed counts against the computed ones: confirmed or refuted.
Judgement judge_counts(const std::string& printed, const std::string& computed, const std::string& truth,
                       std::vector<Evidence> evidence);

/// A printed count such as "n-1" against the count computed for n = 2 … 6: confirmed or refuted.
Judgement judge_count(const std::string& printed, const std::function<std::size_t(std::size_t)>& count,
                      const std::string& truth, EvidenceKind kind, const std::string& how);

/// The sizes that judge_count tries.
inline constexpr std::size_t fewest = 2;
inline constexpr std::size_t most = 6;

/// Adds evidence in its place, the strongest first.
Judgement with_evidence(Judgement judgement, Evidence evidence);

/// Printed decimals against certified enclosures. A decimal claims half a unit of its last place: confirmed
/// when the computed values round to what is printed, imprecise when all are within a unit, else refuted. The
/// truth lists each wrong entry by its name.
/// \throws Error when an enclosure is too wide to decide a rounding
Judgement judge_decimals(const Printed& printed, const std::vector<Interval>& computed,
                         const std::vector<std::string>& names, const std::string& how);

/// The common rounding of all values of an enclosure to so many significant digits.
/// \throws Error when it is too wide
std::string certified_decimal(const Interval& value, int digits);

/// The least favourable of two verdicts: refuted, imprecise, convention, confirmed.
Verdict worst(Verdict a, Verdict b);

}  // namespace plumbline::verify
