#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "diagnose/answers/offered_law.hpp"
#include "diagnose/discrepancy/law_choice.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Knots of every fourth are 0.1 rad apart.
const LawSpan evenly_bent{-0.4, 0.4, 10};
constexpr Eigen::Index nine_knots = 9;

JointTorqueLaw nothing_added(double stiffness, const LawSpan& span = evenly_bent) {
  return {{2}, span, Eigen::VectorXd::Zero(law_terms_count), stiffness};
}

/// The law that carries, with its spring, no torque at zero and these stiffnesses between nine knots, from
/// the lowest on.
JointTorqueLaw with_slopes(double stiffness, const std::vector<double>& slopes, double at_zero = 0) {
  JointTorqueLaw law = nothing_added(stiffness);
  const auto torque = [&](double d) {
    double sum = at_zero;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const double low = -0.4 + 0.1 * static_cast<double>(i), high = low + 0.1;
      sum += slopes[i] * (std::clamp(d, low, high) - std::clamp(0.0, low, high));
    }
    return sum;
  };
  for (Eigen::Index k = 0; k < finest_knots; ++k) {
    const double d = -0.4 + 0.025 * static_cast<double>(k);
    law.coefficients(k) = torque(d) - stiffness * d;
  }
  return law;
}

std::string words(const JointTorqueLaw& law) {
  return picture_of(law, nine_knots).words;
}

std::vector<double> slopes_of(double outer, double inner) {
  return {outer, inner, inner, inner, inner, inner, inner, outer};
}

}  // namespace

TEST_CASE("a law that adds nothing is the spring, and its knots are those of spring and law together") {
  const LawPicture bare = picture_of(nothing_added(10), nine_knots);
  CHECK(bare.words == "close to the nominal spring");
  CHECK(bare.joints == std::vector<std::size_t>{2});
  REQUIRE(bare.knots.size() == 9);
  for (std::size_t k = 0; k < 9; ++k) {
    CHECK(bare.knots[k].deflection == doctest::Approx(-0.4 + 0.1 * static_cast<double>(k)).scale(1));
    CHECK(bare.knots[k].torque == doctest::Approx(-4 + static_cast<double>(k)).scale(1));
  }
  CHECK(bare.sliders.empty());
  CHECK(bare.arms.empty());
  // Of what lies beyond the exercised by more than a knot nothing is drawn.
  const LawPicture half = picture_of(nothing_added(10, {-0.13, 0.4, 10}), nine_knots);
  REQUIRE(half.knots.size() == 7);
  CHECK(half.knots[0].deflection == close_to(-0.2));
  const LawPicture other = picture_of(nothing_added(10, {-0.4, 0.13, 10}), nine_knots);
  REQUIRE(other.knots.size() == 7);
  CHECK(other.knots[6].deflection == close_to(0.2));
}

TEST_CASE("how stiff, how slack, how hard and how soft a law is, in words, by hand") {
  CHECK(words(with_slopes(10, slopes_of(10.4, 10.4))) == "close to the nominal spring");
  CHECK(words(with_slopes(10, slopes_of(9.6, 9.6))) == "close to the nominal spring");
  CHECK(words(with_slopes(10, slopes_of(13, 13))) == "1.3 times as stiff as the nominal spring");
  CHECK(words(with_slopes(10, slopes_of(7, 7))) == "0.7 times as stiff as the nominal spring");

  CHECK(words(with_slopes(10, {20, 10, 10, 10, 10, 10, 15, 20})) ==
        "hardening from 0.2 rad, 2 times the stiffness near zero at 0.4 rad, "
        "hardening from -0.3 rad, 2 times the stiffness near zero at -0.4 rad");
  CHECK(words(with_slopes(10, {10, 10, 10, 10, 10, 10, 10, 14.1})) ==
        "hardening from 0.3 rad, 1.4 times the stiffness near zero at 0.4 rad");
  CHECK(words(with_slopes(10, {10, 10, 10, 10, 10, 10, 10, 13.9})) == "close to the nominal spring");
  // The middle of 5, 6, 10 and 10, 10, 10, 6, 5 is 8.
  CHECK(words(with_slopes(8, {5, 6, 10, 10, 10, 10, 6, 5})) ==
        "softening from 0.2 rad, 0.5 times the stiffness near zero at 0.4 rad, "
        "softening from -0.2 rad, 0.5 times the stiffness near zero at -0.4 rad");
  CHECK(words(with_slopes(10, {7.1, 10, 10, 10, 10, 10, 10, 10})) ==
        "softening from -0.3 rad, 0.71 times the stiffness near zero at -0.4 rad");
  CHECK(words(with_slopes(10, {7.2, 10, 10, 10, 10, 10, 10, 10})) == "close to the nominal spring");

  CHECK(words(with_slopes(10, {10, 10, 10, 1, 2, 10, 10, 10})) ==
        "slack of 0.2 rad about zero, "
        "hardening from 0.1 rad, 5 times the stiffness near zero at 0.4 rad, "
        "hardening from -0.1 rad, 10 times the stiffness near zero at -0.4 rad");
  CHECK(words(with_slopes(10, {10, 10, 2, 2, 2, 10, 10, 10})).starts_with("slack of 0.3 rad about zero"));
  CHECK_FALSE(words(with_slopes(10, {10, 10, 10, 2.6, 2.6, 10, 10, 10})).starts_with("slack"));

  // Soft all over one side is no slack.
  CHECK(words(with_slopes(10, {2, 2, 2, 2, 10, 10, 10, 10})).find("slack") == std::string::npos);

  CHECK(words(with_slopes(15, {10, 10, 10, 10, 20, 20, 20, 20})) ==
        "stiffer to the positive side, 20 N m/rad against 10");
  CHECK(words(with_slopes(10, {16, 16, 16, 16, 10, 10, 10, 10})) ==
        "1.3 times as stiff as the nominal spring, stiffer to the negative side, 16 N m/rad against 10");
  CHECK(words(with_slopes(12, {10, 10, 10, 10, 14.5, 14.5, 14.5, 14.5})) == "close to the nominal spring");
  // From where it is at ease, at 0.05 rad: 30.5 N m along 0.35 rad, 4.5 N m along 0.45 rad.
  CHECK(words(with_slopes(100, {10, 10, 10, 10, 10, 100, 100, 100}, -0.5))
            .find("stiffer to the positive side, 87.1 N m/rad against 10") != std::string::npos);

  CHECK(words(with_slopes(10, slopes_of(10, 10), -0.5)) == "at ease at 0.05 rad");
  CHECK(words(with_slopes(10, slopes_of(10, 10), 0.5)) == "at ease at -0.05 rad");
  CHECK(words(with_slopes(10, slopes_of(10, 10), -0.15)) ==
        "close to the nominal spring");  // 0.015 of 0.8 rad
  CHECK(words(with_slopes(10, slopes_of(10, 10), -0.17)) == "at ease at 0.017 rad");
}

TEST_CASE("loops and what relaxes, in words, by hand") {
  // The third slider slips after 0.1 of a stroke of 0.4 rad, the fourth that widens after sqrt(0.2) of 0.4
  // rad; the second arm relaxes in 0.15 of 10 s.
  JointTorqueLaw law = nothing_added(10);
  law.coefficients(finest_knots + 2) = 0.5;
  CHECK(words(law) == "loop of 1 N m, closed 0.08 rad after a reversal");
  law.coefficients(finest_knots + slip_places + 3) = 0.3;
  CHECK(words(law) == "loop of 1.3 N m, closed 0.08 rad after a reversal");  // of 1 within and 1.6 at the end
  law.coefficients(finest_knots + 2) = 0;
  CHECK(words(law) == "loop that widens to 0.6 N m at 0.4 rad, closed 0.08 rad after a reversal");
  law.coefficients(finest_knots + 5) = 0.25;  // 0.7 of the stroke; 0.5 within, 1.1 at the end
  CHECK(words(law) == "loop that widens to 1.1 N m at 0.4 rad, closed 0.56 rad after a reversal");
  law = nothing_added(10);
  law.coefficients(finest_knots + slider_terms + 1) = 0.2;
  CHECK(words(law) == "0.5 N m/rad that relax within 1.5 s");
  const LawPicture picture = picture_of(law, nine_knots);
  REQUIRE(picture.arms.size() == 1);
  CHECK(picture.arms[0].stiffness == close_to(0.5));
  CHECK(picture.arms[0].time_constant == close_to(1.5));
  law.coefficients(finest_knots + slider_terms + 1) = -0.2;  // what would feed is none
  CHECK(words(law) == "close to the nominal spring");
}

TEST_CASE("the terms of a law at every reading, by their own formulas") {
  const LawSpan span{-0.2, 0.4, 10};
  const std::vector<double> d{0.1, 0.3, std::nan(""), -0.1}, t{0, 2, 3, 5};
  Run run{"run", Control::end_point, {0}, {}};
  for (const double time : t) run.readings.push_back({time, {0, 0, 0, 0}});
  const Eigen::MatrixXd terms = law_terms(span, run, Eigen::Map<const Eigen::VectorXd>(d.data(), 4));
  REQUIRE(terms.cols() == law_terms_count);
  CHECK(terms.row(2).isZero());
  const std::vector<Eigen::Index> known{0, 1, 3};
  for (const Eigen::Index row : known)
    for (Eigen::Index k = 0; k < finest_knots; ++k) {
      const double place = -0.4 + 0.025 * static_cast<double>(k);
      CHECK(terms(row, k) ==
            doctest::Approx(std::max(0.0, 1 - std::abs(d[static_cast<std::size_t>(row)] - place) / 0.025))
                .scale(1)
                .epsilon(1e-12));
    }
  for (Eigen::Index m = 0; m < slip_places; ++m) {
    const double share = slip_shares[m], slips = 0.3 * share, widens = 0.16 * share;
    double slider = 0, wide_slider = 0, last = 0;
    for (const Eigen::Index row : known) {
      const double here = d[static_cast<std::size_t>(row)];
      slider = std::clamp(slider + (here - last) / slips, -1.0, 1.0);
      wide_slider = std::clamp(wide_slider + (here * here - last * last) / widens, -1.0, 1.0);
      CHECK(terms(row, finest_knots + m) == doctest::Approx(slider).epsilon(1e-12));
      CHECK(terms(row, finest_knots + slip_places + m) ==
            doctest::Approx(wide_slider * here / 0.4).epsilon(1e-12));
      last = here;
      const auto* const profiled = std::find(std::begin(profile_slips), std::end(profile_slips), m);
      if (profiled == std::end(profile_slips)) continue;
      for (Eigen::Index k = 0; k < profile_knots; ++k) {
        const double hat = std::max(0.0, 1 - std::abs(here + 0.4 - 0.05 * static_cast<double>(k)) / 0.05);
        CHECK(terms(row, plain_terms + (profiled - std::begin(profile_slips)) * profile_knots + k) ==
              doctest::Approx(slider * hat).scale(1).epsilon(1e-12));
      }
    }
  }
  for (Eigen::Index m = 0; m < arm_terms; ++m) {
    const double tau = 10 * time_shares[m];
    // A spring of one over 0.4 rad that relaxes while the joint turns steadily: dT/dt = v / 0.4 - T / tau.
    const auto after = [&](double torque, double speed, double dt) {
      const double settled = speed / 0.4 * tau;
      return settled + (torque - settled) * std::exp(-dt / tau);
    };
    const double second = after(0, 0.2 / 2, 2), fourth = after(second, -0.4 / 3, 3);
    CHECK(terms(0, finest_knots + slider_terms + m) == 0);
    CHECK(terms(1, finest_knots + slider_terms + m) == doctest::Approx(second).epsilon(1e-12));
    CHECK(terms(3, finest_knots + slider_terms + m) == doctest::Approx(fourth).epsilon(1e-12));
  }
  CHECK(law_terms({0, 0, 10}, run, Eigen::VectorXd::Ones(4)).isZero());
}

TEST_CASE("a law as the rig has it: shares of its torques at its knots, sliders and arms") {
  const LawSpan span{-0.2, 0.4, 10};
  Eigen::VectorXd c(law_terms_count);
  for (Eigen::Index i = 0; i < c.size(); ++i) c(i) = 1 + 0.1 * static_cast<double>(i);
  c(finest_knots) = -1, c(finest_knots + slip_places) = 0, c(finest_knots + slider_terms) = -2;
  const FreeLaw law = free_law(span, 5, c, 3, 0.5);
  CHECK(law.joint == 3);
  REQUIRE(law.knots.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(law.knots[k].deflection == doctest::Approx(-0.4 + 0.2 * static_cast<double>(k)).scale(1));
    CHECK(law.knots[k].torque == close_to(0.5 * c(8 * static_cast<Eigen::Index>(k))));
  }
  REQUIRE(law.sliders.size() == 13);
  CHECK(law.sliders[0].slips_at == close_to(0.05 * 0.3));
  CHECK(law.sliders[0].torque == close_to(0.5 * c(finest_knots + 1)));
  CHECK(law.sliders[0].growth == 0);
  CHECK(law.sliders[1].slips_at == close_to(std::sqrt(0.05) * 0.4));
  CHECK(law.sliders[1].torque == 0);
  CHECK(law.sliders[1].growth == close_to(0.5 * c(finest_knots + slip_places + 1) / 0.4));
  for (std::size_t p = 0; p < 3; ++p) {
    const FreeLaw::Slider& one = law.sliders[10 + p];
    CHECK(one.slips_at == close_to(std::vector{0.1, 0.2, 0.4}[p] * 0.3));
    CHECK(one.torque + one.growth == 0);
    REQUIRE(one.profile.size() == 17);
    for (std::size_t k = 0; k < 17; ++k) {
      CHECK(one.profile[k].deflection == doctest::Approx(-0.4 + 0.05 * static_cast<double>(k)).scale(1));
      CHECK(one.profile[k].torque == close_to(0.5 * c(plain_terms + static_cast<Eigen::Index>(17 * p + k))));
    }
  }
  REQUIRE(law.arms.size() == 2);
  CHECK(law.arms[0].time_constant == close_to(1.5));
  CHECK(law.arms[0].stiffness == close_to(0.5 * c(finest_knots + slider_terms + 1) / 0.4));
  CHECK(free_law(span, 5, c.head(plain_terms), 3, 0.5).sliders.size() == 10);
  c.tail(2 * profile_knots).setZero();
  CHECK(free_law(span, 5, c, 3, 0.5).sliders.size() == 11);
}

TEST_CASE("sums of two folds, what coefficients leave of them, and how many terms are affordable") {
  LawSums a{Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 2), 7}, b = a;
  b.terms(0, 1) = b.terms(1, 0) = 0.5, b.residual = 3;
  a += b;
  CHECK(a.residual == 10);
  CHECK(a.with_residual == Eigen::Vector2d(2, 4));
  // 10 - 2 (2 + 4) + (2 + 2 + 2 * 0.5)
  CHECK(a.left(Eigen::Vector2d(1, 1)) == close_to(3));
  CHECK(a.left(Eigen::Vector2d(1, 2)) == close_to(10 - 2 * 10 + 2 + 8 + 2));
  CHECK(LawSums{Eigen::MatrixXd::Zero(2, 2), Eigen::Vector2d(9, 0), 1}.left(Eigen::Vector2d(1, 0)) == 0);
  a -= b;
  CHECK(a.residual == 7);
  CHECK(a.terms == Eigen::MatrixXd::Identity(2, 2));
  CHECK(a.with_residual == Eigen::Vector2d(1, 2));

  const LawShape shape{5, {1, 2}, {0}};
  CHECK(shape.terms() == 8);
  CHECK(LawShape{17, {1}, {0, 2}, 1}.terms() == 37);
  CHECK(LawShape{17, {1}, {0, 2}, 0}.losses() == 3);
  CHECK(affordable(shape, 2, 32));
  CHECK_FALSE(affordable(shape, 2, 31));
  CHECK(affordable({3, {}, {}}, 1, 6));
  CHECK(affordable({3, {0}, {}}, 1, 0));  // four of eight at least
  CHECK_FALSE(affordable({3, {0, 1}, {}}, 1, 8));
}

namespace {

/// Sums of five folds over a joint that turns there and back ever wider, where it misses the torque of these
/// coefficients and reads it with a scatter of one.
LawFolds sums_of_missing(const Eigen::VectorXd& coefficients, std::size_t& values) {
  Run run{"run", Control::end_point, {0}, {}};
  std::vector<double> path;
  for (const double far : {0.05, -0.08, 0.15, -0.2, 0.3, -0.4, 0.4, -0.3, 0.2, -0.1, 0.0}) {
    const double from = path.empty() ? 0 : path.back();
    for (int i = 1; i <= 60; ++i) path.push_back(from + (far - from) * i / 60);
  }
  for (const double d : path)
    run.readings.push_back({static_cast<double>(run.readings.size()), {d, 0, 0, 0}});
  values = path.size();
  const LawSpan span{-0.4, 0.4, static_cast<double>(values)};
  const Eigen::MatrixXd terms =
      law_terms(span, run, Eigen::Map<const Eigen::VectorXd>(path.data(), static_cast<Eigen::Index>(values)));
  std::mt19937 engine(3);
  std::normal_distribution<double> scatter;
  std::vector<LawSums> folds(5, {Eigen::MatrixXd::Zero(law_terms_count, law_terms_count),
                                 Eigen::VectorXd::Zero(law_terms_count), 0});
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const Eigen::VectorXd term = terms.row(i).transpose();
    const double torque = term.dot(coefficients) + scatter(engine);
    folds[static_cast<std::size_t>(i / 10 % 5)] += {term * term.transpose(), term * torque, torque * torque};
  }
  return {folds};
}

}  // namespace

TEST_CASE("a loop of sliders all over the stroke is taken for what it is, whether they widen or not") {
  using Places = std::vector<Eigen::Index>;
  for (const Places& sliders :
       {Places{0, 2, 4}, Places{0, 2, 4, slip_places, slip_places + 2, slip_places + 4}}) {
    CAPTURE(sliders.size());
    Eigen::VectorXd truth = Eigen::VectorXd::Zero(law_terms_count);
    for (const Eigen::Index m : sliders) truth(finest_knots + m) = 100;
    std::size_t values = 0;
    const LawFolds folds = sums_of_missing(truth, values);
    const ChosenLaw found = choose_law(folds, values);
    CHECK(found.shape.sliders == sliders);
    // Each value leaves its scatter, 1, and each coefficient about 1 more, for it scatters too. The sum of so
    // many squares is within five of its standard deviations, sqrt(2 n) each.
    const auto count = static_cast<double>(values);
    CHECK(found.left < count + static_cast<double>(found.shape.terms()) + 5 * std::sqrt(2 * count));
  }
}
