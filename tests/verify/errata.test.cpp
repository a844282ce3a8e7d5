#include "verify/report/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "verify/claims/claims.hpp"
#include "verify/report/latex.hpp"

using namespace plumbline::verify;

namespace {

/// Section 4.2's, which take no time.
const std::vector<Judged>& judged_section() {
  static const std::vector<Judged> all = judge(in_section(all_claims(), "4.2"), 10);
  return all;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("the signs of (24), (36) and step 4 are one erratum, found by trying") {
  const auto list = errata(judged_section());
  const auto sign =
      std::find_if(list.begin(), list.end(), [](const Erratum& e) { return e.cause.id == "sign-of-force"; });
  REQUIRE(sign != list.end());
  std::set<std::string> ids;
  for (const Judged& one : sign->claims) ids.insert(one.claim.id);
  CHECK(ids == std::set<std::string>{"eq-24", "eq-36", "algorithm-1-step-4"});
  for (const Judged& one : sign->unchanged) CHECK(one.judgement->verdict == Verdict::confirmed);
}

TEST_CASE("causes: each has claims that are wrong, and what it says to stand is among the claims") {
  std::set<std::string> ids, named;
  for (const Claim& claim : all_claims()) {
    ids.insert(claim.id);
    named.insert(claim.cause);
  }
  for (const Cause& cause : paper().causes) {
    CHECK_MESSAGE(named.contains(cause.id), cause.id);
    for (const std::string& id : cause.unchanged) CHECK_MESSAGE(ids.contains(id), id);
  }
}

TEST_CASE("the document has every erratum once, the gravest first, and LaTeX in ASCII") {
  const auto list = errata(judged_section());
  CHECK(std::is_sorted(list.begin(), list.end(),
                       [](const Erratum& a, const Erratum& b) { return a.severity < b.severity; }));
  const std::string markdown = errata_as_markdown(judged_section()),
                    latex = errata_as_latex(judged_section());
  CHECK(count(markdown, "\n### ") == list.size());
  CHECK(count(latex, "\\paragraph{") == list.size());
  CHECK(count(latex, "{") == count(latex, "}"));
  CHECK(std::all_of(latex.begin(), latex.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
  CHECK(errata_as_markdown(judged_section()) == markdown);
}

TEST_CASE("LaTeX has indices and exponents, and one formula where two would meet") {
  CHECK(as_latex("F_x⁰ = +1/max|λ_i|") == "F$_{x}^{0}$ = +1/\\allowbreak{}max$|\\lambda_{i}|$");
  CHECK(as_latex("B⁻¹A, k_nq_n, v_ij, v_{n+1}") == "B$^{-1}$A, k$_{n}$q$_{n}$, v$_{ij}$, v$_{n+1}$");
  CHECK(as_latex("50 % & {x}") == "50 \\% \\& \\{x\\}");
}
