/// \file
/// What a generic check cannot decide is unjudged, never refuted: expressions of known sign whose margin goes
/// to nought, identities and paths that are not decided.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <plumbline/base/error.hpp>

#include "verify/claims/claims.hpp"
#include "verify/judging/judge.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

/// A claim with a check of its own on two links in symbols, judged.
Judged judged(const std::string& printed, const std::string& check) {
  const Paper paper = with_checks(read_paper([&](const std::string& name) -> std::optional<std::string> {
    if (name == "paper.toml")
      return "title = \"T\"\nauthors = \"A\"\njournal = \"J\"\nread = \"r\"\nsections = [\"1\"]\n";
    if (name == "premises.toml")
      return "[[premise]]\nid = \"c\"\nquote = \"q\"\nlength = [\"1\", \"1\"]\nstiffness = [\"0\", \"1\"]\n";
    if (name == "section-1.toml")
      return fmt::format(
          "section = \"1\"\ntitle = \"T\"\n[[claim]]\nid = \"x\"\nwhere = \"w\"\nquote = \"q\"\nreading = "
          "\"r\"\n"
          "printed = [\"{}\"]\ngiven = [\"c\"]\ncheck = {{ chain = \"c\", {} }}\n",
          printed, check);
    return std::nullopt;
  }));
  return judge(paper.claims, 10).front();
}

std::string verdict(const Judged& one) {
  return one.judgement ? std::string(name(one.judgement->verdict)) : "unjudged";
}

std::string sign_of(const std::string& of, const std::string& from, const std::string& to) {
  return fmt::format("is = \"sign\", of = \"{}\", symbols = [\"t\"], range = [\"t\", \"{}\", \"{}\"]", of,
                     from, to);
}

}  // namespace

TEST_CASE("an expression near zero is never decided wrongly") {
  // positive on the range, by as little as the second says
  std::vector<std::string> positive;
  std::vector<std::array<std::string, 3>> all;
  for (int k = 1; k <= 12; ++k) all.push_back({fmt::format("(t-1/3)^2+1/10^{}", k), "0", "1"});
  for (const char* const from : {"0.5", "0.1", "0.05", "0.01", "0.001", "0.0001"}) {
    all.push_back({"sin(t)-t*cos(t)", from, "1"});
    all.push_back({"t-sin(t)", from, "1"});
    all.push_back({"1-cos(t)-t^2/2+t^4/24", from, "1"});
  }
  REQUIRE(all.size() == 30);
  std::size_t decided = 0;
  for (const auto& [of, from, to] : all) {
    INFO(of, " from ", from);
    const std::string check = sign_of(of, from, to);
    const std::string right = verdict(judged("positive", check));
    CHECK((right == "confirmed" || right == "unjudged"));
    decided += right == "confirmed" ? 1 : 0;
    for (const char* const wrong : {"negative", "both signs"}) {
      const std::string found = verdict(judged(wrong, check));
      CHECK((found == "refuted" || found == "unjudged"));
      CHECK((found == "unjudged") == (right == "unjudged"));
    }
  }
  CHECK(decided >= 15);  // half of them are no closer to zero than subdivision reaches
}

TEST_CASE("a sign that touches zero is undecided, and says so; one that changes is both") {
  const Judged touching = judged("positive", sign_of("(t-1/3)^2", "0", "1"));
  CHECK(verdict(touching) == "unjudged");
  CHECK(touching.problem.find("a sign that subdivision does not decide") != std::string::npos);
  CHECK(verdict(judged("both signs", sign_of("t-1/3", "0", "1"))) == "confirmed");
  const std::string slope =
      "is = \"sign\", of = \"t^3\", by = \"t\", symbols = [\"t\"], range = [\"t\", \"-1\", \"1\"]";
  CHECK(verdict(judged("not monotonic", slope)) == "unjudged");
}

TEST_CASE("an identity that algebra does not prove and values do not refute is undecided") {
  const auto formula = [](const std::string& of) {
    return "is = \"formula\", symbols = [\"t\"], of = [\"" + of + "\"]";
  };
  CHECK(verdict(judged("t*2", formula("t+t"))) == "confirmed");
  CHECK(verdict(judged("t*3", formula("t+t"))) == "refuted");
  // equal where t is positive, which nothing says
  CHECK(verdict(judged("t", formula("sqrt(t^2)"))) != "refuted");
}

TEST_CASE("a derivative is taken once by each name, and none is dropped") {
  const auto twice = [](const std::string& by) {
    return "is = \"formula\", symbols = [\"t\"], of = [\"t^3\"], by = " + by;
  };
  CHECK(verdict(judged("6*t", twice("[\"t t\"]"))) == "confirmed");
  CHECK(verdict(judged("3*t^2", twice("[\"t\"]"))) == "confirmed");
  CHECK(verdict(judged("3*t^2", twice("[\"t\", \"t\"]"))) == "unjudged");
}

TEST_CASE("no raw text of a library reaches the user") {
  for (const char* const check :
       {"is = \"formula\", of = [\"t+*\"], symbols = [\"t\"]",
        "is = \"equilibria\", deflection = \"0.1\", asks = \"more than\"",
        "is = \"event\", to = \"0.5\", event = \"joint straightens\", joint = \"x\", "
        "between = [\"0.1\", \"0.2\"], of = [\"force\"]"}) {
    const Judged one = judged("many", check);
    INFO(one.problem);
    CHECK(verdict(one) == "unjudged");
    for (const char* const raw : {"boost", "stoi", "stoul", "GiNaC", "parser", "std::"})
      CHECK(one.problem.find(raw) == std::string::npos);
  }
}
