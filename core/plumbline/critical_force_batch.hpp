#pragma once
/// \file
/// The lowest critical force of many small chains of equal n: eight chains at a time, one in each lane, on
/// all cores.

#include <plumbline/critical_force.hpp>
#include <thread>

namespace plumbline {

/// Chains of n links each, one after the other: entry i of chain c is element c n + i of both lists.
struct ChainBatch {
  std::size_t links;
  std::span<const double> length, stiffness;

  [[nodiscard]] std::size_t size() const { return length.size() / links; }
  /// \throws Error as Chain does
  [[nodiscard]] Chain<double> chain(std::size_t c) const {
    const auto entries = [&](std::span<const double> all) {
      const auto own = all.subspan(c * links, links);
      return std::vector<double>(own.begin(), own.end());
    };
    return Chain<double>(entries(length), entries(stiffness));
  }
};

/// The strings of eight chains side by side.
struct StringLanes {
  Scratch<Lanes> mass, spacing;
  Lanes slope, lower_bound;
  LaneBits plain;  ///< -1 where the data are in order and in range, and no joint but the first is passive

  /// \param chain  the chain in each lane
  StringLanes(const ChainBatch& batch, const std::array<std::size_t, lane_count>& chain)
      : mass(batch.links - 1), spacing(batch.links - 1) {
    const Lanes limit = all_lanes(std::ldexp(1.0, 120));
    const std::size_t n = batch.links;
    Lanes z{}, behind{}, total_mass{}, reach{};
    plain = ~LaneBits{};
    for (std::size_t i = n; i-- > 0;) {
      Lanes L, k;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        L[lane] = batch.length[chain[lane] * n + i];
        k[lane] = batch.stiffness[chain[lane] * n + i];
      }
      plain &= (L > 0.0) & (k >= 0.0) & (z + L < limit);
      behind = z;
      z += L;
      const Lanes stiffness = k / (z * z);
      if (i + 1 < n) {
        mass[i] = L / (z * behind);
        total_mass += mass[i];
        plain &= (mass[i] < limit) & (mass[i] > 1 / limit);
      }
      if (i > 0) {
        spacing[i - 1] = 1 / stiffness;
        reach += spacing[i - 1];
        plain &= (stiffness < limit) & (stiffness > 1 / limit);
      }
      slope = stiffness;
    }
    plain &= slope < limit;
    lower_bound = 0.5 / (total_mass * reach);  // as in all_of
  }
};

/// One run along eight strings, from the left.
inline Sweep<Lanes, 2, LaneBits> sweep(const StringLanes& strings, const Lanes& F) {
  StringState<Lanes, 2> state(all_lanes(1), strings.slope);
  LaneBits below{};
  for (std::size_t i = 0; i < strings.mass.size(); ++i) {
    const Lanes before = state.h[0];
    state.pass_bead(F * strings.mass[i]);
    state.pass_spacing(strings.spacing[i]);
    below -= sign_differs(before, state.h[0]);
  }
  return {{state.h[0], state.h[1], state.h[2]}, below};
}

/// The lowest root in each lane, approached from below by Laguerre's iteration, which does not overshoot; NaN
/// in lanes that are not plain or do not converge to it.
inline Lanes lowest_roots(const StringLanes& strings) {
  const auto N = static_cast<double>(strings.mass.size());
  constexpr double u = std::numeric_limits<double>::epsilon();
  Lanes x = strings.lower_bound;
  LaneBits open = strings.plain, failed = ~strings.plain;
  for (int run = 0; run < 20; ++run) {
    const auto at = sweep(strings, x);
    const Lanes inverse = 1 / at.f[0], G = at.f[1] * inverse, H = G * G - 2 * at.f[2] * inverse;
    const Lanes spread = larger((N - 1) * (N * H - G * G), Lanes{});
    Lanes root;
    for (std::size_t lane = 0; lane < lane_count; ++lane) root[lane] = std::sqrt(spread[lane]);
    // Rounding can put x a little beyond the root: then back.
    const Lanes step = at.f[0] == 0 ? Lanes{} : N / (at.below == 0 ? G - root : G + root);
    const Lanes size = magnitude(step), others = magnitude(G * step - 1);  // as in close_in
    x = open ? x - x * step : x;
    failed |= open & (at.below > 1);
    open &= (at.f[0] != 0) & ((others > 0.1) | (size * larger(size * size, others * others) > u / 8));
    LaneBits any = open & ~failed;
    std::int64_t left = 0;
    for (std::size_t lane = 0; lane < lane_count; ++lane) left |= any[lane];
    if (left == 0) break;
  }
  return (open | failed) ? all_lanes(std::numeric_limits<double>::quiet_NaN()) : x;
}

/// \throws Error as critical_forces(), with the number of the chain in front
inline double lowest_force_alone(const ChainBatch& batch, std::size_t c) {
  try {
    return critical_forces(batch.chain(c), 1)[0];
  } catch (const Error& error) {
    throw Error("chain " + std::to_string(c + 1) + ": " + error.what());
  }
}

/// The lowest critical forces of chains `first` to `end` - 1. A chain that the lanes do not settle is
/// computed alone, which also finds what is wrong with it.
inline void lowest_forces(const ChainBatch& batch, std::size_t first, std::size_t end,
                          std::span<double> forces) {
  for (std::size_t c = first; c < end; c += lane_count) {
    std::array<std::size_t, lane_count> chain;
    for (std::size_t lane = 0; lane < lane_count; ++lane) chain[lane] = std::min(c + lane, end - 1);
    const Lanes roots = lowest_roots(StringLanes(batch, chain));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      forces[chain[lane]] = std::isnan(roots[lane]) ? lowest_force_alone(batch, chain[lane]) : roots[lane];
    }
  }
}

/// The lowest critical force of each chain of a batch.
/// \param threads  at most so many at once
/// \throws Error for lists that are not whole chains, and for the first chain that critical_forces() refuses
inline std::vector<double> lowest_forces(const ChainBatch& batch,
                                         unsigned threads = std::thread::hardware_concurrency()) {
  if (batch.links < 2) throw Error("batch", "chains of fewer than two links", "two links or more");
  if (batch.length.size() % batch.links != 0 || batch.length.size() != batch.stiffness.size()) {
    throw Error("batch",
                std::to_string(batch.length.size()) + " lengths and " +
                    std::to_string(batch.stiffness.size()) + " stiffnesses",
                "as many, a multiple of " + std::to_string(batch.links));
  }
  std::vector<double> forces(batch.size());
  const std::size_t most = (batch.size() + 1023) / 1024;  // a thread is not worth it for fewer
  const std::size_t parts = std::max<std::size_t>(1, std::min<std::size_t>(threads, most));
  std::vector<std::exception_ptr> failures(parts);
  {
    std::vector<std::jthread> workers;
    for (std::size_t part = 0; part < parts; ++part) {
      const auto work = [&, part] {
        try {
          lowest_forces(batch, batch.size() * part / parts, batch.size() * (part + 1) / parts, forces);
        } catch (...) {
          failures[part] = std::current_exception();
        }
      };
      if (part + 1 < parts) {
        workers.emplace_back(work);
      } else {
        work();
      }
    }
  }
  for (const auto& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return forces;
}

}  // namespace plumbline
