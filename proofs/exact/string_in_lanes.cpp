#include "proofs/exact/string_in_lanes.hpp"

#include <plumbline/base/parallel.hpp>
#include <plumbline/base/widest.hpp>

namespace plumbline::proofs {
namespace {

using detail::Lanes, detail::lane_count, detail::Mask;
using Word = DoubleWord<double>;
using WordLanes = DoubleWord<Lanes>;

/// Masses and spacings, the largest of which is between 1/2 and 1, are not smaller, and forces between these.
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

struct Found {
  WordLanes end;
  Lanes slope, curvature;
  Mask<Lanes> below, sound;
};

Found run_along(const StringInWords& string, const ForcesInLanes& forces) {
  WordLanes h{detail::all_lanes(1), Lanes{}},
      g{detail::all_lanes(string.slope.high), detail::all_lanes(string.slope.low)};
  Lanes h1{}, h2{}, g1{}, g2{}, last = h.high;
  Mask<Lanes> below{}, sound = ~Mask<Lanes>{};
  const auto pass_bead = [&](const Word& mass) __attribute__((always_inline)) {
    const WordLanes push = mass * forces.minus_F;
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
    for (const std::size_t stop = std::min(i + forces.links, spacings); i < stop; ++i) {
      pass_bead(string.mass[i]);
      h2 += string.spacing[i].high * g2;
      h1 += string.spacing[i].high * g1;
      h = h + string.spacing[i] * g;
      sound &= within_range(h.high);
      note_sign(h.high);
    }
    const Lanes scale = detail::to_unit_scale(
        detail::larger(detail::magnitude(h.high), forces.unit * detail::magnitude(g.high)));
    for (Lanes* x : {&h.high, &h.low, &g.high, &g.low, &h1, &h2, &g1, &g2}) *x *= scale;
    sound &= within_range(h.high) & within_range(g.high);
  }
  if (string.free_end) {
    pass_bead(string.mass.back());
    note_sign(g.high);
  }
  return string.free_end ? Found{g, g1, g2, below, sound} : Found{h, h1, h2, below, sound};
}

/// A run for each of the forces from number `first` on that the lanes hold.
void run_few(const StringInWords& string, const std::vector<Wide>& forces, std::size_t first,
             std::vector<RunInLanes>& runs) {
  detail::in_widest([&] {
    const ForcesInLanes few(string, forces, first);
    const Found found = run_along(string, few);
    for (std::size_t lane = 0; lane < few.count; ++lane) {
      runs[first + lane] = {{found.end.high[lane], found.end.low[lane]},
                            found.slope[lane],
                            found.curvature[lane],
                            static_cast<std::size_t>(found.below[lane]),
                            few.in_range[lane] && found.sound[lane] != 0};
    }
  });
}

}  // namespace

StringInWords::StringInWords(const detail::StringPiece<Wide>& string) : free_end(string.free_end()) {
  mass_exponent = spacing_exponent = std::numeric_limits<long>::min();
  for (const Wide& x : string.mass) mass_exponent = std::max(mass_exponent, exponent_of(x));
  for (const Wide& x : string.spacing) spacing_exponent = std::max(spacing_exponent, exponent_of(x));
  if (string.spacing.empty()) spacing_exponent = string.slope == 0 ? 0 : -exponent_of(string.slope);
  const auto stored = [&](const Wide& x, long exponent) {
    const Word words = two_doubles(scaled(x, exponent));
    in_range = in_range && words.high > smallest_datum && words.high < 1 / smallest_datum;
    return words;
  };
  for (const Wide& x : string.mass) mass.push_back(stored(x, -mass_exponent));
  for (const Wide& x : string.spacing) spacing.push_back(stored(x, -spacing_exponent));
  if (string.slope != 0) slope = stored(string.slope, spacing_exponent);
  if (!free_end) end_slope = stored(string.end_slope(), spacing_exponent);
}

ForcesInLanes::ForcesInLanes(const StringInWords& string, const std::vector<Wide>& forces, std::size_t first)
    : count(std::min(lane_count, forces.size() - first)) {
  double most = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Wide& force = forces[first + std::min(lane, count - 1)];
    const Word F = two_doubles(scaled(force, string.mass_exponent + string.spacing_exponent));
    in_range[lane] = string.in_range && F.high > smallest_force && F.high < largest_force;
    minus_F.high[lane] = in_range[lane] ? -F.high : -1;
    minus_F.low[lane] = in_range[lane] ? -F.low : 0;
    unit[lane] = 1 / std::sqrt(-minus_F.high[lane]);
    most = std::max(most, -minus_F.high[lane]);
  }
  const double bits = 2 * std::log2(1 + std::sqrt(most));
  links = static_cast<std::size_t>(std::clamp(200 / (bits + 0.01), 1.0, 32.0));
}

unsigned threads_for(std::size_t forces, std::size_t beads) {
  constexpr std::size_t worth_a_thread = 1 << 14;
  return forces * beads < worth_a_thread ? 1 : available_threads();
}

std::vector<RunInLanes> run_in_lanes(const StringInWords& string, const std::vector<Wide>& forces) {
  std::vector<RunInLanes> runs(forces.size());
  in_parallel(groups_of(forces.size()), threads_for(forces.size(), string.mass.size()),
              [&](std::size_t group) { run_few(string, forces, group * lane_count, runs); });
  return runs;
}

}  // namespace plumbline::proofs
