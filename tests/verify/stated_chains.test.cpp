/// \file
/// Chains and rods as chain files state them: each check takes one, or refuses it in one line.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "verify/claims/claims.hpp"
#include "verify/judging/judge.hpp"

using namespace plumbline::verify;

namespace {

const Paper& published() {
  static const Paper paper =
      with_checks(read_paper_folder(PLUMBLINE_SOURCE_DIR "/verify/papers/published-loads"));
  return paper;
}

std::string outcome(const Judged& one) {
  return one.judgement ? std::string(name(one.judgement->verdict)) : "unjudged: " + one.problem;
}

/// A claim on one chain, which the text of a chain file or lists state.
std::string outcome_of(const std::string& chain, const std::string& printed, const std::string& check) {
  const Paper paper = with_checks(read_paper([&](const std::string& file) -> std::optional<std::string> {
    if (file == "paper.toml")
      return "title = \"T\"\nauthors = \"A\"\njournal = \"J\"\nread = \"r\"\nsections = [\"1\"]\n";
    if (file == "premises.toml") return "[[premise]]\nid = \"c\"\nquote = \"q\"\n" + chain;
    if (file == "section-1.toml")
      return fmt::format(
          "section = \"1\"\ntitle = \"T\"\n[[claim]]\nid = \"x\"\nwhere = \"w\"\nquote = \"q\"\nreading = "
          "\"r\"\nprinted = [\"{}\"]\ngiven = [\"c\"]\ncheck = {{ chain = \"c\", {} }}\n",
          printed, check);
    return std::nullopt;
  }));
  return outcome(judge(paper.claims, 10).front());
}

/// A print, and a check that each can be asked of two or three links.
struct Asked {
  const char *printed, *check;
};
constexpr Asked asked[] = {
    {"F", "is = \"formula\", of = [\"Fx\"]"},
    {"2.00", "is = \"value\", of = [\"x0\"]"},
    {"positive", "is = \"sign\", of = \"2+t\", symbols = [\"t\"], range = [\"t\", \"0\", \"1\"]"},
    {"2.00", "is = \"modes\", of = [\"F 1\"]"},
    {"k/l", "is = \"closed form\", links = [\"2\", \"3\"]"},
    {"supercritical", "is = \"post-buckling\", mode = \"1\""},
    {"1 stable, 1 unstable", "is = \"equilibria\", deflection = \"0.1\""},
    {"continuous", "is = \"path\", to = \"0.1\", asks = \"continuity\""},
    {"0.1", "is = \"event\", to = \"0.1\", event = \"fold\", of = [\"force\"]"},
};

}  // namespace

TEST_CASE("published loads of rods and chains: followers, weights, flutter, free ends") {
  const auto all = judge(published().claims, 10);
  CHECK(all.size() == 13);
  for (const Judged& one : all)
    CHECK_MESSAGE(outcome(one) == "confirmed", one.claim.id << " " << outcome(one));
}

TEST_CASE("a published load with its last digit but one altered is refuted") {
  for (const char* const id : {"greenhill", "beck-force", "two-bars", "ziegler-force"}) {
    Claim claim = with_id(published().claims, id).front();
    char& digit = claim.printed.front().at(claim.printed.front().size() - 2);
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
    CHECK_MESSAGE(outcome(judge({claim}, 10).front()) == "refuted", id);
  }
}

TEST_CASE("a check that is made for guided chains refuses another one in one line, and does not judge it") {
  const std::string free =
      "chain = \"\"\"\nlengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\n\"\"\"\n";
  for (const Asked& one : asked) {
    const std::string found = outcome_of(free, one.printed, one.check);
    INFO(one.check, ": ", found);
    const bool equilibria = std::string(one.check).find("equilibria") != std::string::npos;
    CHECK(found.starts_with(equilibria ? "unjudged: " : "unjudged: premise c: found a chain file with ends"));
    CHECK(found.find('\n') == std::string::npos);
  }
}

TEST_CASE("a chain file that says nothing of ends and loads is the chain of its lists") {
  const std::string file = "chain = \"\"\"\nlengths = [1, 1]\nstiffness = [0, 1]\n\"\"\"\n",
                    lists = "length = [\"1\", \"1\"]\nstiffness = [\"0\", \"1\"]\nrest = [\"0\", \"0\"]\n";
  for (const Asked& one : asked) {
    INFO(one.check);
    CHECK(outcome_of(file, one.printed, one.check) == outcome_of(lists, one.printed, one.check));
  }
  CHECK(outcome_of(file, "2.000", "is = \"modes\", of = [\"F 1\"]") == "confirmed");
}

TEST_CASE("what is lost to a follower may come back: beyond it nothing is said") {
  const std::string pendulum =
      "chain = \"\"\"\nlengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\nmasses = [2, 1]\n"
      "loads = [{ follower = 1 }]\n\"\"\"\n";
  CHECK(outcome_of(pendulum, "stable", "is = \"stability\", force = \"2\"") == "confirmed");
  CHECK(outcome_of(pendulum, "stable", "is = \"stability\", force = \"3\"").starts_with("unjudged"));
  CHECK(outcome_of(pendulum, "stable", "is = \"stability\", force = \"-1\"").starts_with("unjudged"));
}
