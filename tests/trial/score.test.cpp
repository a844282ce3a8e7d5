#include "trial/score.hpp"

#include <doctest/doctest.h>

#include <sstream>

#include "trial/report.hpp"

#include "tests/close_to.hpp"

using namespace plumbline::trial;

namespace {

Case one(const std::string& name, std::vector<TrueEffect> effects, double strength, Answer answer,
         const std::string& said) {
  Case made;
  made.label = {name, std::move(effects), {}, strength, "declared", 1, ""};
  made.judgement.answer = answer;
  made.judgement.said = said;
  made.judgement.best = said.substr(said.find(' ') + 1);
  return made;
}

const std::vector<TrueEffect> only_gravity{{"gravity", 0, {}, 0}}, only_stop{{"joint_stop", 1, {}, 0}},
    only_outside{{"unknown", 0, {}, 0}};

std::vector<Case> a_trial() {
  std::vector<Case> cases{one("a", {}, 0, Answer::right, "none"),
                          one("b", {}, 0, Answer::false_alarm, "identified gravity"),
                          one("c", only_gravity, 4, Answer::right, "identified gravity"),
                          one("d", only_gravity, 30, Answer::right, "identified gravity"),
                          one("e", only_stop, 7, Answer::wrong_sure, "identified gravity"),
                          one("f", only_stop, 2, Answer::missed_gap, "none"),
                          one("g", only_outside, 12, Answer::right, "unknown"),
                          one("h", {only_gravity[0], only_stop[0]}, 12, Answer::part, "identified gravity"),
                          one("i", only_stop, 50, Answer::no_report, "killed by signal 11")};
  cases[2].judgement.covered = {{"rho", true}};
  cases[3].judgement.covered = {{"rho", false}};
  cases[2].judgement.stated = {0.95, true};
  cases[4].judgement.stated = {0.92, false};
  return cases;
}

bool is(const Proportion& p, std::size_t count, std::size_t total) {
  return p.count == count && p.total == total;
}

}  // namespace

TEST_CASE("counts of each outcome") {
  const Score s = score(a_trial());
  CHECK(is(s.all.found, 4, 9));
  CHECK(is(s.strong, 1, 3));
  CHECK(is(s.weak, 1, 1));
  CHECK(is(s.false_alarm, 1, 2));
  CHECK(is(s.wrong_sure, 2, 5));
  CHECK(is(s.outside, 1, 1));
  CHECK(is(s.pairs, 0, 1));
  CHECK(is(s.covered, 1, 2));
  CHECK(s.no_report == 1);
  CHECK(s.broken_seals == 0);
  REQUIRE(s.by_strength.size() == 4);
  CHECK(s.by_strength[0].name == "under 2.5 sigma");
  CHECK(is(s.by_strength[0].found, 0, 1));
  CHECK(s.by_truth.front().name == "none");
  CHECK(s.by_truth.back().name == "outside the catalogue");
}

TEST_CASE("the confusion table counts the best explanation, and marks a wrong joint") {
  std::vector<Case> cases = a_trial();
  cases.push_back(one("j", only_stop, 9, Answer::wrong_sure, "identified joint_stop"));
  const Score s = score(cases);
  CHECK(s.confusion.at("joint_stop").at("gravity") == 1);
  CHECK(s.confusion.at("joint_stop").at("joint_stop at another joint") == 1);
  CHECK(s.confusion.at("joint_stop").at("no report") == 1);
  CHECK(s.confusion.at("gravity").at("gravity") == 2);
}

TEST_CASE("stated probabilities are binned with the observed frequencies") {
  const Score s = score(a_trial());
  for (const Reliability& bin : s.reliability) {
    if (bin.low == 0.9) {
      CHECK(is(bin.right, 1, 2));
      CHECK(bin.stated == close_to(0.935));
    } else {
      CHECK(bin.right.total == 0);
    }
  }
}

TEST_CASE("a probability on the edge of two bins counts once, in the upper one") {
  std::vector<Case> cases = a_trial();
  for (Case& each : cases) each.judgement.stated.reset();
  cases[2].judgement.stated = {0.9, true};
  std::size_t total = 0;
  for (const Reliability& bin : score(cases).reliability) {
    total += bin.right.total;
    CHECK(bin.right.total == (bin.low == 0.9 ? 1 : 0));
  }
  CHECK(total == 1);
}

TEST_CASE("median, 90 % quantile and worst of eleven known values") {
  std::vector<Case> cases;
  for (int i = 10; i >= 0; --i) {
    cases.push_back(one("a", {}, 0, Answer::right, "none"));
    cases.back().seconds = i;
  }
  const Spread seconds = score(cases).seconds;  // 0, 1, ..., 10
  CHECK(seconds.median == 5);
  CHECK(seconds.ninth_decile == 9);
  CHECK(seconds.worst == 10);
}

TEST_CASE("the Brier score is the mean over the cases that state a probability") {
  std::vector<Case> cases = a_trial();
  for (Case& each : cases) each.judgement.stated.reset();
  cases[2].judgement.stated = {0.8, true};
  cases[2].judgement.brier = 0.08;
  cases[4].judgement.stated = {0.6, false};
  cases[4].judgement.brier = 0.52;
  CHECK(score(cases).brier == close_to((0.08 + 0.52) / 2));
}

TEST_CASE("failures come first, the worst first; a broken seal is one") {
  std::vector<Case> cases = a_trial();
  cases[0].seal_holds = false;
  Circumstances about;
  about.sealed = cases.size();
  const std::string text = as_text(about, cases, Style::terminal);
  const auto at = [&](const char* word) { return text.find(word); };
  CHECK(at("1 DO NOT HOLD") != std::string::npos);
  CHECK(at("killed by signal 11") < at("wrong, sure  e"));
  CHECK(at("broken seal") < at("Against the aims"));
  CHECK(at("Failures") < at("Against the aims"));
  const auto json = as_json(about, cases);
  CHECK(json["seals"]["broken"] == 1);
  CHECK(json["experiments"].size() == 9);
  CHECK(json["strong"]["total"] == 3);
}

TEST_CASE("families: most confident errors first; causes outside the catalogue by description") {
  std::vector<Case> cases = a_trial();
  for (Case& each : cases) each.label.family = each.label.effects.empty() ? "no effect" : "one effect";
  cases[6].label.description = "a magnet";
  const Score s = score(cases);
  REQUIRE(s.by_family.size() == 3);
  CHECK(s.by_family[0].name == "no effect");  // a false alarm that is sure of itself, of two
  CHECK(is(s.by_family[0].wrong_sure, 1, 2));
  CHECK(s.by_family[1].name == "one effect");
  CHECK(is(s.by_family[1].wrong_sure, 1, 6));
  CHECK(s.by_family[2].name == "outside: a magnet");
  CHECK(is(s.by_family[2].found, 1, 1));
  const std::string text = as_text({}, cases, Style::terminal);
  CHECK(text.find("By family") < text.find("Failures"));
  CHECK(score(a_trial()).by_family.empty());
}
