#pragma once
/// \file
/// Runs the checks of claims.

#include <functional>
#include <optional>

#include "verify/judging/claim.hpp"
#include "verify/sampled/sampled.hpp"

namespace plumbline::verify {

struct Judged {
  Claim claim;
  std::optional<Judgement> judgement;  ///< nothing when the claim could not be judged
  std::string problem;                 ///< then why
};

/// Judges claims one after another, as printed. `digits` is for their values, 1 to 50; `advance` is called
/// after each.
std::vector<Judged> judge(
    const std::vector<Claim>& claims, int digits, const std::function<void()>& advance = [] {});

/// The properties that random chains were checked for, as claims of our own theorems (proofs/theorems.md).
/// One that a chain contradicts counts as not judged: theorem, computation or number types disagree.
std::vector<Judged> judge_sampled(const SampledChains& sampled, std::uint64_t seed);

/// The claims that stand in a section ("4.2", or "4" for all of its parts), or all when it is empty.
/// \throws Error that lists the sections when there is none
std::vector<Claim> in_section(const std::vector<Claim>& claims, const std::string& section);

/// The claim of that id, as a list of one.
/// \throws Error that names ids alike when there is none
std::vector<Claim> with_id(const std::vector<Claim>& claims, const std::string& id);

/// The section that a claim stands in: "4.2" of "4.2, (34)".
std::string section_of(const Claim& claim);

}  // namespace plumbline::verify
