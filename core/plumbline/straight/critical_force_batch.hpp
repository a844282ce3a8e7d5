#pragma once
/// \file
/// The lowest critical force of many small chains of equal n: eight chains at a time, one in each lane, on
/// all cores.
///
/// \code{.cpp}
/// const std::vector<double> length{1, 1, 1, 2}, stiffness{0, 1, 0, 1};  // two chains of two links
/// const std::vector<double> forces = lowest_forces(ChainBatch{2, length, stiffness});
/// assert(std::abs(forces[0] - 2) < 1e-15 && std::abs(forces[1] - 1.5) < 1e-15);
/// \endcode

#include <plumbline/base/parallel.hpp>
#include <plumbline/straight/critical_force.hpp>

namespace plumbline {

/// Chains of n links each, one after the other: entry i of chain c is element c n + i of both lists.
struct ChainBatch {
  std::size_t links;                  ///< n, of every chain
  std::span<const double> length;     ///< of all links
  std::span<const double> stiffness;  ///< of all joints

  /// Number of chains.
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

namespace detail {

/// The strings of eight chains side by side.
class StringLanes {
 public:
  /// \param chain  the chain in each lane
  StringLanes(const ChainBatch& batch, const std::array<std::size_t, lane_count>& chain)
      : mass_(batch.links - 1), spacing_(batch.links), plain_(~Mask<Lanes>{}) {
    const Lanes limit = all_lanes(std::ldexp(1.0, 120)), huge = all_lanes(std::ldexp(1.0, 500));
    const std::size_t n = batch.links;
    const auto within = [](const Lanes& x, const Lanes& bound) { return (x < bound) & (x > 1 / bound); };
    Lanes z{}, behind{};
    for (std::size_t i = n; i-- > 0; behind = z) {
      Lanes L, k;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        L[lane] = batch.length[chain[lane] * n + i];
        k[lane] = batch.stiffness[chain[lane] * n + i];
      }
      z += L;
      plain_ &= (L > 0.0) & (k >= 0.0) & (z < huge);
      if (i + 1 == n) {
        spacing_[i] = z * z / k;
      } else {
        const auto elastic = i == 0 ? k > 0 : ~Mask<Lanes>{};
        const JointAndLink<Lanes> joint(L, elastic ? k : 1, z, behind);
        mass_[i] = joint.mass;
        spacing_[i] = elastic ? joint.spacing : std::numeric_limits<double>::infinity();
        plain_ &= within(joint.mass, limit) & within(joint.inverse, huge);
      }
      plain_ &= i == 0 ? spacing_[i] > 1 / limit : within(spacing_[i], limit);
    }
  }
  [[nodiscard]] StringPiece<Lanes> piece() const {
    return {
        0,      {mass_.begin(), mass_.size()}, {spacing_.begin() + 1, mass_.size()}, 1 / spacing_[0], Lanes{},
        Lanes{}};
  }
  /// -1 where the data are in order and in range, and no joint but the first is passive.
  [[nodiscard]] const Mask<Lanes>& plain() const { return plain_; }

 private:
  Scratch<Lanes> mass_, spacing_;
  Mask<Lanes> plain_;
};

/// \throws Error as critical_forces(), with the number of the chain in front
inline double lowest_force_alone(const ChainBatch& batch, std::size_t c) {
  try {
    return lowest_critical_force(batch.chain(c));
  } catch (const Error& error) {
    throw Error("chain " + std::to_string(c + 1) + ": " + error.what());
  }
}

/// The lowest critical force of the chain in each lane; NaN where the lanes do not settle it.
inline std::array<double, lane_count> lowest_in_lanes(const ChainBatch& batch,
                                                      const std::array<std::size_t, lane_count>& chain) {
  return in_widest([&] {
    const StringLanes strings(batch, chain);
    const auto piece = strings.piece();
    const auto run = [&](const Lanes& F) { return sweep<3>(piece, std::array{F}, SafeStretch<double>())[0]; };
    const Lanes roots = lowest_root(run, close_to_lowest(piece), static_cast<double>(piece.size()),
                                    std::numeric_limits<double>::epsilon() / 8);
    std::array<double, lane_count> forces;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      forces[lane] = strings.plain()[lane] != 0 ? roots[lane] : std::numeric_limits<double>::quiet_NaN();
    }
    return forces;
  });
}

/// The lowest critical forces of chains `first` to `end` - 1. A chain that the lanes do not settle is
/// computed alone, which also finds what is wrong with it.
inline void lowest_forces(const ChainBatch& batch, std::size_t first, std::size_t end,
                          std::span<double> forces) {
  for (std::size_t c = first; c < end; c += lane_count) {
    std::array<std::size_t, lane_count> chain;
    for (std::size_t lane = 0; lane < lane_count; ++lane) chain[lane] = std::min(c + lane, end - 1);
    const auto lowest = lowest_in_lanes(batch, chain);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      forces[chain[lane]] = std::isnan(lowest[lane]) ? lowest_force_alone(batch, chain[lane]) : lowest[lane];
    }
  }
}

}  // namespace detail

/// The lowest critical force of each chain of a batch.
/// \param threads  at most so many at once
/// \throws Error for lists that are not whole chains, and for the first chain that critical_forces() refuses
inline std::vector<double> lowest_forces(const ChainBatch& batch, unsigned threads = available_threads()) {
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
  in_parallel(parts, threads, [&](std::size_t part) {
    detail::lowest_forces(batch, batch.size() * part / parts, batch.size() * (part + 1) / parts, forces);
  });
  return forces;
}

}  // namespace plumbline
