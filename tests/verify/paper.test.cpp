#include "verify/paper/paper.hpp"

#include <doctest/doctest.h>

#include <map>
#include <plumbline/base/error.hpp>

#include "verify/claims/claims.hpp"
#include "verify/generic/generic.hpp"
#include "verify/judging/judge.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

using Files = std::map<std::string, std::string>;

/// A paper of one claim.
Files small_paper() {
  return {
      {"paper.toml", "title = \"T\"\nauthors = \"A\"\njournal = \"J\"\nread = \"all\"\nsections = [\"1\"]\n"},
      {"premises.toml",
       "[[premise]]\nid = \"two\"\nquote = \"two links\"\nlength = [\"1\", \"1\"]\nstiffness = "
       "[\"0\", \"1\"]\n"},
      {"section-1.toml",
       "section = \"1\"\ntitle = \"S\"\n[[claim]]\nid = \"c\"\nwhere = \"(1)\"\nquote = \"F = 2\"\n"
       "reading = \"F is 2\"\nprinted = [\"2.0\"]\ngiven = [\"two\"]\n"
       "check = { is = \"modes\", chain = \"two\", of = [\"F 1\"] }\n"}};
}

Paper read(const Files& files) {
  return with_checks(read_paper([&](const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  }));
}

Files with(const std::string& file, const std::string& from, const std::string& to) {
  Files files = small_paper();
  const std::size_t at = files[file].find(from);
  REQUIRE(at != std::string::npos);
  files[file].replace(at, from.size(), to);
  return files;
}

Verdict verdict(const Files& files) {
  const auto judged = judge(read(files).claims, 10);
  REQUIRE(judged.size() == 1);
  REQUIRE_MESSAGE(judged[0].judgement, judged[0].problem);
  return judged[0].judgement->verdict;
}

}  // namespace

TEST_CASE("a folder is a paper: its premises and its check decide") {
  CHECK(verdict(small_paper()) == Verdict::confirmed);
  CHECK(verdict(with("section-1.toml", "2.0", "2.1")) == Verdict::refuted);
  // another premise, another truth
  CHECK(verdict(with("premises.toml", "\"0\", \"1\"]", "\"0\", \"2\"]")) == Verdict::refuted);
}

TEST_CASE("what is wrong in a folder is an error that names the file") {
  const auto names = [](const Files& files, const std::string& part) {
    try {
      read(files);
    } catch (const Error& error) {
      CHECK_MESSAGE(std::string(error.what()).find(part) != std::string::npos, error.what());
      return;
    }
    FAIL_CHECK("no error with " << part);
  };
  names({}, "paper.toml");
  names(with("paper.toml", "\"1\"", "\"2\""), "section-2.toml");
  names(with("paper.toml", "title", "titel"), "titel");
  names(with("section-1.toml", "\"two\"", "\"three\""), "three");
  names(with("section-1.toml", "is = \"modes\"", "is = \"moods\""), "moods");
  names(with("section-1.toml", "reading", "raeding"), "raeding");
  names(with("section-1.toml", "check = { is = \"modes\", chain = \"two\", of = [\"F 1\"] }\n", ""),
        "no check");
  names(with("premises.toml", "length", "lenght"), "lenght");
}

TEST_CASE("what a stated check cannot judge is a problem, not a verdict") {
  const auto problem = [](const Files& files) { return judge(read(files).claims, 10).front().problem; };
  CHECK(problem(with("section-1.toml", "F 1", "F 2")).find("F 2") != std::string::npos);
  CHECK(problem(with("section-1.toml", "chain = \"two\"", "chain = \"one\"")).find("one") !=
        std::string::npos);
  CHECK(problem(with("section-1.toml", "of =", "off =")).find("off") != std::string::npos);
}

TEST_CASE("premises: prints of claims, numbers of all forms") {
  const Premises given = paper().given({"u-chain", "fig-3-angle", "fig-11-deflection"});
  CHECK(given.chain("u-chain").rest()[0].contains(Rational(-3179, 10000)));
  CHECK(given.reach("u-chain").contains(Rational(19, 5)));
  CHECK(given.exact("fig-11-deflection") == Rational(2, 5));
  CHECK_THROWS_AS(static_cast<void>(given.exact("fig-3-angle")), Error);
  CHECK_THROWS_AS(static_cast<void>(given.value("u-chain")), Error);
  CHECK_THROWS_AS(static_cast<void>(given.at("z-chain")), Error);
}

TEST_CASE("a published abstract on a chain with a follower load and masses is judged as it is worded") {
  const Paper abstract = with_checks(read_paper_folder(PLUMBLINE_SOURCE_DIR "/verify/papers/kirillov-2011"));
  const std::map<std::string, std::string> expected{
      {"minimum-equal", "confirmed"},
      {"minimum-double", "confirmed"},
      {"flutter", "confirmed"},
      {"maximum-joint", "confirmed"},
      // P = 2 c + (sqrt(m1) - sqrt(m2))^2 / (2 m2) for equal stiffnesses c: without bound as m2 goes to zero
      {"maximum-end", "imprecise"}};
  for (const Judged& one : judge(abstract.claims, 10)) {
    INFO(one.claim.id, " ", one.problem);
    REQUIRE(one.judgement);
    CHECK(name(one.judgement->verdict) == expected.at(one.claim.id));
  }
}

TEST_CASE("a chain file as premise has the ends that it states") {
  // the free double pendulum under a dead load: P = (3 - sqrt 5)/2 c/l (Ziegler, Principles of Structural
  // Stability)
  const auto factor = [](const std::string& end, const std::string& printed) {
    Claim claim;
    claim.id = "x";
    claim.printed = {printed};
    claim.given = Premises({{"c", "", "q", {{"chain", {"lengths = [1, 1]\nstiffness = [1, 1]\n" + end}}}}});
    claim.check = generic_check({"critical", {{"chain", {"c"}}}, "here"});
    return judge({claim}, 10).front();
  };
  const auto verdict = [](const Judged& one) {
    return one.judgement ? std::string(name(one.judgement->verdict)) : one.problem;
  };
  CHECK(verdict(factor("end_point = \"free\"\n", "0.381966")) == "confirmed");
  CHECK(verdict(factor("end_point = \"free\"\n", "2.5")) == "refuted");
  CHECK(verdict(factor("", "2.5")) == "confirmed");  // guided, without the key
  CHECK(verdict(factor("end_point = \"floating\"\n", "2.5")).find("end_point") != std::string::npos);
}
