#include "diagnose/answers/offered_law.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/hinge.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

std::optional<OfferedLaw> offered_for(const Experiment& experiment) {
  const Study study(experiment);
  return offer_law(study, declared_noise(study));
}

}  // namespace

TEST_CASE("a hardening law is recovered, and said") {
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 4 * d * d); };
  const Experiment experiment = hinge(
      {cycle(0.4, -0.4), cycle(-0.4, 0.4)}, [&] { return truth; }, 1);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->shrink->ratio < 1.3 * offered->shrink->noise_floor_ratio);
  // Straight between knots h apart, the law is off by h^2/12 T'' at the knots and less between; T'' is at
  // most 24 k 0.4 and h 0.05 where the choice is fine enough to reach the noise. Five standard deviations of
  // one reading beside, at the ends, where few readings bear a knot.
  const double tolerance = 0.05 * 0.05 / 12 * 24 * hinge_stiffness * 0.4 + 5 * force_noise * lever;
  for (const FreeLaw::Knot& knot : offered->pictures.front().knots)
    if (std::abs(knot.deflection) <= 0.4) CHECK(std::abs(knot.torque - truth(knot.deflection)) < tolerance);
  CHECK(offered->pictures.front().words.find("hardening") != std::string::npos);
  CHECK(offered->pictures.front().sliders.empty());
}

TEST_CASE("the loop of a spring with a slider is recovered") {
  static constexpr double slip = 2, turn = 0.05;
  const auto truth = [&] {
    return [=, carried = 0.0, last = 0.0](double d) mutable {
      carried = std::clamp(carried + slip / turn * (d - last), -slip, slip);
      last = d;
      return hinge_stiffness * d + carried;
    };
  };
  const Experiment experiment = hinge({cycle(0.4, -0.3), cycle(-0.4, 0.2), cycle(0.3, 0.1)}, truth, 2);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->shrink->ratio < 0.3);
  double carried = 0;
  for (const FreeLaw::Slider& one : offered->pictures.front().sliders) carried += one.torque;
  // The nearest sliders slip at 0.04 and 0.08 rad: a tenth of the torque is what their mixture may miss.
  CHECK(carried == close_to(slip).epsilon(0.1));
  CHECK(offered->pictures.front().words.find("loop of") != std::string::npos);
}

TEST_CASE("a loop that is open over a part of the way alone is recovered, whichever way it runs") {
  // Friction about 0.15 rad; where it is negative the way back gives more than the way there took.
  for (const double sign : {1.0, -1.0}) {
    const auto level = [=](double d) { return sign * 1.5 * std::exp(-std::pow((d - 0.15) / 0.08, 2)); };
    const auto truth = [&] {
      return [=, share = 0.0, last = 0.0](double d) mutable {
        share = std::clamp(share + (d - last) / 0.04, -1.0, 1.0);
        last = d;
        return hinge_stiffness * d + level(d) * share;
      };
    };
    const Experiment experiment = hinge({cycle(0.4, -0.3), cycle(-0.4, 0.2), cycle(0.4, 0.05)}, truth, 2);
    const std::optional<OfferedLaw> offered = offered_for(experiment);
    REQUIRE(offered);
    REQUIRE(offered->shrink);
    CHECK(offered->shrink->ratio < 0.3);
    const LawPicture& picture = offered->pictures.front();
    REQUIRE(picture.sliders.size() == 1);
    const auto& profile = picture.sliders.front().profile;
    const auto widest = std::max_element(profile.begin(), profile.end(), [](const auto& a, const auto& b) {
      return std::abs(a.torque) < std::abs(b.torque);
    });
    // knots are 0.05 rad apart: one lies at the middle of the loop, and is held straight with its neighbours
    CHECK(widest->deflection == close_to(0.15));
    CHECK(widest->torque == close_to(sign * 1.5).epsilon(0.2));
    CHECK(picture.words.find("rad and of") != std::string::npos);
    CHECK((picture.words.find("gives more than the way there took") != std::string::npos) == (sign < 0));
  }
}

TEST_CASE("a joint that has slack is said to have it") {
  const auto truth = [](double d) {
    return hinge_stiffness * std::copysign(std::max(0.0, std::abs(d) - 0.1), d);
  };
  const std::optional<OfferedLaw> offered = offered_for(hinge(
      {cycle(0.4, -0.4), cycle(-0.4, 0.4)}, [&] { return truth; }, 3));
  REQUIRE(offered);
  CHECK(offered->pictures.front().words.find("slack of 0.2 rad") != std::string::npos);
}

TEST_CASE("two knots to a side tell a hardening or a softening spring from a straight one") {
  const auto words = [](double cubic) {
    const LawSpan span{-0.4, 0.4, 10};
    JointTorqueLaw law{{1}, span, Eigen::VectorXd::Zero(law_terms_count), hinge_stiffness};
    for (Eigen::Index k = 0; k < finest_knots; ++k)
      law.coefficients(k) = hinge_stiffness * cubic * std::pow(knot_place(span, k), 3);
    return picture_of(law, 5).words;
  };
  CHECK(words(5).find("hardening from") != std::string::npos);
  CHECK(words(-3).find("softening from") != std::string::npos);
  CHECK(words(0) == "close to the nominal spring");
}

TEST_CASE("nothing is offered for noise") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Experiment experiment = hinge(
        {cycle(0.4, -0.4)}, [] { return [](double d) { return hinge_stiffness * d; }; }, seed);
    CHECK_FALSE(offered_for(experiment));
  }
}

TEST_CASE("where nothing predicts what was held out, nothing is offered") {
  // A joint that answers each of eight readings in its own way.
  const std::vector<double> wavers{9, -9, 8, -8, 9, -7, 8, -9};
  const auto torque = [&] {
    return [&, at = std::size_t{0}](double d) mutable {
      return hinge_stiffness * d + 10 * force_noise * lever * wavers[at++];
    };
  };
  const Experiment experiment = hinge({{0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}}, torque, 1);
  CHECK_FALSE(offered_for(experiment));
}

TEST_CASE("a law of readings so few that none can be held out is offered untested") {
  // Seven: an eighth of a run is what is held out at once.
  const auto truth = [](double d) { return hinge_stiffness * d * (1 + 40 * d * d); };
  const Experiment experiment = hinge(
      {{0.0, 0.1, 0.2, 0.3, 0.4, 0.25, 0.05}}, [&] { return truth; }, 1);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  CHECK_FALSE(offered->shrink);
}

TEST_CASE("in a chain of several joints the law is where the torque is missing") {
  Experiment experiment = three_links();
  experiment.noise[Channel::Name::q] = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 40, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 40, true);
  press(experiment, {0.5, -0.3, 0.4}, {-0.05, -0.02}, 40, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.value.resize(column_q);
  experiment = measured(experiment, only("joint_stop", 2), {0.05, 3}, 6);
  const std::optional<OfferedLaw> offered = offered_for(experiment);
  REQUIRE(offered);
  REQUIRE(offered->shrink);
  CHECK(offered->pictures.front().joints == std::vector<std::size_t>{2});
  CHECK(offered->shrink->ratio < 0.3);
}
