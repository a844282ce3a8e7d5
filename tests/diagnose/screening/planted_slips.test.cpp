#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "diagnose/bench/read_experiment.hpp"
#include "tests/diagnose/screening/question.hpp"
#include "tests/diagnose/screening/slips.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

std::vector<Experiment> committed_experiments() {
  std::vector<Experiment> all;
  const std::filesystem::path folder = std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/experiments";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory()) all.push_back(read_experiment(entry.path()));
  return all;
}

/// Whether the question names the slip: "…, Fx, Fy: found what looks like kgf, or joint_stiffness like …"; of
/// axes in readings that cannot be, the positions alone.
bool names(const std::string& question, const std::string& slip) {
  const std::size_t like = slip.find(" like ");
  const std::string what = slip.substr(0, like), as = slip.substr(like + 6);
  std::vector<std::string> words{what + ": found what looks like " + as, "or " + slip,
                                 "; " + what + " look like " + as, "; " + what + " looks like " + as};
  if (as.starts_with("axes ")) words.push_back("; x, y look like an end point " + as.substr(5));
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& one) { return question.find(one) != std::string::npos; });
}

/// Whether it names the slip before anything else.
bool names_first(const std::string& question, const std::string& slip) {
  return names(question.substr(0, question.find(", or ")), slip);
}

/// Whether a list of the chain that the slip names is the same from both ends: then it is no slip.
bool is_no_slip(const Slip& slip, const Experiment& before, const Experiment& after) {
  const std::string what = slip.expected.substr(0, slip.expected.find(" like "));
  const auto left_alone = [&](const char* key, const std::vector<double> Experiment::*list) {
    return what.find(key) != std::string::npos && before.*list == after.*list;
  };
  return left_alone("joint_stiffness", &Experiment::joint_stiffness) ||
         left_alone("link_length", &Experiment::link_length);
}

struct Tally {
  int planted = 0, asked = 0, right = 0, first = 0;
};

Tally plant(const Slip& slip, const std::vector<Experiment>& experiments, double& slowest) {
  Tally tally;
  for (Experiment experiment : experiments) {
    if (slip.of_angles && !experiment.runs.front().reads_angles()) continue;
    const Experiment before = experiment;
    slip.spoil(experiment);
    if (is_no_slip(slip, before, experiment)) continue;
    ++tally.planted;
    const auto begin = std::chrono::steady_clock::now();
    const std::string said = question(experiment);
    slowest =
        std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    tally.asked += !said.empty();
    tally.right += names(said, slip.expected);
    tally.first += names_first(said, slip.expected);
  }
  return tally;
}

Tally plant_all(const std::vector<Slip>& slips) {
  const std::vector<Experiment> experiments = committed_experiments();
  Tally sum;
  double slowest = 0;
  for (const Slip& slip : slips) {
    const Tally tally = plant(slip, experiments, slowest);
    MESSAGE(fmt::format("| {} | {} | {} | {} | {} |", slip.expected, tally.planted, tally.asked, tally.right,
                        tally.first));
    sum.planted += tally.planted, sum.asked += tally.asked, sum.right += tally.right,
        sum.first += tally.first;
  }
  MESSAGE(fmt::format("slowest question: {:.2f} s", slowest));
  return sum;
}

/// The angles that are read are in reverse with the chain, or were counted from the base all the same; who
/// walks from the end point to the base counts angles the other way.
std::vector<Slip> slips_of_whole_chains() {
  using List = std::vector<double>;
  std::vector<Slip> all;
  for (const auto& [sense, kind] : {std::pair{1.0, ""}, {-1.0, "angles of the opposite sign in "}}) {
    const auto reverse = [sense = sense](List& angles) {
      std::reverse(angles.begin(), angles.end());
      scale(angles, sense);
    };
    const Spoil chain = [=](Experiment& e) {
      for (List* list : {&e.link_length, &e.joint_stiffness, &e.link_mass})
        std::reverse(list->begin(), list->end());
      each_rest(reverse)(e);
    };
    const Spoil readings = each_reading([=](Reading& r) { each_angles(r, reverse); });
    const std::string like = " like " + std::string(kind) + "lists from the end point on";
    all.push_back({"link_length, joint_stiffness, rest" + like, chain});
    all.push_back({"link_length, joint_stiffness, rest, q" + like,
                   [=](Experiment& e) { chain(e), readings(e); }, true});
  }
  return all;
}

}  // namespace

TEST_CASE("planted wrong units raise a question, and the right one" * doctest::test_suite("long")) {
  const Tally sum = plant_all(slips_of_units());
  CHECK(sum.asked > 0.85 * sum.planted);
  CHECK(sum.right > 0.95 * sum.asked);
  CHECK(sum.first > 0.9 * sum.right);
}

TEST_CASE("planted wrong axes raise a question, and the right one") {
  const Tally sum = plant_all(slips_of_axes());
  CHECK(sum.asked > 0.9 * sum.planted);
  CHECK(sum.right > 0.9 * sum.asked);
}

TEST_CASE("planted wrong conventions of joints raise a question, and the right one") {
  const Tally sum = plant_all(slips_of_joints());
  CHECK(sum.asked > 0.7 * sum.planted);
  CHECK(sum.right > 0.9 * sum.asked);
}

TEST_CASE("planted reversed chains raise a question, and the right one") {
  const Tally sum = plant_all(slips_of_whole_chains());
  CHECK(sum.planted >= 30);
  CHECK(sum.asked > 0.8 * sum.planted);
  CHECK(sum.right > 0.9 * sum.asked);
  CHECK(sum.first > 0.8 * sum.right);
}

TEST_CASE("planted reversed lists of links raise a question where they differ, and the right one") {
  const Tally sum = plant_all({{"link_length like a list from the end point on", [](Experiment& e) {
                                  std::reverse(e.link_length.begin(), e.link_length.end());
                                }}});
  CHECK(sum.planted >= 18);
  CHECK(sum.asked > 0.3 * sum.planted);
  CHECK(sum.right > 0.9 * sum.asked);
}

TEST_CASE("a joint of opposite sign raises a question where it is bent, and the right one") {
  const auto turned = [](std::vector<double>& q) { q[1] *= -1; };
  const auto turned_reading = each_reading([&](Reading& r) { each_angles(r, turned); });
  const std::vector<Slip> slips{{"rest of joint 2 like an angle of the opposite sign", each_rest(turned)},
                                {"q2 like an angle of the opposite sign", turned_reading, true},
                                {"rest of joint 2, q2 like an angle of the opposite sign",
                                 [&](Experiment& e) { each_rest(turned)(e), turned_reading(e); }, true},
                                {"rest, q like degrees",
                                 [](Experiment& e) {
                                   constexpr double degree = 57.29577951308232;
                                   each_rest([](std::vector<double>& q) { scale(q, degree); })(e);
                                   each_reading([](Reading& r) {
                                     each_angles(r, [](std::vector<double>& q) { scale(q, degree); });
                                   })(e);
                                   e.noise[Channel::Name::q] *= degree;
                                 },
                                 true}};
  std::vector<Experiment> bent = committed_experiments();
  std::erase_if(bent, [](const Experiment& e) {
    return e.link_length.size() < 2 || std::any_of(e.runs.begin(), e.runs.end(), [](const Run& run) {
             return std::abs(run.rest[1]) < 0.2;
           });
  });
  Tally sum;
  double slowest = 0;
  for (const Slip& slip : slips) {
    const Tally tally = plant(slip, bent, slowest);
    MESSAGE(fmt::format("| {} | {} | {} | {} |", slip.expected, tally.planted, tally.asked, tally.right));
    sum.planted += tally.planted, sum.asked += tally.asked, sum.right += tally.right;
  }
  CHECK(sum.planted >= 20);
  CHECK(sum.asked > 0.9 * sum.planted);
  CHECK(sum.right > 0.9 * sum.asked);
}
