#include "verify/report/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>

#include "support/files/toml_file.hpp"
#include "verify/claims/claims.hpp"
#include "verify/paper/errata_file.hpp"
#include "verify/report/markup.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

const std::vector<Judged>& judged_paper() {
  static const std::vector<Judged> all = judge(all_claims(), 20);
  return all;
}

const Errata& errata_of_paper() {
  static const Errata list = errata(checked_paper(), judged_paper());
  return list;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The erratum of an id, altered, as the only one of the paper.
template <class Alter>
Errata altered(const std::string& id, const Alter& alter) {
  Paper paper = checked_paper();
  std::erase_if(paper.errata, [&](const Erratum& one) { return one.id != id; });
  REQUIRE(paper.errata.size() == 1);
  alter(paper.errata.front());
  return errata(paper, judged_paper());
}

Erratum read(const std::string& text) {
  return read_erratum(files::parse_toml(text, "planted"), paper(), "planted");
}

}  // namespace

TEST_CASE("everything that the errata say is held by a check") {
  for (const std::string& problem : errata_of_paper().problems()) FAIL_CHECK(problem);
  for (const JudgedErratum& one : errata_of_paper().items) {
    INFO(one.erratum.id);
    CHECK_FALSE(one.erratum.corrections.empty());
    CHECK_FALSE(one.erratum.reason.empty());
  }
}

TEST_CASE("a false correction, reason, number or effect is found, and is not printed") {
  const auto only_problem = [](const Errata& list) {
    REQUIRE(list.items.size() == 1);
    return list.problems().size() == 1;
  };
  CHECK(altered("table-3-forces", [](Erratum&) {}).problems().empty());
  const Errata correction = altered("table-3-forces", [](Erratum& one) {
    one.corrections.front().print.at(3) = "3.5204";
    one.reason.clear();
  });
  CHECK(only_problem(correction));
  CHECK(correction.items.front().erratum.corrections.empty());
  // a correction of what is right
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) {
    one.corrections.front() = {"table-3-factors", paper().claim("table-3-factors").printed, "", ""};
    one.reason.clear();
  })));
  // a reason that rests on what is refuted
  CHECK(
      only_problem(altered("table-3-forces", [](Erratum& one) { one.reason.front().held_by = {"eq-36"}; })));
  const Errata digits = altered("zigzag", [](Erratum& one) {
    const std::size_t at = one.reason.at(1).text.find("0.040735");
    REQUIRE(at != std::string::npos);
    one.reason.at(1).text.replace(at, 8, "0.040736");
  });
  CHECK(only_problem(digits));
  CHECK(std::none_of(digits.items.front().erratum.reason.begin(), digits.items.front().erratum.reason.end(),
                     [](const Sentence& one) { return one.text.find("0.040736") != std::string::npos; }));
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) { one.stands = {{"eq-17", "(17)"}}; })));
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) { one.changes = {{"eq-16", "(16)"}}; })));
}

TEST_CASE("what is to be read is made of the print, and stands in the paper's words") {
  const std::string claim = "[[correction]]\nclaim = \"fig-9-name\"\nfor = \"Z⁺-configuration\"\n";
  const std::string erratum = "id = \"x\"\ntitle = \"x\"\n";
  const std::string words = "words = { \"Z⁺\" = \"Z⁺\", \"Z⁻, then U⁺\" = \"Z⁻-, then U⁺\" }\n";
  const auto right = read(erratum + claim + "print = [\"Z⁻, then U⁺\"]\n" + words);
  CHECK(right.corrections.front().read == "Z⁻-, then U⁺-configuration");
  // what is replaced is not in the quote
  CHECK_THROWS_AS(read(erratum + "[[correction]]\nclaim = \"fig-9-name\"\nfor = \"V⁺-configuration\"\n" +
                       "print = [\"U⁺\"]\n" + words),
                  Error);
  // words for the printed entry that the paper does not have
  CHECK_THROWS_AS(read(erratum + claim + "print = [\"U⁺\"]\nwords = { \"Z⁺\" = \"W\" }\n"), Error);
  // a text of its own without the entry that changes
  CHECK_THROWS_AS(read(erratum + claim + "print = [\"U⁺\"]\nread = \"another configuration\"\n"), Error);
  // a sentence that names nothing that holds it
  CHECK_THROWS_AS(read(erratum + "reason = [[\"It is so.\"]]\n"), Error);
}

TEST_CASE("an erratum is as grave as what it changes, a changed result the gravest") {
  const auto severity_of = [](const Errata& list) { return list.items.front().severity; };
  CHECK(severity_of(altered("sign-of-force", [](Erratum&) {})) == Severity::formula);
  CHECK(severity_of(altered("zigzag", [](Erratum&) {})) == Severity::statement);
  CHECK(severity_of(altered("fig-16-excluded", [](Erratum&) {})) == Severity::wording);
  CHECK(severity_of(altered("sign-of-force", [](Erratum& one) {
          one.changes = {{"eq-36", "(36)"}};
        })) == Severity::result);
  const auto& items = errata_of_paper().items;
  CHECK(std::is_sorted(items.begin(), items.end(), [](const JudgedErratum& a, const JudgedErratum& b) {
    return std::pair(a.erratum.remark, a.severity) < std::pair(b.erratum.remark, b.severity);
  }));
}

TEST_CASE("every refuted claim is in an erratum, and each claim in one at most") {
  std::set<std::string> ids;
  for (const JudgedErratum& one : errata_of_paper().items)
    for (const Judged& judged : one.claims)
      CHECK_MESSAGE(ids.insert(judged.claim.id).second, judged.claim.id);
  for (const Judged& one : errata_of_paper().open) {
    CHECK_MESSAGE(one.judgement->verdict != Verdict::refuted, one.claim.id);
    CHECK_MESSAGE(ids.insert(one.claim.id).second, one.claim.id);
  }
}

TEST_CASE("the document is short, has every erratum once, and LaTeX in ASCII") {
  const std::string markdown = errata_as_markdown(checked_paper(), judged_paper()),
                    latex = errata_as_latex(checked_paper(), judged_paper());
  const auto& items = errata_of_paper().items;
  const auto remarks = static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(), [](const JudgedErratum& e) { return e.erratum.remark; }));
  CHECK(count(markdown, "\n**E") == items.size() - remarks);
  CHECK(count(markdown, "\n**R") == remarks);
  CHECK(count(latex, "\\paragraph{") == items.size());
  CHECK(count(latex, "{") == count(latex, "}"));
  CHECK(count(latex, "$") % 2 == 0);
  CHECK(count(latex, "$$") == 0);
  CHECK(std::all_of(latex.begin(), latex.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
  // two to three pages
  const std::size_t words = count(markdown, " ") + 1;
  CHECK(words > 800);
  CHECK(words < 2000);
  // proper notation: no marks of the source, no escaped index, no hyphen for a minus
  for (const char* const raw : {"`", "\\_", "*q", "phi", "1 saddles"})
    CHECK_MESSAGE(count(markdown, raw) == 0, raw);
  CHECK(errata_as_markdown(checked_paper(), judged_paper()) == markdown);
}

TEST_CASE("formulas between backticks in LaTeX, in Markdown, and without marks") {
  const std::string text = "the force `F_x⁰ = 1/max|λ_i|` of `B⁻¹A`, 50 %";
  CHECK(as_latex(text) == "the force $F_{x}^{0} = 1/\\max |\\lambda _{i}|$ of $B^{-1}A$, 50 \\%");
  CHECK(as_markdown(text) == "the force F<sub>x</sub>⁰ = 1/max|λ<sub>i</sub>| of B⁻¹A, 50 %");
  CHECK(as_plain(text) == "the force F_x⁰ = 1/max|λ_i| of B⁻¹A, 50 %");
  CHECK(as_latex("`k_nq_n`, `v_{ij}`, `2kq`, `rank(A)`") ==
        "$k_{n}q_{n}$, $v_{ij}$, $2kq$, $\\operatorname{rank}(A)$");
  CHECK(as_latex("“x” & 50 %") == "``x'' \\& 50 \\%");
}
