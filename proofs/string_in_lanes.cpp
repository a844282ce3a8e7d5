#include "proofs/string_in_lanes.hpp"

#include <plumbline/base/parallel.hpp>

namespace plumbline::proofs {
namespace {

using detail::Lanes, detail::lane_count, detail::Mask;
using Word = DoubleWord<double>;
using WordLanes = DoubleWord<Lanes>;

/// Numbers on the way are between these, or the run says that it is not sound: then no product of two halves
/// overflows, and what underflows is less than 2^-100 of what it is added to.
constexpr double smallest = 0x1p-800, largest = 0x1p800;
/// The same for masses and spacings, the largest of which is between 1/2 and 1, and for forces.
constexpr double smallest_datum = 0x1p-300, smallest_force = 0x1p-400, largest_force = 0x1p400;

/// Exponent of the power of two above x.
long exponent_of(const Wide& x) {
  return mpfr_get_exp(x.backend().data());
}
Wide scaled(const Wide& x, long exponent) {
  Wide result;
  mpfr_mul_2si(result.backend().data(), x.backend().data(), exponent, MPFR_RNDN);
  return result;
}

struct Strings {
  const std::vector<Word>&mass, &spacing;
  Word slope;
  bool free_end;
};
struct RunInLanes {
  WordLanes end;
  Lanes slope, curvature;
  Mask<Lanes> below, sound;
};

[[gnu::always_inline]] inline Mask<Lanes> within_range(const Lanes& x) {
  const Lanes size = detail::magnitude(x);
  return (size > smallest) & (size < largest);
}

/// \param minus_F  with the opposite sign, in the units of the string
/// \param links    after which to rescale
void run_along(const Strings& string, const WordLanes& minus_F, const Lanes& unit, std::size_t links,
               RunInLanes& result) {
  WordLanes h{detail::all_lanes(1), Lanes{}},
      g{detail::all_lanes(string.slope.high), detail::all_lanes(string.slope.low)};
  Lanes h1{}, h2{}, g1{}, g2{}, last = h.high;
  Mask<Lanes> below{}, sound = ~Mask<Lanes>{};
  const auto pass_bead = [&](const Word& mass) __attribute__((always_inline)) {
    const WordLanes push = mass * minus_F;
    g2 += push.high * (h2 + h1);
    g1 += push.high * (h1 + h.high);
    g = g + push * h;
    sound &= within_range(g.high);
  };
  const auto note_sign = [&](const Lanes& now) __attribute__((always_inline)) {
    below -= detail::sign_differs(last, now);
    last = now;
  };
  const std::size_t spacings = string.spacing.size();
  for (std::size_t i = 0; i < spacings;) {
    for (const std::size_t stop = std::min(i + links, spacings); i < stop; ++i) {
      pass_bead(string.mass[i]);
      h2 += string.spacing[i].high * g2;
      h1 += string.spacing[i].high * g1;
      h = h + string.spacing[i] * g;
      sound &= within_range(h.high);
      note_sign(h.high);
    }
    const Lanes scale =
        detail::to_unit_scale(detail::larger(detail::magnitude(h.high), unit * detail::magnitude(g.high)));
    for (Lanes* x : {&h.high, &h.low, &g.high, &g.low, &h1, &h2, &g1, &g2}) *x *= scale;
    sound &= within_range(h.high) & within_range(g.high);
  }
  if (string.free_end) {
    pass_bead(string.mass.back());
    note_sign(g.high);
  }
  result = string.free_end ? RunInLanes{g, g1, g2, below, sound} : RunInLanes{h, h1, h2, below, sound};
}

}  // namespace

StringInLanes::StringInLanes(const detail::StringPiece<Wide>& string) : free_end_(string.free_end()) {
  long mass = std::numeric_limits<long>::min(), spacing = mass;
  for (const Wide& x : string.mass) mass = std::max(mass, exponent_of(x));
  for (const Wide& x : string.spacing) spacing = std::max(spacing, exponent_of(x));
  if (string.spacing.empty()) spacing = string.slope == 0 ? 0 : -exponent_of(string.slope);
  const auto stored = [&](const Wide& x, long exponent) {
    const Word words = two_doubles(scaled(x, exponent));
    in_range_ = in_range_ && words.high > smallest_datum && words.high < 1 / smallest_datum;
    return words;
  };
  for (const Wide& x : string.mass) mass_.push_back(stored(x, -mass));
  for (const Wide& x : string.spacing) spacing_.push_back(stored(x, -spacing));
  if (string.slope != 0) slope_ = stored(string.slope, spacing);
  exponent_ = mass + spacing;
}

std::vector<StringInLanes::Run> StringInLanes::run(const std::vector<Wide>& forces) const {
  std::vector<Run> runs(forces.size());
  const Strings string{mass_, spacing_, slope_, free_end_};
  const auto few = [&](std::size_t group) {
    const std::size_t first = group * lane_count, count = std::min(lane_count, forces.size() - first);
    WordLanes minus_F;
    Lanes unit;
    double most = 0;
    std::array<bool, lane_count> in_range;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const Word F = two_doubles(scaled(forces[first + std::min(lane, count - 1)], exponent_));
      in_range[lane] = in_range_ && F.high > smallest_force && F.high < largest_force;
      minus_F.high[lane] = in_range[lane] ? -F.high : -1;
      minus_F.low[lane] = in_range[lane] ? -F.low : 0;
      unit[lane] = 1 / std::sqrt(-minus_F.high[lane]);
      most = std::max(most, -minus_F.high[lane]);
    }
    // Measured in max(|h|, unit |g|), a link multiplies by no more than (1 + sqrt(F m r))^2.
    const double bits = 2 * std::log2(1 + std::sqrt(most));
    RunInLanes found;
    run_along(string, minus_F, unit, static_cast<std::size_t>(std::clamp(200 / (bits + 0.01), 1.0, 32.0)),
              found);
    for (std::size_t lane = 0; lane < count; ++lane) {
      runs[first + lane] = {{found.end.high[lane], found.end.low[lane]},
                            found.slope[lane],
                            found.curvature[lane],
                            static_cast<std::size_t>(found.below[lane]),
                            in_range[lane] && found.sound[lane] != 0};
    }
  };
  const std::size_t groups = (forces.size() + lane_count - 1) / lane_count;
  constexpr std::size_t worth_a_thread = 1 << 14;
  const bool alone = forces.size() * mass_.size() < worth_a_thread;
  in_parallel(groups, alone ? 1 : std::thread::hardware_concurrency(), few);
  return runs;
}

}  // namespace plumbline::proofs
