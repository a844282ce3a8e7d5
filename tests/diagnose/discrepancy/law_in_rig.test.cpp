#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "diagnose/decision/heldout.hpp"
#include "diagnose/discrepancy/torque_law.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Study one_loop() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  return Study(measured(experiment, only("force_gain"), {0.2}, 5));
}

/// A law of these joints over a range of deflections, of two straight sides: `slope` N m/rad at a joint of
/// the mean stiffness.
TorqueLaw straight_law(const Study& study, const std::vector<std::size_t>& joints, const LawSpan& span,
                       double slope) {
  JointTorqueLaw one{joints, span, Eigen::VectorXd::Zero(law_terms_count), 0};
  for (Eigen::Index k = 0; k < finest_knots; ++k) one.coefficients(k) = slope * knot_place(span, k);
  for (const std::size_t joint : joints)
    one.stiffness += study.experiment().joint_stiffness[joint - 1] / static_cast<double>(joints.size());
  return {{one}, {finest_knots}, 1};
}

/// Deflections of a joint along the first run of the nominal model.
std::vector<double> bends(const Study& study, std::size_t joint) {
  std::vector<double> all;
  for (Eigen::Index i = 0; i < study.nominal().runs[0].rows(); ++i)
    all.push_back(angle(study.nominal().runs[0], i, joint - 1) - study.experiment().runs[0].rest[joint - 1]);
  return all;
}

}  // namespace

TEST_CASE("a straight law of some joints is a stiffer spring there, in proportion to their own") {
  const Study study = one_loop();
  const LawSpan span{-1, 1, 40};
  // springs of 2 and 1: a mean of 1.5, of which 0.3 is a fifth
  const TorqueLaw law = straight_law(study, {1, 3}, span, 0.3);
  const std::vector<FreeLaw> laws = free_laws(study, law);
  REQUIRE(laws.size() == 2);
  CHECK(laws[0].joint == 1);
  CHECK(laws[1].joint == 3);
  for (const FreeLaw& one : laws) {
    const double own = one.joint == 1 ? 2 : 1;
    for (const FreeLaw::Knot& knot : one.knots)
      CHECK(knot.torque == doctest::Approx(0.2 * own * knot.deflection).epsilon(1e-12));
  }
  const Candidate stiffer{{{"joint_stiffness", 1}, {"joint_stiffness", 3}}};
  const Prediction expected = predict(study, stiffer, {std::log1p(0.2), std::log1p(0.2)});
  // both are solved to ten digits of forces of some newtons
  CHECK(difference(predict_with_law(study, law).runs[0], expected.runs[0]) < 1e-8);
}

TEST_CASE("what is left with a law is the sum of squares in the noise, without outliers") {
  const Study study = one_loop();
  NoiseEstimate noise = declared_noise(study);
  noise_of(noise, Channel(Channel::Name::Fx)).scale = 2;
  noise_of(noise, Channel(Channel::Name::Fy)).scale = 3;
  noise.shape.outlier[7] = noise.shape.outlier[90] = true;
  const TorqueLaw none = straight_law(study, {2}, {-1, 1, 40}, 0);
  const auto squares = [&](const Eigen::VectorXd& residual) {
    double sum = 0;
    for (const Series& series : study.measurements().series())
      for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i)
        if (i != 7 && i != 90)
          sum += std::pow(residual(static_cast<Eigen::Index>(i)) / noise.of(series.channel).scale, 2);
    return sum;
  };
  CHECK(left_with(study, noise, none) == close_to(squares(study.nominal_residual())).epsilon(1e-6));
  const TorqueLaw law = straight_law(study, {2}, {-1, 1, 40}, 0.3);
  const Prediction stiffer = predict(study, only("joint_stiffness", 2), {std::log1p(0.2)});
  CHECK(left_with(study, noise, law) == close_to(squares(study.residual(stiffer))).epsilon(1e-6));
  // A spring that pushes away holds no posture.
  CHECK(left_with(study, noise, straight_law(study, {1, 2, 3}, {-1, 1, 40}, -30)) ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("a law and its spring along a run, where the chain then stands") {
  const Study study = one_loop();
  const TorqueLaw law = straight_law(study, {1, 3}, {-1, 1, 40}, 0.3);
  const Trace trace = predict_with_law(study, law).runs[0];
  const std::vector<LawTrace> traces = law_traces(study, law);
  REQUIRE(traces.size() == 2);
  for (std::size_t t = 0; t < 2; ++t) {
    CHECK(traces[t].joint == (t == 0 ? 1 : 3));
    CHECK(traces[t].run == 0);
    const std::size_t joint = traces[t].joint - 1;
    for (Eigen::Index i = 0; i < trace.rows(); ++i) {
      const double bent = angle(trace, i, joint) - study.experiment().runs[0].rest[joint];
      CHECK(traces[t].deflection(i) == doctest::Approx(bent).epsilon(1e-9));
      CHECK(traces[t].torque(i) ==
            doctest::Approx(1.2 * study.experiment().joint_stiffness[joint] * bent).epsilon(1e-9));
    }
  }
}

TEST_CASE(
    "a law covers what is held out where nine in ten of its deflections are within a tenth of the stroke") {
  const Study study = one_loop();
  const std::vector<double> bent = bends(study, 2);
  HeldOut held = nothing_held(study.experiment());
  // ten readings of the way there, bending farther and farther
  for (std::size_t i = 5; i < 15; ++i) held.reading[0][i] = true;
  const bool up = bent[14] > bent[5];
  const auto covered = [&](std::size_t last, double slack) {
    // ends, from the other side of rest, so far short of that reading as its slack reaches, or a little less
    const double end = bent[last];
    LawSpan span{up ? -0.5 : 0, up ? 0 : 0.5, 40};
    // end = high + slack (high - low) / 2 with the low at half a radian to the other side
    const double reach = (std::abs(end) - slack * 0.25) / (1 + slack / 2);
    (up ? span.high : span.low) = up ? reach : -reach;
    return covers(study, straight_law(study, {2}, span, 0.1), held.reading);
  };
  CHECK(covered(14, 0.0999));
  CHECK(covered(13, 0.0999));  // nine of ten
  CHECK(covered(13, 0.09999));
  CHECK_FALSE(covered(13, 0.1001));  // eight
  CHECK_FALSE(covered(12, 0.0999));
  // what is held out of no joint is covered
  CHECK(covers(study, straight_law(study, {2}, {0, 0, 40}, 0), nothing_held(study.experiment()).reading));
}
