#include "diagnose/answers/law_terms.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// One slider's or arm's state, carried from reading to reading.
struct History {
  Eigen::Array<double, slip_places, 1> slider = Eigen::Array<double, slip_places, 1>::Zero();
  Eigen::Array<double, arm_terms, 1> arm = Eigen::Array<double, arm_terms, 1>::Zero();
};

void slide(const LawSpan& span, double turn, History& history) {
  for (Eigen::Index m = 0; m < slip_places; ++m) {
    const double limit = slip_shares[m] * span.stroke();
    history.slider(m) = std::clamp(history.slider(m) + turn / limit, -1.0, 1.0);
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

}  // namespace

double knot_place(const LawSpan& span, Eigen::Index knot) {
  return span.deflection() * (2.0 * static_cast<double>(knot) / static_cast<double>(finest_knots - 1) - 1.0);
}

Eigen::MatrixXd law_terms(const LawSpan& span, const Run& run, const Eigen::VectorXd& deflection) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(deflection.size(), law_terms_count);
  if (!(span.stroke() > 0)) return terms;
  History history;
  double last = 0, last_time = run.readings.empty() ? 0 : run.readings.front().t;
  for (Eigen::Index i = 0; i < deflection.size(); ++i) {
    const double d = deflection(i);
    if (!std::isfinite(d)) continue;
    const double place = (d / span.deflection() + 1) / 2 * static_cast<double>(finest_knots - 1);
    const auto left =
        static_cast<Eigen::Index>(std::clamp(place, 0.0, static_cast<double>(finest_knots - 2)));
    terms(i, left) = 1 - (place - static_cast<double>(left));
    terms(i, left + 1) = place - static_cast<double>(left);
    const double t = run.readings[static_cast<std::size_t>(i)].t;
    slide(span, d - last, history);
    if (span.duration > 0) relax(span, d - last, t - last_time, history);
    const auto sliders = history.slider.matrix().transpose();
    terms.row(i).segment(finest_knots, slip_places) = sliders;
    terms.row(i).segment(finest_knots + slip_places, slip_places) = std::abs(d) / span.deflection() * sliders;
    terms.row(i).tail(arm_terms) = history.arm.matrix().transpose();
    last = d;
    last_time = t;
  }
  return terms;
}

}  // namespace plumbline::diagnose
