#pragma once
/// \file
/// A claim of the paper: its words, how they are read, the check that judges them, the judgement.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "verify/judging/premises.hpp"

namespace plumbline::verify {

enum class Verdict { confirmed, refuted, imprecise, convention };

/// What a correction changes, the gravest first: a printed result that others build on, a formula or number
/// that nothing printed builds on, a statement, a wording; or it fixes what the print leaves open.
enum class Severity { result, formula, statement, wording, convention };

/// What a claim is about: a statement, a formula, a printed number, or how a thing is named and referred to.
enum class Subject { statement, formula, number, name };

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
  Printed favoured = {};       ///< the print in the favourable reading that was judged; empty where literal
  std::string subject = {};    ///< of the statement, "the chain with …"; empty where it is a whole sentence
  std::string statement = {};  ///< what is so, right print or wrong; empty where a check has none
};

/// Computes first, from what is given, then compares with what is printed; the same check judges any altered
/// print under any altered premise. The last argument is the number of digits of Judgement::value.
/// \throws Error where the printed text cannot be judged
class Check {
 public:
  Check() = default;
  /// \param judge  a function of the print and the digits alone, or of the print, the premises and the digits
  template <class Judge>
  requires(!std::is_same_v<std::remove_cvref_t<Judge>, Check>)
      Check(Judge judge) {  // NOLINT(google-explicit-constructor): a check is its function
    if constexpr (std::is_invocable_v<Judge, const Printed&, const Premises&, int>)
      judge_ = std::move(judge);
    else
      judge_ = [judge](const Printed& printed, const Premises&, int digits) {
        return judge(printed, digits);
      };
  }
  Judgement operator()(const Printed& printed, const Premises& given, int digits) const {
    return judge_(printed, given, digits);
  }

 private:
  std::function<Judgement(const Printed&, const Premises&, int)> judge_;
};

/// A check that the claim's own words state: one of verify/generic by name, with its parameters.
struct StatedCheck {
  std::string kind;  ///< empty where there is none
  std::map<std::string, Printed> with;
  std::string place;  ///< file and line, for errors
};

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
  Premises given;                  ///< all that the check may take from the paper besides
  std::vector<std::string> words;  ///< the only words that may be printed; empty where none are
  bool list = false;               ///< whether the number of entries is itself part of what is judged
  Subject subject = Subject::statement;
  std::string cause;  ///< claims that are wrong for one reason share it; by default the claim's own id
  StatedCheck stated;
  Check check;
  CodeLine source;
};

/// Judges a print of the claim, its own or an altered one: literally, and where that is not true and the
/// claim is read with favour, with all behind a slash as the denominator.
/// \throws Error where it cannot be judged, as for a word that is not among the claim's, or another number of
///         entries where that is none of what is judged
Judgement judge_print(const Claim& claim, const Printed& printed, int digits);

/// What a correction of the claim changes by itself: a convention where the verdict is that; else wording
/// where the claim is about a name; a formula or a statement as its subject is. Nothing for a confirmed
/// claim. That a result changes is for the erratum to say.
std::optional<Severity> severity(const Claim& claim, Verdict verdict);

std::string_view name(Verdict verdict);
std::string_view name(Severity severity);
std::string_view name(EvidenceKind kind);

}  // namespace plumbline::verify
