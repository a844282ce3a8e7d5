#include "proofs/exact/shapes_in_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/parallel.hpp>
#include <plumbline/base/widest.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"

namespace plumbline::proofs {
namespace {

using detail::Lanes, detail::lane_count, detail::magnitude, detail::larger, detail::Mask;
using Word = DoubleWord<double>;
using WordLanes = DoubleWord<Lanes>;

/// At a bead of a run from one end; the true values are these times 2^exponent. Aligned for any lanes.
struct alignas(sizeof(Lanes)) AtBead {
  WordLanes deflection, slope;  ///< slope before the bead
  Lanes size, reach;            ///< of the terms that the slope and the deflection are the sums of
  Lanes doubt;                  ///< what rounding to doubles does here, in such sizes
  Lanes exponent;
};
using RunFromEnd = std::vector<AtBead>;

/// \param bead  maps 0, 1, … to the beads as they are met, and the spacings behind them
template <class Bead, class Spacing>
Mask<Lanes> run_from_end(const StringInWords& string, const Word& slope, const ForcesInLanes& forces,
                         const Bead& bead, const Spacing& spacing, RunFromEnd& run) {
  WordLanes h{detail::all_lanes(1), Lanes{}}, g{detail::all_lanes(slope.high), detail::all_lanes(slope.low)};
  Lanes rough_h = h.high, rough_g = g.high, size = g.high, reach = h.high, doubt{}, exponent{};
  Mask<Lanes> sound = ~Mask<Lanes>{};
  const std::size_t n = string.mass.size();
  for (std::size_t i = 0; i < n; ++i) {
    run[bead(i)] = {h, g, size, reach, doubt, exponent};
    if (i + 1 == n) break;
    const WordLanes push = string.mass[bead(i)] * forces.minus_F, term = push * h;
    size = larger(magnitude(g.high), magnitude(term.high));
    g = g + term;
    rough_g += string.mass[bead(i)].high * forces.minus_F.high * rough_h;
    const WordLanes rise = string.spacing[spacing(i)] * g;
    reach = larger(magnitude(h.high), magnitude(rise.high));
    h = h + rise;
    rough_h += string.spacing[spacing(i)].high * rough_g;
    doubt = larger(magnitude(Lanes(rough_g - g.high)) / size, magnitude(Lanes(rough_h - h.high)) / reach);
    sound &= within_range(h.high) & within_range(g.high);
    if ((i + 1) % forces.links != 0) continue;
    const Lanes scale = detail::to_unit_scale(larger(magnitude(h.high), forces.unit * magnitude(g.high)));
    for (Lanes* x : {&h.high, &h.low, &g.high, &g.low, &rough_h, &rough_g, &size, &reach}) *x *= scale;
    for (std::size_t lane = 0; lane < lane_count; ++lane) exponent[lane] -= std::ilogb(scale[lane]);
    sound &= within_range(h.high) & within_range(g.high);
  }
  return sound;
}

/// In one lane the bead at which the force that holds the two runs together, over the bead's mass, is
/// smallest. Over a product of the deflections at a bead, that force is the same at all beads.
std::size_t best_joint(const StringInWords& string, const RunFromEnd& left, const RunFromEnd& right,
                       std::size_t lane) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double product = left[i].deflection.high[lane] * right[i].deflection.high[lane];
    const double weight =
        std::log2(std::abs(product) * string.mass[i].high) + left[i].exponent[lane] + right[i].exponent[lane];
    if (weight > most) {
      most = weight;
      best = i;
    }
  }
  return best;
}

/// What rounding may do to two doubles where it does this to one.
constexpr double less_doubt = 0x1p-38;

/// A number, its relative error, and a power of two that it is to be multiplied by.
struct Angle {
  Word value{0, 0};
  double error = 0;
  int exponent = 0;
};

Wide wide(const Word& x) {
  return Wide(x.high) + x.low;
}

/// The nearest double, where that is certain.
std::optional<double> nearest(const Angle& angle) {
  const double high = angle.value.high, error = std::abs(high) * angle.error;
  if (!(angle.error < 0x1p-54)) return std::nullopt;
  if (high + (angle.value.low + error) != high || high + (angle.value.low - error) != high)
    return std::nullopt;
  const double result = std::scalbn(high, angle.exponent);
  if (std::abs(result) >= std::numeric_limits<double>::min()) return result;
  const Wide value = ldexp(wide(angle.value), angle.exponent), off = value * angle.error;
  const auto below = static_cast<double>(Wide(value - off)), above = static_cast<double>(Wide(value + off));
  return below == above ? std::optional(below) : std::nullopt;
}

/// x = words 2^exponent.
struct Scaled {
  Word words;
  int exponent;
  explicit Scaled(const Wide& x) {
    exponent = static_cast<int>(mpfr_get_exp(x.backend().data()));
    words = two_doubles(ldexp(x, -exponent));
  }
};

/// One part of a chain, and what turns slopes of its string into joint angles.
class Part {
 public:
  Part(const StraightChain<Wide>& straight, const detail::StringPiece<Wide>& piece)
      : joints_(straight.chain.size()), first_(piece.first), string_(piece) {
    const Chain<Wide>& chain = straight.chain;
    const std::vector<Wide> z = straight.arms();
    const std::size_t last = first_ + piece.size();
    for (std::size_t i = first_; i <= last; ++i) {
      // a passive joint turns by the jump of the deflection, which is in the string's own unit of it
      const Wide per_slope = chain.passive_joint(i) ? Wide(1 / z[i]) : Wide(z[i] / chain.stiffness()[i]);
      per_slope_.emplace_back(chain.passive_joint(i) ? per_slope
                                                     : Wide(ldexp(per_slope, -string_.spacing_exponent)));
      passive_.push_back(chain.passive_joint(i));
    }
    if (first_ == 0 && straight.end_point == EndPoint::guided) lateral_ = chain.stiffness()[0] / z[0];
  }
  [[nodiscard]] const StringInWords& string() const { return string_; }

  /// The mode in one lane; nothing where rounding leaves something open.
  [[nodiscard]] std::optional<ShapeInLanes> shape(const RunFromEnd& left, const RunFromEnd& right,
                                                  std::size_t joint, std::size_t lane) const {
    const auto angles = angles_of(left, right, joint, lane);
    if (!angles) return std::nullopt;
    ShapeInLanes shape{std::vector<double>(joints_, 0.0), std::string(joints_, '0'), 0};
    for (std::size_t i = 0; i < angles->size(); ++i) {
      const auto angle = nearest((*angles)[i]);
      if (!angle) return std::nullopt;
      shape.q[first_ + i] = *angle;
      shape.signs[first_ + i] = (*angles)[i].value.high < 0 ? '-' : '+';
    }
    const Angle& base = angles->front();
    const Rational fy = -exactly(Wide(lateral_ * ldexp(wide(base.value), base.exponent)));
    const Rational off = fy * exactly(Wide(base.error));
    constexpr int printed = 15;
    if (to_decimal(fy - off, printed) != to_decimal(fy + off, printed)) return std::nullopt;
    shape.fy = fy;
    return shape;
  }

 private:
  /// Of joint i of the part from the bead at its side, up to the factor that is the same on that side.
  [[nodiscard]] Angle turned(const AtBead& at, std::size_t i, std::size_t lane) const {
    const Word slope = passive_[i] ? Word{at.deflection.high[lane], at.deflection.low[lane]}
                                   : Word{at.slope.high[lane], at.slope.low[lane]};
    const double size = passive_[i] ? std::abs(slope.high) : at.size[lane];
    return {per_slope_[i].words * slope, size / std::abs(slope.high) * doubt(at, lane),
            static_cast<int>(at.exponent[lane]) + per_slope_[i].exponent};
  }

  /// What rounding to two doubles does to the terms at a bead, relatively; and to its deflection.
  static double doubt(const AtBead& at, std::size_t lane) {
    return std::max(at.doubt[lane], 0x1p-52) * less_doubt;
  }
  static double doubt_held(const AtBead& at, std::size_t lane) {
    return doubt(at, lane) * at.reach[lane] / std::abs(at.deflection.high[lane]);
  }

  [[nodiscard]] std::optional<std::vector<Angle>> angles_of(const RunFromEnd& left, const RunFromEnd& right,
                                                            std::size_t joint, std::size_t lane) const {
    const std::size_t beads = left.size();
    std::vector<Angle> angles(beads + 1);
    long double largest = 0;
    bool bent_to_the_left = false;
    const auto deflection = [&](const RunFromEnd& run) {
      return wide({run[joint].deflection.high[lane], run[joint].deflection.low[lane]});
    };
    const std::array<Wide, 2> held{deflection(left), Wide(-deflection(right))};
    const std::array<double, 2> exponent{left[joint].exponent[lane], right[joint].exponent[lane]};
    std::size_t at_largest = 0;
    for (std::size_t i = 0; i <= beads; ++i) {
      const std::size_t side = i <= joint ? 0 : 1;
      angles[i] = turned(side == 0 ? left[i] : right[i - 1], i, lane);
      angles[i].exponent -= static_cast<int>(exponent[side]);
      const long double size =
          std::abs(std::scalbn(static_cast<long double>(angles[i].value.high), angles[i].exponent) /
                   static_cast<long double>(held[side]));
      if (!(size <= std::numeric_limits<long double>::max())) return std::nullopt;
      if (size > largest) {
        largest = size;
        at_largest = i;
      }
    }
    bent_to_the_left = (angles[0].value.high < 0) != (held[0] < 0);
    const Angle& scale = angles[at_largest];
    const Wide magnitude = abs(ldexp(wide(scale.value), scale.exponent) / held[at_largest <= joint ? 0 : 1]);
    const double both = scale.error + doubt_held(left[joint], lane) + doubt_held(right[joint], lane);
    std::vector<Scaled> factor;
    for (const Wide& h : held) factor.emplace_back((bent_to_the_left ? -1 : 1) / (h * magnitude));
    for (std::size_t i = 0; i <= beads; ++i) {
      const Scaled& by = factor[i <= joint ? 0 : 1];
      angles[i].value = by.words * angles[i].value;
      angles[i].exponent += by.exponent;
      angles[i].error = 2 * (angles[i].error + both);
    }
    return angles;
  }

  std::size_t joints_, first_;
  StringInWords string_;
  std::vector<Scaled> per_slope_;
  std::vector<bool> passive_;
  Wide lateral_ = 0;  ///< of the base joint, where this part begins with it
};

/// The shapes of up to eight modes.
void shapes_of_few(const Part& part, const std::vector<Wide>& forces, std::size_t first,
                   std::vector<std::optional<ShapeInLanes>>& shapes) {
  const StringInWords& string = part.string();
  const std::size_t beads = string.mass.size();
  RunFromEnd left(beads), right(beads);
  const auto same = [](std::size_t i) { return i; };
  const auto mirrored = [&](std::size_t i) { return beads - 1 - i; };
  const auto before = [&](std::size_t i) { return beads - 2 - i; };
  std::array<bool, lane_count> sound{};
  detail::in_widest([&] {
    const ForcesInLanes few(string, forces, first);
    const Mask<Lanes> both = run_from_end(string, string.slope, few, same, same, left) &
                             run_from_end(string, string.end_slope, few, mirrored, before, right);
    for (std::size_t lane = 0; lane < few.count; ++lane) sound[lane] = few.in_range[lane] && both[lane] != 0;
  });
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (sound[lane])
      shapes[first + lane] = part.shape(left, right, best_joint(string, left, right, lane), lane);
  }
}

/// The forces once more from where they are: what is left is rounding.
std::vector<Wide> settled(const StringInWords& string, std::vector<Wide> forces) {
  const auto runs = run_in_lanes(string, forces);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = refined(forces[i], runs[i]);
  return forces;
}

}  // namespace

std::vector<std::optional<ShapeInLanes>> shapes_in_lanes(const StraightChain<Rational>& chain,
                                                         const std::vector<ForceInLanes>& forces) {
  const auto wide_chain = from_rational<Wide>(chain.chain);
  const StraightChain<Wide> straight(wide_chain, chain.end_point);
  const detail::BeadString<Wide> string(straight);
  const auto pieces = string.pieces();
  std::vector<std::optional<ShapeInLanes>> shapes(forces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::vector<std::size_t> mine;
    std::vector<Wide> values;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (forces[i].part != p) continue;
      mine.push_back(i);
      values.push_back(forces[i].value);
    }
    if (mine.empty()) continue;
    const Part part(straight, pieces[p]);
    values = settled(part.string(), std::move(values));
    std::vector<std::optional<ShapeInLanes>> found(mine.size());
    in_parallel(groups_of(mine.size()), threads_for(mine.size(), pieces[p].size()),
                [&](std::size_t group) { shapes_of_few(part, values, group * lane_count, found); });
    for (std::size_t i = 0; i < mine.size(); ++i) shapes[mine[i]] = std::move(found[i]);
  }
  return shapes;
}

}  // namespace plumbline::proofs
