#pragma once
/// \file
/// A claim of the paper: its words, how they are read, the check that judges them, the judgement.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::verify {

enum class Verdict { confirmed, refuted, imprecise, convention };

/// What a correction changes, the gravest first.
enum class Severity { result, number, wording, convention };

/// What a claim is about: a statement or formula, a printed number, or how a thing is named and referred to.
enum class Subject { statement, number, name };

/// From the strongest to the weakest.
enum class EvidenceKind { machine_checked, theorem, symbolic, exact, interval, mp50, real64, sampled };

struct Evidence {
  EvidenceKind kind;
  std::string detail;            ///< what was computed and what came out, so that a stranger can redo it
  std::string theorem;           ///< the name that proofs/theorems.md gives it; empty where it is none
  std::vector<std::string> coq;  ///< what proves it in proofs/coq, as "definite.M_definite"; or empty

  Evidence(EvidenceKind what, std::string computed) : kind(what), detail(std::move(computed)) {}
  /// Proved for every chain.
  static Evidence by_theorem(std::string name, std::string says) {
    Evidence evidence(EvidenceKind::theorem, std::move(says));
    evidence.theorem = std::move(name);
    return evidence;
  }
  /// Proved for every chain, and by all of `coq` in Coq: machine-checked where this build has checked them.
  static Evidence by_checked_theorem(std::string name, std::vector<std::string> coq, std::string says);
  /// Certified at points of a range, of a statement about the whole range: sampled, however sharp each point.
  static Evidence at_points(std::string computed) { return {EvidenceKind::sampled, std::move(computed)}; }
};

struct Judgement {
  Verdict verdict = Verdict::refuted;
  std::string truth;               ///< the true statement where the printed one is not; else empty
  std::vector<Evidence> evidence;  ///< strongest first
  std::string value;               ///< the number that the claim is about, where there is one; else empty
};

/// What the paper prints, as text that a check can read: formulas, decimals, counts, words.
using Printed = std::vector<std::string>;

/// Computes first, then compares with what is printed; the same check judges any altered print.
/// The second argument is the number of digits of Judgement::value.
/// \throws Error where the printed text cannot be judged
using Check = std::function<Judgement(const Printed&, int)>;

/// Where the function begins that checks a claim; no file where none of ours does.
struct CodeLine {
  std::string file;  ///< from the root of the project
  int line = 0;
};

struct Claim {
  std::string id;
  std::string where;               ///< place in the paper, its section first: "4.1, (13)"
  std::vector<std::string> also;   ///< other places that say the same
  std::string quote;               ///< the paper's own words or symbols, short
  std::string reading;             ///< what they are taken to say, one line
  bool charitable = false;         ///< whether of several readings the most favourable one is judged
  Printed printed;                 ///< the reading, as the check reads it
  std::vector<std::string> words;  ///< the only words that may be printed; empty where none are
  bool list = false;               ///< whether the number of entries is itself part of what is judged
  Subject subject = Subject::statement;
  std::string cause;  ///< claims that are wrong for one reason share it; by default the claim's own id
  Check check;
  CodeLine source;
};

/// Judges a print of the claim, its own or an altered one.
/// \throws Error where it cannot be judged, as for a word that is not among the claim's, or another number of
///         entries where that is none of what is judged
Judgement judge_print(const Claim& claim, const Printed& printed, int digits);

/// What a correction of the claim changes: a convention where the verdict is that; else wording where the
/// claim is about a name, or a statement lacks a condition; else a number or a result, as the claim's subject
/// is. Nothing for a confirmed claim.
std::optional<Severity> severity(const Claim& claim, Verdict verdict);

std::string_view name(Verdict verdict);
std::string_view name(Severity severity);
std::string_view name(EvidenceKind kind);

}  // namespace plumbline::verify
