#include "diagnose/discrepancy/law_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::diagnose {
namespace {

/// From rest at no deflection.
double widening_turn(const LawSpan& span, Eigen::Index place) {
  return std::sqrt(slip_shares[place]) * span.deflection();
}

/// The sliders' and arms' states, carried from reading to reading.
struct History {
  Eigen::Array<double, slip_places, 1> slider = Eigen::Array<double, slip_places, 1>::Zero(),
                                       widening = slider;
  Eigen::Array<double, arm_terms, 1> arm = Eigen::Array<double, arm_terms, 1>::Zero();
};

void slide(const LawSpan& span, double from, double to, History& history) {
  for (Eigen::Index m = 0; m < slip_places; ++m) {
    const double slips_at = slip_shares[m] * span.stroke(), widens_at = widening_turn(span, m);
    history.slider(m) = std::clamp(history.slider(m) + (to - from) / slips_at, -1.0, 1.0);
    history.widening(m) =
        std::clamp(history.widening(m) + (to * to - from * from) / (widens_at * widens_at), -1.0, 1.0);
  }
}

/// Exact for a steady turn during the interval.
void relax(const LawSpan& span, double turn, double dt, History& history) {
  for (Eigen::Index m = 0; m < arm_terms; ++m) {
    const double ratio = dt / (time_shares[m] * span.duration);
    const double decay = std::exp(-ratio), gain = ratio > 0 ? -std::expm1(-ratio) / ratio : 1.0;
    history.arm(m) = decay * history.arm(m) + gain * turn / span.deflection();
  }
}

/// Hat functions of so many knots, which lie evenly over both signs: straight on beyond the outer ones.
Eigen::RowVectorXd hats(const LawSpan& span, Eigen::Index knots, double deflection) {
  const double place = (deflection / span.deflection() + 1) / 2 * static_cast<double>(knots - 1);
  const auto left = static_cast<Eigen::Index>(std::clamp(place, 0.0, static_cast<double>(knots - 2)));
  Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(knots);
  all(left) = 1 - (place - static_cast<double>(left));
  all(left + 1) = place - static_cast<double>(left);
  return all;
}

}  // namespace

double knot_place(const LawSpan& span, Eigen::Index knot) {
  return span.deflection() * (2.0 * static_cast<double>(knot) / static_cast<double>(finest_knots - 1) - 1.0);
}

Eigen::MatrixXd law_terms(const LawSpan& span, const Run& run, const Eigen::VectorXd& deflection) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(deflection.size(), law_terms_count);
  if (!(span.stroke() > 0)) return terms;
  History history;
  double last = 0, last_time = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Index i = 0; i < deflection.size(); ++i) {
    const double d = deflection(i);
    if (!std::isfinite(d)) continue;
    terms.row(i).head(finest_knots) = hats(span, finest_knots, d);
    const double t = run.readings[static_cast<std::size_t>(i)].t;
    slide(span, last, d, history);
    if (span.duration > 0 && std::isfinite(last_time)) relax(span, d - last, t - last_time, history);
    terms.row(i).segment(finest_knots, slip_places) = history.slider.matrix().transpose();
    terms.row(i).segment(finest_knots + slip_places, slip_places) =
        d / span.deflection() * history.widening.matrix().transpose();
    terms.row(i).segment(finest_knots + slider_terms, arm_terms) = history.arm.matrix().transpose();
    const Eigen::RowVectorXd profile = hats(span, profile_knots, d);
    for (Eigen::Index p = 0; p < profile_count; ++p)
      terms.row(i).segment(plain_terms + p * profile_knots, profile_knots) =
          history.slider(profile_slips[p]) * profile;
    last = d;
    last_time = t;
  }
  return terms;
}

FreeLaw free_law(const LawSpan& span, Eigen::Index knots, const Eigen::VectorXd& coefficients,
                 std::size_t joint, double share) {
  FreeLaw law{joint, {}, {}, {}};
  const Eigen::Index stride = (finest_knots - 1) / (knots - 1);
  for (Eigen::Index k = 0; k < finest_knots; k += stride)
    law.knots.push_back({knot_place(span, k), share * coefficients(k)});
  for (Eigen::Index m = 0; m < slip_places; ++m) {
    const double torque = share * coefficients(finest_knots + m),
                 widening = share * coefficients(finest_knots + slip_places + m);
    if (torque > 0) law.sliders.push_back({slip_shares[m] * span.stroke(), torque, 0});
    if (widening > 0) law.sliders.push_back({widening_turn(span, m), 0, widening / span.deflection()});
  }
  for (Eigen::Index m = 0; m < arm_terms; ++m)
    if (const double torque = share * coefficients(finest_knots + slider_terms + m); torque > 0)
      law.arms.push_back({time_shares[m] * span.duration, torque / span.deflection()});
  for (Eigen::Index p = 0; p < profile_count && coefficients.size() > plain_terms; ++p) {
    const Eigen::VectorXd torques =
        share * coefficients.segment(plain_terms + p * profile_knots, profile_knots);
    if (torques.isZero(0)) continue;
    law.sliders.push_back({slip_shares[profile_slips[p]] * span.stroke(), 0, 0});
    for (Eigen::Index k = 0; k < profile_knots; ++k)
      law.sliders.back().profile.push_back(
          {knot_place(span, k * (finest_knots - 1) / (profile_knots - 1)), torques(k)});
  }
  return law;
}

}  // namespace plumbline::diagnose
