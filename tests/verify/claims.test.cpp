#include "verify/claims/claims.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <plumbline/base/error.hpp>
#include <set>

#include "proofs/coq/machine_checked.hpp"
#include "tests/verify/true_prints.hpp"
#include "verify/judging/judge.hpp"
#include "verify/report/report.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

Verdict verdict_on(const Claim& claim, const Printed& printed) {
  return judge_print(claim, printed, 10).verdict;
}

/// The headings of proofs/theorems.md.
std::set<std::string> theorems() {
  std::ifstream file(PLUMBLINE_SOURCE_DIR "/proofs/theorems.md");
  std::set<std::string> names;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ") && line != "## Notation") names.insert(line.substr(3));
  }
  return names;
}

Claim find(const std::string& id) {
  return with_id(all_claims(), id).front();
}

}  // namespace

TEST_CASE("ids are unique, and every claim says where it stands") {
  std::set<std::string> ids;
  for (const Claim& claim : all_claims()) {
    CHECK_MESSAGE(ids.insert(claim.id).second, claim.id);
    CHECK_MESSAGE(!section_of(claim).empty(), claim.id);
    CHECK_MESSAGE(!claim.quote.empty(), claim.id);
    CHECK_MESSAGE(!claim.reading.empty(), claim.id);
    CHECK_MESSAGE(claim.reading.find('\n') == std::string::npos, claim.id);
  }
}

TEST_CASE(
    "every claim can be judged, with evidence, the strongest first, and a truth where the print is not") {
  const std::set<std::string> proved = theorems();
  REQUIRE(proved.contains("Simple modes"));
  const bool checked = !proofs::coq_version().empty();
  for (const Judged& judged : judge(all_claims(), 50)) {
    INFO(judged.claim.id, ": ", judged.problem);
    REQUIRE(judged.judgement);
    const auto& evidence = judged.judgement->evidence;
    REQUIRE_FALSE(evidence.empty());
    CHECK(std::is_sorted(evidence.begin(), evidence.end(),
                         [](const Evidence& a, const Evidence& b) { return a.kind < b.kind; }));
    for (const Evidence& one : evidence) {
      INFO(one.detail);
      CHECK(proved.contains(one.theorem) == (one.kind <= EvidenceKind::theorem));
      if (!one.coq.empty()) CHECK((one.kind == EvidenceKind::machine_checked) == checked);
    }
    CHECK(judged.judgement->truth.empty() == (judged.judgement->verdict == Verdict::confirmed));
  }
}

TEST_CASE("a claim is machine-checked exactly where this build has checked the proofs") {
  const bool checked = !proofs::coq_version().empty();
  for (const char* settled : {"rank", "two-zeros", "eigenvectors", "det-A", "B-invertible"}) {
    const Judged judged = judge({find(settled)}, 10).front();
    REQUIRE(judged.judgement);
    CHECK((judged.judgement->evidence.front().kind == EvidenceKind::machine_checked) == checked);
    CHECK((as_detail(judged, false).find("machine-checked") != std::string::npos) == checked);
  }
  CHECK((proofs_checked() == "not in this build") == !checked);
  // one name that Coq does not know makes the whole a theorem on paper
  CHECK(
      Evidence::by_checked_theorem("Two zeros", {"eigenvalues.rank_BinvA", "eigenvalues.no_such"}, "").kind ==
      EvidenceKind::theorem);
}

TEST_CASE("the true statement is confirmed by the check that refutes the printed one") {
  const auto corrected = corrected_claims();
  for (const Claim& claim : all_claims()) {
    if (verdict_on(claim, claim.printed) == Verdict::refuted)
      CHECK_MESSAGE(corrected.contains(claim.id), claim.id);
  }
  for (const auto& [id, printed] : corrected) {
    const Claim claim = find(id);
    CHECK_MESSAGE(verdict_on(claim, printed) == Verdict::confirmed, id);
    CHECK_MESSAGE(verdict_on(claim, claim.printed) != Verdict::confirmed, id);
  }
}

TEST_CASE("a claim names the line at which its check begins, in a file that has its id") {
  for (const Claim& claim : all_claims()) {
    INFO(claim.id, " ", claim.source.file, ":", claim.source.line);
    std::ifstream file(PLUMBLINE_SOURCE_DIR "/" + claim.source.file);
    REQUIRE(file);
    bool begins = false, listed = !claim.stated.kind.empty();  // a stated check has no entry of its own
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      if (++number == claim.source.line)
        begins = line.starts_with("Judgement ") && line.find("const Printed& printed") != std::string::npos;
      listed = listed || line.find("{\"" + claim.id + "\",") != std::string::npos;
    }
    CHECK(begins);
    CHECK(listed);
  }
}

TEST_CASE("what cannot be judged is an error, not a verdict") {
  CHECK_THROWS_AS(verdict_on(find("eq-2"), {"2*k/M"}), Error);
  CHECK_THROWS_AS(verdict_on(find("eq-2"), {}), Error);
  CHECK_THROWS_AS(verdict_on(find("four-link-roots"), {"-1.0822", "-0.4337", "a", "0", "0"}), Error);
  CHECK_THROWS_AS(verdict_on(find("four-link-roots"), {"-1.0822", "-0.4337", "-0.2841"}), Error);
  CHECK_THROWS_AS(verdict_on(find("two-link-bifurcation"), {"sideways"}), Error);
  CHECK_THROWS_AS(with_id(all_claims(), "eq-99"), Error);
  CHECK_THROWS_AS(in_section(all_claims(), "7"), Error);
}

TEST_CASE("an id that is written otherwise is asked back") {
  CHECK_THROWS_WITH_AS(with_id(all_claims(), "eq 20"), "--claim: found eq 20, expected eq-20", Error);
}

TEST_CASE("sections select their claims") {
  CHECK(in_section(all_claims(), "").size() == all_claims().size());
  const auto count = [](const std::string& section) { return in_section(all_claims(), section).size(); };
  CHECK(count("4") > count("4.1") + count("4.2"));
  for (const Claim& claim : in_section(all_claims(), "4")) CHECK(section_of(claim).substr(0, 1) == "4");
  for (const Claim& claim : in_section(all_claims(), "4.1")) CHECK(section_of(claim) == "4.1");
}
