#include "verify/judging/judge.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>

#include "verify/claims/claims.hpp"
#include "verify/judging/notation.hpp"

namespace plumbline::verify {
namespace {

/// The sentences of a judgement in the notation of print.
Judgement set(Judgement judgement) {
  judgement.truth = in_notation(judgement.truth);
  judgement.subject = in_notation(judgement.subject);
  judgement.statement = in_notation(judgement.statement);
  for (Evidence& one : judgement.evidence) one.detail = in_notation(one.detail);
  return judgement;
}

}  // namespace

std::vector<Judged> judge(const std::vector<Claim>& claims, int digits,
                          const std::function<void()>& advance) {
  std::vector<Judged> result;
  for (const Claim& claim : claims) {
    try {
      result.push_back({claim, set(judge_print(claim, claim.printed, digits)), ""});
    } catch (const Error& error) {
      result.push_back({claim, std::nullopt, error.what()});
    } catch (const std::exception&) {  // whose words are those of a library
      result.push_back(
          {claim, std::nullopt, "the check cannot be carried out with this print and these premises"});
    }
    advance();
  }
  return result;
}

std::vector<Judged> judge_sampled(const SampledChains& sampled, std::uint64_t seed) {
  std::vector<Judged> result;
  for (const SampledProperty& p : sampled.properties) {
    Claim claim;
    claim.id = "sampled-" + p.name;
    std::replace(claim.id.begin(), claim.id.end(), ' ', '-');
    claim.where = "of random chains";
    claim.reading = in_notation(p.statement);
    claim.cause = claim.id;
    if (p.failures > 0) {
      result.push_back(
          {claim, std::nullopt,
           fmt::format("{} of {} chains fail, the first is {}", p.failures, p.chains, p.counterexample)});
      continue;
    }
    std::string detail = fmt::format("{} chains of seed {}, none fails; at most {:.2g} of the allowance used",
                                     p.chains, seed, p.worst_margin);
    if (p.name == "double") detail += "; " + summary(sampled.agreement);
    result.push_back({claim, set({Verdict::confirmed, "", {{EvidenceKind::sampled, detail}}, ""}), ""});
  }
  return result;
}

std::string section_of(const Claim& claim) {
  return claim.where.substr(0, claim.where.find(','));
}

std::vector<Claim> in_section(const std::vector<Claim>& claims, const std::string& section) {
  std::vector<Claim> result;
  std::set<std::string> sections;
  for (const Claim& claim : claims) {
    const std::string own = section_of(claim);
    sections.insert(own);
    if (section.empty() || own == section || own.starts_with(section + ".")) result.push_back(claim);
  }
  if (result.empty()) throw Error("--section", section, fmt::format("one of {}", fmt::join(sections, ", ")));
  return result;
}

std::vector<Claim> with_id(const std::vector<Claim>& claims, const std::string& id) {
  std::string written = id;  // as ids are: "eq 20" stands for eq-20
  std::replace_if(
      written.begin(), written.end(), [](unsigned char c) { return c == ' ' || c == '_'; }, '-');
  std::vector<std::string> alike;
  for (const Claim& claim : claims) {
    if (claim.id == id) return {claim};
    if (claim.id.find(written) != std::string::npos) alike.push_back(claim.id);
  }
  throw Error(
      "--claim", id,
      alike.empty() ? "an id that `plumbline verify` lists" : fmt::format("{}", fmt::join(alike, " or ")));
}

}  // namespace plumbline::verify
