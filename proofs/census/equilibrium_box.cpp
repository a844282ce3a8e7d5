#include "proofs/census/equilibrium_box.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <plumbline/loaded/nominal_model.hpp>

namespace plumbline::proofs {

namespace {

constexpr double half_turn = 3.1415926535897936;  // above pi

/// A passive joint's circle is cut where no symmetric shape lies.
constexpr double cut = 0.1234567;

/// Wider ranges hold more equilibria than can be listed.
constexpr double widest_range = 1e5;

}  // namespace

EquilibriumBox::EquilibriumBox(const Chain<Interval>& chain, Control control, const Point<Interval>& load,
                               const Window& window)
    : n_(chain.size()),
      size_(chain.size() + (control == Control::end_point ? 2 : 0)),
      held_(control == Control::end_point),
      load_x_(load.x),
      load_y_(load.y) {
  if (n_ > most_links)
    throw Error("census", std::to_string(n_) + " links", "at most " + std::to_string(most_links));
  double reach = 0, softness = 0;
  const std::vector<Interval> z = distance_to_end(chain);
  for (std::size_t i = 0; i < n_; ++i) {
    length_.emplace_back(chain.length()[i]);
    stiffness_.emplace_back(chain.stiffness()[i]);
    rest_.emplace_back(chain.rest()[i]);
    const Span& k = stiffness_.back();
    passive_.push_back(k.high <= 0);
    if (!passive_.back() && !(k.low > 0))
      throw Error("census", "a stiffness that may or may not be zero", "a passive or an elastic joint");
    reach += length_.back().high;
    if (passive_.back()) {
      range_.emplace_back(-half_turn + cut, half_turn + cut);
    } else {
      if (held_) {
        range_.emplace_back(window[i]);
      } else {
        const double turn = (Span(z[i]) * Span(load_x_.magnitude() + load_y_.magnitude()) / k).high;
        range_.push_back(rest_.back() + Span(-turn, turn));
      }
      if (!(range_.back().magnitude() < widest_range)) {
        throw Error("census", "joint " + std::to_string(i + 1) + " turned by more than 1e5 rad",
                    "a load that the springs can bear, and rest angles of a few turns");
      }
      softness += 1 / k.low;
    }
  }
  force_weight_ = reach * softness / static_cast<double>(n_);
  if (held_) force_limit_ = force_bound(chain, load);
}

double EquilibriumBox::force_bound(const Chain<Interval>& chain, const Point<Interval>& place) const {
  const NominalModel<double> model(
      convert<double>(chain, [](const Interval& x) { return Span(x).middle(); }));
  const double distance = std::hypot(load_x_.middle(), load_y_.middle());
  const auto [inner, outer] = reach(model.chain().length());
  // the units here are the chain's own, which mean nothing to who reads an error
  const std::string found = fmt::format("{:.6g} of the chain's reach from the base", distance / outer);
  if (n_ > 1 && (!(distance < outer) || (inner > 0 && !(distance > inner))))
    throw Error("end point", found, fmt::format("between {:.6g} and 1 of it, both excluded", inner / outer));
  model.require_reach({Span(place.x).middle(), Span(place.y).middle()});
  double gap = distance, bend = 0, moment = 0, rounding = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    bend += 4 / length_[i].low;
    if (!passive_[i]) moment = std::max(moment, (stiffness_[i] * (range_[i] - rest_[i])).magnitude());
    rounding += length_[i].width() + 1e-15 * length_[i].high;
  }
  rounding += load_x_.width() + load_y_.width();
  for (std::size_t signs = 0; signs < (std::size_t{1} << n_); ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i)
      sum += ((signs >> i) & 1U) != 0 ? length_[i].middle() : -length_[i].middle();
    gap = std::min(gap, std::abs(distance - std::abs(sum)));
  }
  gap -= rounding;
  if (!(gap > 1e-9 * distance)) {
    throw Error("end point", found,
                "a distance that no shape with all links in one line has: there the force is not bounded");
  }
  const double delta = 2 * gap / (1 + std::sqrt(1 + 4 * bend * gap));  // bend delta^2 + delta = gap
  return 1.001 * moment / delta;
}

Box EquilibriumBox::everything() const {
  Box z;
  Span sum(0);
  for (std::size_t j = 0; j < n_; ++j) z[j] = sum = sum + range_[j];
  if (held_) z[n_] = z[n_ + 1] = Span(-force_limit_, force_limit_);
  return z;
}

bool EquilibriumBox::ranges(Box& z) const {
  if (!bind(z[0], range_[0])) return false;
  for (std::size_t i = 1; i < n_; ++i) {
    if (!bind(z[i], z[i - 1] + range_[i])) return false;
  }
  for (std::size_t i = n_; i-- > 1;) {
    if (!bind(z[i - 1], z[i] - range_[i])) return false;
  }
  return true;
}

Span EquilibriumBox::torque_in(const Box& z, std::size_t joint) const {
  if (passive_[joint]) return Span(0);
  const Span q = joint > 0 ? z[joint] - z[joint - 1] : z[joint];
  const Span counted = intersection(q, range_[joint]);
  return stiffness_[joint] * ((counted.empty() ? q : counted) - rest_[joint]);
}

bool EquilibriumBox::recursion(Box& z) const {
  std::array<Span, most_links + 1> moment;  // M_i at joint i, and none at the free end
  std::array<Span, most_links> gain;        // M_i - M_{i+1}
  Span left_x = load_x_, left_y = load_y_;
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(z[i]);
    gain[i] = length_[i] * (fy(z) * t.cosine - fx(z) * t.sine);
    if (held_) {
      left_x -= length_[i] * t.cosine;
      left_y -= length_[i] * t.sine;
    }
    moment[i] = torque_in(z, i);
  }
  if (held_ && (!left_x.contains(0) || !left_y.contains(0))) return false;
  moment[n_] = Span(0);
  if (held_ && !bind(moment[0], load_x_ * fy(z) - load_y_ * fx(z))) return false;
  const auto turn_by = [&](std::size_t i) {  // what the moment says of the angles on both sides of joint i
    if (passive_[i]) return true;
    const Span q = rest_[i] + moment[i] / stiffness_[i];
    if (i == 0) return bind(z[0], q);
    return bind(z[i], z[i - 1] + q) && bind(z[i - 1], z[i] - q);
  };
  for (std::size_t i = 0; i < n_; ++i) {
    if (!turn_by(i) || !bind(moment[i + 1], moment[i] - gain[i])) return false;
  }
  for (std::size_t i = n_; i-- > 0;) {
    if (!bind(moment[i], moment[i + 1] + gain[i]) || !turn_by(i)) return false;
  }
  return true;
}

Box EquilibriumBox::residual(const Box& z) const {
  Box f;
  Span x = -load_x_, y = -load_y_, torque(0);
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(z[i]);
    torque = stiffness_[i] * ((i > 0 ? z[i] - z[i - 1] : z[i]) - rest_[i]);
    f[i] = torque + length_[i] * (t.sine * fx(z) - t.cosine * fy(z));
    if (i > 0) f[i - 1] -= torque;
    x += length_[i] * t.cosine;
    y += length_[i] * t.sine;
  }
  if (held_) f[n_] = x, f[n_ + 1] = y;
  return f;
}

EquilibriumBox::SpanMatrix EquilibriumBox::derivative(const Box& z) const {
  SpanMatrix A;
  for (std::size_t i = 0; i < size_; ++i) A.entry[i].fill(Span(0));
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(z[i]);
    const Span x = length_[i] * t.cosine, y = length_[i] * t.sine;
    A.entry[i][i] = stiffness_[i] + x * fx(z) + y * fy(z);
    if (i + 1 < n_) {
      A.entry[i][i] += stiffness_[i + 1];
      A.entry[i][i + 1] = A.entry[i + 1][i] = -stiffness_[i + 1];
    }
    if (held_) {
      A.entry[i][n_] = y;
      A.entry[i][n_ + 1] = -x;
      A.entry[n_][i] = -y;
      A.entry[n_ + 1][i] = x;
    }
  }
  return A;
}

bool EquilibriumBox::inverse_of_middle(const SpanMatrix& A, Matrix& inverse) const {
  Matrix M;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      M.entry[i][j] = A.entry[i][j].middle();
      inverse.entry[i][j] = i == j ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < size_; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < size_; ++i) {
      if (std::abs(M.entry[i][k]) > std::abs(M.entry[best][k])) best = i;
    }
    if (!(std::abs(M.entry[best][k]) > 1e-300)) return false;
    std::swap(M.entry[best], M.entry[k]);
    std::swap(inverse.entry[best], inverse.entry[k]);
    const double pivot = 1 / M.entry[k][k];
    for (std::size_t j = 0; j < size_; ++j) {
      M.entry[k][j] *= pivot;
      inverse.entry[k][j] *= pivot;
    }
    for (std::size_t i = 0; i < size_; ++i) {
      const double factor = M.entry[i][k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < size_; ++j) {
        M.entry[i][j] -= factor * M.entry[k][j];
        inverse.entry[i][j] -= factor * inverse.entry[k][j];
      }
    }
  }
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      if (!std::isfinite(inverse.entry[i][j])) return false;
    }
  }
  return true;
}

bool EquilibriumBox::newton(Box& z) const {
  const SpanMatrix A = derivative(z);
  Matrix Y;
  if (!inverse_of_middle(A, Y)) return true;
  Box middle;
  for (std::size_t j = 0; j < size_; ++j) middle[j] = Span(z[j].middle());
  const Box f = residual(middle);
  for (std::size_t i = 0; i < size_; ++i) {
    Span sum(0), diagonal(0);
    for (std::size_t l = 0; l < size_; ++l) sum += Y.entry[i][l] * f[l];
    for (std::size_t j = 0; j < size_; ++j) {
      Span G(0);
      for (std::size_t l = 0; l < size_; ++l) {
        const Span& a = A.entry[l][j];
        if (a.low != 0 || a.high != 0) G += Y.entry[i][l] * a;
      }
      if (i == j)
        diagonal = G;
      else
        sum += G * (z[j] - middle[j]);
    }
    if (diagonal.contains(0)) continue;
    if (!bind(z[i], middle[i] - sum / diagonal)) return false;
  }
  return true;
}

std::optional<Midpoint> EquilibriumBox::root_near(const Box& z) const {
  Midpoint point;
  for (std::size_t j = 0; j < size_; ++j) point[j] = z[j].middle();
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 12; ++iteration) {
    Box at;
    for (std::size_t j = 0; j < size_; ++j) at[j] = Span(point[j]);
    Matrix Y;
    if (!inverse_of_middle(derivative(at), Y)) return std::nullopt;
    const Box f = residual(at);
    double size = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      double step = 0;
      for (std::size_t l = 0; l < size_; ++l) step += Y.entry[i][l] * f[l].middle();
      point[i] -= step;
      size = std::max(size, std::abs(step) * (i < n_ ? 1 : force_weight_));
    }
    if (!(size < 3)) return std::nullopt;
    if (size < 1e-13 || (size < 1e-9 && size >= last / 2)) return point;
    last = size;
  }
  return std::nullopt;
}

std::optional<Box> EquilibriumBox::isolate(const Midpoint& root) const {
  constexpr int halvings = 38;  // down to 1e-12
  for (int h = 0; h <= halvings; ++h) {
    const double radius = std::ldexp(0.4, -h);
    Box z;
    for (std::size_t j = 0; j < size_; ++j) {
      const double r = j < n_ ? radius : radius / force_weight_;
      z[j] = Span(root[j] - r, root[j] + r);
    }
    // one Newton step strictly into the box's inside proves that exactly one root lies in it
    Box image = z;
    if (!newton(image)) return std::nullopt;
    bool strictly = true;
    for (std::size_t j = 0; j < size_ && strictly; ++j)
      strictly = z[j].low < image[j].low && image[j].high < z[j].high;
    if (strictly) return z;
  }
  return std::nullopt;
}

std::size_t EquilibriumBox::widest(const Box& z) const {
  std::size_t best = 0;
  for (std::size_t j = 1; j < n_; ++j) {
    if (z[j].width() > z[best].width()) best = j;
  }
  return best;
}

}  // namespace plumbline::proofs
