#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answers/offered_law.hpp"

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// Knots, the ends of what was exercised among them.
std::vector<FreeLaw::Knot> drawn_knots(const JointTorqueLaw& law, Eigen::Index count) {
  const Eigen::Index stride = (finest_knots - 1) / (count - 1);
  std::vector<FreeLaw::Knot> knots;
  for (Eigen::Index k = 0; k < finest_knots; k += stride) {
    const double d = knot_place(law.span, k), added = law.coefficients(k);
    // A little beyond the exercised, as the last hat reaches.
    const double step = knot_place(law.span, stride) - knot_place(law.span, 0);
    if (d < law.span.low - step || d > law.span.high + step) continue;
    knots.push_back({d, law.stiffness * d + added});
  }
  return knots;
}

double slope(const FreeLaw::Knot& a, const FreeLaw::Knot& b) {
  return b.deflection != a.deflection ? (b.torque - a.torque) / (b.deflection - a.deflection) : 0;
}

using Parts = std::vector<std::string>;

void add_stiffness(const JointTorqueLaw& law, const std::vector<double>& stiffness, Parts& parts) {
  constexpr double noticeable = 0.05;
  const double ratio = median(stiffness) / law.stiffness;
  if (std::abs(ratio - 1) > noticeable)
    parts.push_back(fmt::format("{:.2g} times as stiff as the nominal spring", ratio));
}

/// Where around zero the joint carries next to nothing, beside what it has where it is stiff: a quarter of
/// the way is stiffer.
void add_slack(const std::vector<FreeLaw::Knot>& knots, const std::vector<double>& stiffness, Parts& parts) {
  constexpr double soft = 0.25;
  std::vector<double> sorted = stiffness;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() * 3 / 4];
  std::size_t zero = 0;
  while (zero + 1 < stiffness.size() && knots[zero + 1].deflection < 0) ++zero;
  std::size_t from = zero, to = zero;
  const auto slack = [&](std::size_t i) { return stiffness[i] < soft * usual; };
  if (!slack(zero)) return;
  while (from > 0 && slack(from - 1)) --from;
  while (to + 1 < stiffness.size() && slack(to + 1)) ++to;
  // What is soft to the end of a side that was bent is no slack.
  constexpr double bent = 0.25;  // of the other side
  const double below = -knots.front().deflection, above = knots.back().deflection;
  if ((from == 0 && below > bent * above) || (to + 1 == stiffness.size() && above > bent * below)) return;
  parts.push_back(
      fmt::format("slack of {:.2g} rad about zero", knots[to + 1].deflection - knots[from].deflection));
}

/// One side: where the stiffness leaves that near zero for good, and how far.
void add_side(const std::vector<FreeLaw::Knot>& knots, const std::vector<double>& stiffness, double sign,
              Parts& parts) {
  constexpr double change = 1.4;
  std::vector<std::size_t> outward;
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    if (sign * (knots[i].deflection + knots[i + 1].deflection) > 0) outward.push_back(i);
  if (outward.size() < 2) return;
  if (sign < 0) std::reverse(outward.begin(), outward.end());
  const double inner = stiffness[outward.front()], outer = stiffness[outward.back()];
  if (!(inner > 0)) return;
  const bool harder = outer > change * inner, softer = change * outer < inner;
  if (!harder && !softer) return;
  std::size_t from = outward.size() - 1;
  while (from > 0 && (harder ? stiffness[outward[from - 1]] > change * inner
                             : change * stiffness[outward[from - 1]] < inner))
    --from;
  const FreeLaw::Knot& near = sign > 0 ? knots[outward[from]] : knots[outward[from] + 1];
  parts.push_back(fmt::format("{} from {:.2g} rad, {:.2g} times the stiffness near zero at {:.2g} rad",
                              harder ? "hardening" : "softening", near.deflection, outer / inner,
                              sign > 0 ? knots.back().deflection : knots.front().deflection));
}

/// Where the law carries nothing.
std::optional<double> rest_of(const std::vector<FreeLaw::Knot>& knots) {
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto [d0, t0] = knots[i - 1];
    const auto [d1, t1] = knots[i];
    if (t0 * t1 <= 0 && t0 != t1) return d0 - t0 * (d1 - d0) / (t1 - t0);
  }
  return std::nullopt;
}

/// Both sides, from where it is at ease to the ends.
void add_asymmetry(const std::vector<FreeLaw::Knot>& knots, double rest, Parts& parts) {
  constexpr double clearly = 1.5;
  const auto secant = [&](const FreeLaw::Knot& end) { return end.torque / (end.deflection - rest); };
  const double above = secant(knots.back()), below = secant(knots.front());
  if (!(above > 0 && below > 0) || std::max(above, below) < clearly * std::min(above, below)) return;
  parts.push_back(fmt::format("stiffer to the {} side, {:.3g} N m/rad against {:.3g}",
                              above > below ? "positive" : "negative", std::max(above, below),
                              std::min(above, below)));
}

void add_rest(double rest, const LawSpan& span, Parts& parts) {
  constexpr double noticeable = 0.02;  // of the range
  if (std::abs(rest) > noticeable * 2 * span.stroke())
    parts.push_back(fmt::format("at ease at {:.2g} rad", rest));
}

/// The ends of what its loop is worth, of the knots where the joint was bent, the wider first.
void add_profile(const FreeLaw::Slider& one, const LawSpan& span, Parts& parts) {
  constexpr double noticeable = 0.1;
  std::vector<FreeLaw::Knot> within;
  for (const FreeLaw::Knot& knot : one.profile)
    if (knot.deflection >= span.low && knot.deflection <= span.high) within.push_back(knot);
  const auto [least, most] = std::minmax_element(
      within.begin(), within.end(), [](const auto& a, const auto& b) { return a.torque < b.torque; });
  const bool backwards = -least->torque > most->torque;
  const FreeLaw::Knot &wide = backwards ? *least : *most, &narrow = backwards ? *most : *least;
  parts.push_back(fmt::format("loop of {:.2g} N m at {:.2g} rad and of {:.2g} N m at {:.2g} rad",
                              2 * wide.torque, wide.deflection, 2 * narrow.torque, narrow.deflection));
  if (-least->torque > noticeable * std::abs(wide.torque))
    parts.emplace_back("where it is negative the way back gives more than the way there took");
  parts.push_back(fmt::format("closed {:.2g} rad after a reversal", 2 * one.slips_at));
}

void add_memory(const LawPicture& picture, const LawSpan& span, Parts& parts) {
  double within = 0, at_end = 0, widest = 0;
  for (const FreeLaw::Slider& one : picture.sliders) {
    if (!one.profile.empty()) {
      add_profile(one, span, parts);
      continue;
    }
    within += 2 * one.torque;
    at_end += 2 * (one.torque + one.growth * span.deflection());
    // After a reversal at the largest deflection, where it slides along d^2/2.
    const double turn = one.growth > 0 ? one.slips_at * one.slips_at / (2 * span.deflection()) : one.slips_at;
    widest = std::max(widest, turn);
  }
  if (at_end > 2 * within) {
    parts.push_back(fmt::format("loop that widens to {:.2g} N m at {:.2g} rad", at_end, span.deflection()));
  } else if (at_end > 0) {
    parts.push_back(fmt::format("loop of {:.2g} N m", (within + at_end) / 2));
  }
  if (at_end > 0) parts.push_back(fmt::format("closed {:.2g} rad after a reversal", 2 * widest));
  for (const FreeLaw::Arm& one : picture.arms)
    parts.push_back(
        fmt::format("{:.2g} N m/rad that relax within {:.2g} s", one.stiffness, one.time_constant));
}

std::string in_words(const Parts& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "close to the nominal spring" : text;
}

}  // namespace

std::vector<double> stiffnesses(const std::vector<FreeLaw::Knot>& knots) {
  std::vector<double> all;
  for (std::size_t i = 1; i < knots.size(); ++i) all.push_back(slope(knots[i - 1], knots[i]));
  return all;
}

LawPicture picture_of(const JointTorqueLaw& law, Eigen::Index knots) {
  FreeLaw bare = free_law(law.span, knots, law.coefficients, law.joints.front(), 1);
  LawPicture picture{law.joints, drawn_knots(law, knots), std::move(bare.sliders), std::move(bare.arms), ""};
  Parts parts;
  if (const std::vector<double> stiffness = stiffnesses(picture.knots); stiffness.size() > 1) {
    const std::optional<double> rest = rest_of(picture.knots);
    add_stiffness(law, stiffness, parts);
    add_slack(picture.knots, stiffness, parts);
    if (rest) add_asymmetry(picture.knots, *rest, parts);
    add_side(picture.knots, stiffness, 1, parts);
    add_side(picture.knots, stiffness, -1, parts);
    if (rest) add_rest(*rest, law.span, parts);
  }
  add_memory(picture, law.span, parts);
  picture.words = in_words(parts);
  return picture;
}

}  // namespace plumbline::diagnose
