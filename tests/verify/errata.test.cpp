#include "verify/report/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <plumbline/base/error.hpp>
#include <set>

#include "support/files/text_file.hpp"
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

/// The errata of the paper's own folder with one text of errata.toml replaced, as a document; what refuses it
/// where the folder cannot be read.
std::string document_with(const std::string& text, const std::string& planted) {
  try {
    const Paper altered = with_checks(read_paper([&](const std::string& name) -> std::optional<std::string> {
      const std::filesystem::path path =
          std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "verify/papers/zhao-2022" / name;
      if (!std::filesystem::exists(path)) return std::nullopt;
      std::string content = files::read_text(path);
      if (name != "errata.toml") return content;
      const std::size_t at = content.find(text);
      REQUIRE_MESSAGE(at != std::string::npos, text);
      return content.replace(at, text.size(), planted);
    }));
    return errata_as_markdown(altered, judged_paper());
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("everything that the errata say is held by a check") {
  for (const std::string& problem : errata_of_paper().problems()) FAIL_CHECK(problem);
  for (const JudgedErratum& one : errata_of_paper().items) {
    INFO(one.id);
    CHECK((one.remark || !one.corrections.empty()));
    CHECK_FALSE(one.reason.empty());
  }
}

TEST_CASE("a falsehood planted in errata.toml is not printed") {
  // the text that it takes the place of, what is planted, and what of it must not be read
  struct Plant {
    std::string text, planted, never;
  };
  const std::string erratum = "id = \"table-3-forces\"\n";
  const std::vector<Plant> plants{
      // words that nothing computes
      {erratum, erratum + "title = \"Table 3 is invented.\"\n", "invented"},
      {erratum, erratum + "text = \"The angles are in degrees.\"\n", "degrees"},
      {"reason = [\"pseudoinverse\"]", "reason = [\"every later figure is worthless\"]", "is worthless."},
      {"reason = [\"pseudoinverse\"]", "reason = [[\"Worthless.\", \"pseudoinverse\"]]", "Worthless"},
      {"stands = [\"eq-8\"]", "stands = [\"nothing else in the paper\"]", "Unchanged:* nothing"},
      {"stands = [\"eq-8\"]", "stands = [[\"nothing\", \"eq-8\"]]", "Unchanged:* nothing"},
      {"print = [\"passes continuously\"]", "print = [\"halves\"]", "halves"},
      {"print = [\"have exact solutions\"]", "print = [\"have no solutions at all\"]", "at all"},
      {"within = \"suddenly jumps from Z⁻ to U⁺\"", "within = \"suddenly collapses from Z⁻ to U⁺\"",
       "collapses"},
      {"for = \"suddenly jumps\"\n", "for = \"suddenly jumps\"\nread = \"breaks\"\n", "breaks"},
      // prints that are not so
      {"print = [\"0.9240\", \"3.5203\"", "print = [\"0.9240\", \"3.5204\"", "3.5204"},
      {"print = [\"inv(J*J^T)*J\"]", "print = [\"inv(J*J^T)*J^T\"]", "(JJᵀ)⁻¹Jᵀ"},
      {"print = [\"n\"]\nfor = \"n−1\"", "print = [\"n-2\"]\nfor = \"n−1\"", "n − 2"},
      {"print = [\"2 minima, 1 saddle\"]", "print = [\"2 minima, 2 saddles\"]", "2 saddles"},
      {"print = [\"continuously\", \"reduce\"]", "print = [\"continuously\", \"keep\"]", "can continuously"},
      {"print = [\"feasible shapes (U⁺, U⁻)\"", "print = [\"feasible shape U⁻\"", "feasible shape U⁻"},
      {"print = [\"q3\", \"q4\"]", "print = [\"q1\", \"q4\"]", "q₁, q₄"},
      {"print = [\"35\"]", "print = [\"36\"]", "(36)”"},
      // facts that are not so, and claims that do not stand
      {"printed = [\"0.040735\", \"1.01225\"", "printed = [\"0.040735\", \"1.02225\"", "1.02225"},
      {"printed = [\"half turn\"]", "printed = [\"mirror\"]", "symmetry: mirror"},
      {"printed = [\"smooth\"]", "printed = [\"not smooth\"]", "a path that is not smooth"},
      {"stands = [\"eq-19\", \"eq-20\"", "stands = [\"eq-17\", \"eq-20\"", "Unchanged:* (17)"},
      {"reason = [\"rank\", \"eigenvectors\"]", "reason = [\"two-zeros\", \"eigenvectors\"]", "Exactly two"},
      // two corrections of one sentence
      {"[[erratum.correction]]\nclaim = \"fig-9-local\"",
       "[[erratum.correction]]\nclaim = \"fig-8-jump\"\nprint = [\"passes continuously\"]\n"
       "for = \"suddenly jumps\"\n[[erratum.correction]]\nclaim = \"fig-9-local\"",
       "“passes continuously”."},
  };
  for (const Plant& one : plants) {
    INFO(one.planted);
    const std::string document = document_with(one.text, one.planted);
    // a refusal quotes what it refuses
    if (document.starts_with("# Errata")) CHECK(document.find(one.never) == std::string::npos);
  }
  CHECK(document_with(erratum, erratum).starts_with("# Errata"));
}

TEST_CASE("a false correction, reason or effect is found, and is not printed") {
  const auto only_problem = [](const Errata& list) {
    REQUIRE(list.items.size() == 1);
    return list.problems().size() == 1;
  };
  CHECK(altered("table-3-forces", [](Erratum&) {}).problems().empty());
  const Errata correction =
      altered("table-3-forces", [](Erratum& one) { one.corrections.front().print.at(1) = "3.5204"; });
  CHECK(only_problem(correction));
  CHECK(correction.items.front().corrections.empty());
  // a correction of what is right
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) {
    one.corrections.front() = {"table-3-factors", paper().claim("table-3-factors").printed, "", ""};
  })));
  // a reason that says nothing, for it is confirmed and no fact
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) { one.reason = {"eq-16"}; })));
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) { one.stands = {"eq-17"}; })));
  CHECK(only_problem(altered("table-3-forces", [](Erratum& one) { one.changes = {"eq-16"}; })));
}

TEST_CASE("what is to be read is the paper's words with the entries of the print in them") {
  const std::string claim = "[[correction]]\nclaim = \"fig-8-jump\"\nprint = [\"passes continuously\"]\n";
  const std::string erratum = "id = \"x\"\n", words = "for = \"suddenly jumps\"\n";
  const auto right = read(erratum + claim + words + "within = \"suddenly jumps from Z⁻\"\n");
  CHECK(right.corrections.front().read == "passes continuously from Z⁻");
  // what is replaced is not in the quote; nothing is to be replaced; too little is
  CHECK_THROWS_AS(read(erratum + claim + "for = \"suddenly falls\"\n"), Error);
  CHECK_THROWS_AS(read(erratum + claim + words + "within = \"jumps from Z⁻\"\n"), Error);
  CHECK_THROWS_AS(read(erratum + claim), Error);
  // a whole print in its form, and in one that it does not fill
  const std::string matrix =
      "[[correction]]\nclaim = \"eq-24\"\nprint = [\"k1*q1\", \"k2*q2\", \"k3*q3\", \"k4*q4\"]\n"
      "for = \"`−[k₁q₁, k₂q₂, …, k_nq_n]ᵀ`\"\n";
  CHECK(read(erratum + matrix + "as = \"column\"\n").corrections.front().read ==
        "`[k₁q₁, k₂q₂, …, k_nq_n]ᵀ`");
  CHECK_THROWS_AS(read(erratum + matrix + "as = \"3 rows\"\n"), Error);
  // an id that there is not
  CHECK_THROWS_AS(read(erratum + "reason = [\"It is so.\"]\n"), Error);
}

TEST_CASE("an erratum is as grave as what it changes, a changed result the gravest") {
  const auto severity_of = [](const Errata& list) { return list.items.front().severity; };
  CHECK(severity_of(altered("sign-of-force", [](Erratum&) {})) == Severity::formula);
  CHECK(severity_of(altered("zigzag", [](Erratum&) {})) == Severity::statement);
  CHECK(severity_of(altered("fig-16-excluded", [](Erratum&) {})) == Severity::wording);
  CHECK(severity_of(altered("sign-of-force", [](Erratum& one) { one.changes = {"eq-36"}; })) ==
        Severity::result);
  const auto& items = errata_of_paper().items;
  CHECK(std::is_sorted(items.begin(), items.end(), [](const JudgedErratum& a, const JudgedErratum& b) {
    return std::pair(a.remark, a.severity) < std::pair(b.remark, b.severity);
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
      std::count_if(items.begin(), items.end(), [](const JudgedErratum& e) { return e.remark; }));
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
