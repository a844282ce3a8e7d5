#pragma once
/// \file
/// A claim of the paper: what is printed, the check that judges it, the judgement.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::verify {

enum class Verdict { confirmed, refuted, imprecise, convention };

/// From the strongest to the weakest.
enum class EvidenceKind { theorem, symbolic, exact, interval, mp50, real64, sampled };

struct Evidence {
  EvidenceKind kind;
  std::string detail;  ///< what was computed and what came out, so that a stranger can redo it
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

struct Claim {
  std::string id;
  std::string where;      ///< place in the paper, its section first: "4.1, (13)"
  std::string statement;  ///< one line
  Printed printed;
  Check check;
};

std::string_view name(Verdict verdict);
std::string_view name(EvidenceKind kind);

}  // namespace plumbline::verify
