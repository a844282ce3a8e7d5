#include "diagnose/discrepancy/resemblance.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/bench/median.hpp"
#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {
namespace {

/// A law without memory as it is drawn.
struct Curve {
  Eigen::ArrayXd deflection, torque;
  double reach;  ///< largest deflection to either side, rad
};

Curve curve_of(const LawPicture& picture) {
  const auto count = static_cast<Eigen::Index>(picture.knots.size());
  Curve curve{Eigen::ArrayXd(count), Eigen::ArrayXd(count), 0};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FreeLaw::Knot& knot = picture.knots[static_cast<std::size_t>(i)];
    curve.deflection(i) = knot.deflection;
    curve.torque(i) = knot.torque;
    curve.reach = std::max(curve.reach, std::abs(knot.deflection));
  }
  return curve;
}

/// Rms of what is left of a curve by a torque at rest and multiples of these shapes; of the last of them at
/// least nothing where it may not be negative.
double left_by(const Curve& curve, const std::vector<Eigen::ArrayXd>& shapes, bool may_be_negative = true) {
  Eigen::MatrixXd columns(curve.deflection.size(), static_cast<Eigen::Index>(shapes.size()) + 1);
  columns.col(0).setOnes();
  for (std::size_t s = 0; s < shapes.size(); ++s)
    columns.col(static_cast<Eigen::Index>(s) + 1) = shapes[s].matrix();
  const Eigen::VectorXd much = LeastSquares(columns).solve(curve.torque.matrix());
  if (!may_be_negative && much(much.size() - 1) < 0) return std::numeric_limits<double>::infinity();
  return std::sqrt((curve.torque.matrix() - columns * much).squaredNorm() /
                   static_cast<double>(curve.torque.size()));
}

/// What a deflection is beyond so much, to both sides.
Eigen::ArrayXd beyond(const Eigen::ArrayXd& d, double limit) {
  return d.sign() * (d.abs() - limit).max(0);
}

/// The least that is left by a shape that begins somewhere: over twenty places, then over as many about the
/// best of these. Coarser, a shape with a coefficient more would pass for it.
template <class Left>
double least(double from, double to, const Left& left) {
  constexpr int places = 20;
  double best = std::numeric_limits<double>::infinity(), at = from;
  const auto look = [&](double low, double step) {
    for (int i = 0; i <= places; ++i)
      if (const double here = left(low + i * step); here < best) best = here, at = low + i * step;
  };
  const double step = (to - from) / places;
  look(from, step);
  const double around = std::max(from, at - step);
  look(around, (std::min(to, at + step) - around) / places);
  return best;
}

struct Likeness {
  const char* id;
  double left;
};

/// The shapes of springs in the catalogue, each with what it leaves of a curve at its best. They have as many
/// values each, a rest angle and a stiffness among them: what is left may be compared. A spring stiffer to
/// one side turns near zero; a stop, or one to each side, away from it, as does one that gives way to both;
/// play may lie off zero by as much.
std::vector<Likeness> shapes(const Curve& curve) {
  constexpr double near_zero = 0.25, far = 0.9;  // of the reach
  const Eigen::ArrayXd& d = curve.deflection;
  const double reach = curve.reach;
  const double cubic = left_by(curve, {d, d.cube()});
  const double one_side = least(-near_zero * reach, near_zero * reach, [&](double at) {
    return left_by(curve, {d, (d - at).abs()});
  });
  const double stops = least(near_zero * reach, far * reach, [&](double at) {
    const Eigen::ArrayXd above = (d - at).max(0), below = (d + at).min(0);
    return std::min({left_by(curve, {d, beyond(d, at)}, false), left_by(curve, {d, above}, false),
                     left_by(curve, {d, below}, false)});
  });
  const double gives_way = least(near_zero * reach, far * reach, [&](double at) {
    return left_by(curve, {d, -beyond(d, at)}, false);
  });
  const double play = least(-near_zero * reach, near_zero * reach, [&](double middle) {
    return least(0.02 * reach, far * reach,
                 [&](double half) { return left_by(curve, {beyond(d - middle, half)}, false); });
  });
  return {{"nonlinear_spring", cubic},
          {"asymmetric_spring", one_side},
          {"piecewise_spring", gives_way},
          {"joint_stop", stops},
          {"backlash", play}};
}

/// Effects whose spring draws the law: one that leaves half of what a straight line leaves, or less, and
/// those that come near it; a stiffness where the line is another one. None where no shape of the catalogue
/// does.
std::vector<std::string> like_spring(const Curve& curve, double usual_stiffness, double nominal) {
  constexpr double straight = 0.03, halves = 0.5, nearly = 1.3, noticeable = 0.05;
  const double line = left_by(curve, {curve.deflection});
  const double size = std::sqrt(curve.torque.square().mean());
  if (line < straight * size || curve.torque.size() < 5) {
    if (std::abs(usual_stiffness / nominal - 1) > noticeable) return {"joint_stiffness"};
    return {};
  }
  std::vector<Likeness> found = shapes(curve);
  std::sort(found.begin(), found.end(), [](const Likeness& a, const Likeness& b) { return a.left < b.left; });
  std::vector<std::string> ids;
  for (const Likeness& one : found)
    if (one.left < halves * line && one.left <= nearly * found.front().left + straight * size / 3)
      ids.emplace_back(one.id);
  return ids;
}

/// Half the loop of a slider where it is widest, N m.
double widest(const FreeLaw::Slider& one, double reach) {
  double most = one.torque + one.growth * reach;
  for (const FreeLaw::Knot& knot : one.profile) most = std::max(most, std::abs(knot.torque));
  return most;
}

/// Effects whose memory is like that of the law's sliders.
std::vector<std::string> like_loop(const LawPicture& picture, const Curve& curve, const LawSpan& span) {
  constexpr double noticeable = 0.05, at_once = 0.05;  // of the largest torque; of the stroke
  double loop = 0, grows = 0, slips_at = 0;
  for (const FreeLaw::Slider& one : picture.sliders) {
    const double wide = widest(one, curve.reach);
    loop += wide;
    if (one.growth > 0) grows += wide;
    if (wide > 0) slips_at = std::max(slips_at, one.growth > 0 ? 0 : one.slips_at);
  }
  if (!(loop > noticeable * curve.torque.abs().maxCoeff())) return {};
  if (grows > loop / 2) return {"load_friction"};
  if (slips_at > at_once * span.stroke()) return {"hysteresis"};
  return {"joint_friction", "hysteresis"};
}

/// Effects that relax as the law's arms do.
std::vector<std::string> like_relaxation(const LawPicture& picture) {
  if (picture.arms.empty()) return {};
  // One time constant lies between two of the law's.
  return picture.arms.size() < 3 ? std::vector<std::string>{"viscoelasticity", "relaxation_spectrum"}
                                 : std::vector<std::string>{"relaxation_spectrum", "viscoelasticity"};
}

}  // namespace

std::vector<std::vector<std::string>> resemblance(const LawPicture& picture, const JointTorqueLaw& law) {
  const Curve curve = curve_of(picture);
  if (picture.knots.size() < 3) return {};
  std::vector<std::vector<std::string>> all{
      like_spring(curve, median(stiffnesses(picture.knots)), law.stiffness),
      like_loop(picture, curve, law.span), like_relaxation(picture)};
  std::erase_if(all, [](const std::vector<std::string>& one) { return one.empty(); });
  return all;
}

}  // namespace plumbline::diagnose
