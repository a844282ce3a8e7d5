#pragma once
/// \file
/// The straight chain under compression as a taut string with beads (proofs/theorems.md, theorem
/// "Recursion").
///
/// In h_i = z_1 q_1 + … + z_i q_i and g_i = k_i q_i / z_i, z_i = L_i + … + L_n, equations (29) and (30) read
///
///     g_{i+1} = g_i - F m_i h_i,   h_{i+1} = h_i + r_{i+1} g_{i+1},   h_0 = h_n = 0,
///
/// with m_i = L_i / (z_i z_{i+1}) and r_i = z_i^2 / k_i. That is a string of n - 1 beads of mass m_i, spaced
/// r_i apart and fixed at both ends: h is its deflection, g its slope, and the critical forces are the
/// squares of its frequencies. A passive joint is an infinite spacing: it cuts the string and leaves free
/// ends.

#include <cmath>
#include <plumbline/chain.hpp>
#include <plumbline/lanes.hpp>
#include <plumbline/scratch.hpp>
#include <span>

namespace plumbline {

/// A piece of the string between cuts. All its frequencies are simple.
template <Number Real>
struct StringPiece {
  std::size_t first;                   ///< the joint (from 0) at its left end, whose link is its first bead
  std::span<const Real> mass;          ///< one a bead
  std::span<const Real> spacing;       ///< behind each bead; at a free right end there is one fewer
  Real slope;                          ///< before the first bead where that has deflection 1; 0 at a free end
  Real largest_mass, largest_spacing;  ///< bounds that hold for all pieces

  [[nodiscard]] std::size_t size() const { return mass.size(); }
  [[nodiscard]] bool free_end() const { return spacing.size() < mass.size(); }
  /// The same at the other end: slope behind the last bead, away from it.
  [[nodiscard]] Real end_slope() const { return free_end() ? Real(0) : Real(Real(1) / spacing.back()); }
};

/// The string of a chain.
template <Number Real>
class BeadString {
 public:
  /// \throws Error for n = 1 or a mechanism
  explicit BeadString(const Chain<Real>& chain)
      : chain_(chain), mass_(mode_count(chain)), spacing_(chain.size()) {
    if constexpr (std::same_as<Real, double>) {
      hang_in_lanes();
    } else {
      hang();
    }
  }
  BeadString(const BeadString&) = delete;  // pieces look into it
  BeadString& operator=(const BeadString&) = delete;

  /// Whether masses and spacings leave a floating-point type enough of its range for the run along them.
  [[nodiscard]] bool in_range() const {
    const Real limit = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent / 8);
    return largest_mass_ < limit && largest_spacing_ < limit && smallest_ > 1 / limit;
  }

  /// One piece, or two where an interior joint is passive.
  [[nodiscard]] std::vector<StringPiece<Real>> pieces() const {
    std::vector<StringPiece<Real>> result;
    const std::span<const Real> mass(mass_), spacing(spacing_);
    for (std::size_t first = 0, end = 1; first < mass.size(); first = end++) {
      while (end < mass.size() && !chain_.passive_joint(end)) ++end;
      const std::size_t spacings = end - first - (chain_.passive_joint(end) ? 1 : 0);
      result.push_back({first, mass.subspan(first, end - first), spacing.subspan(first + 1, spacings),
                        chain_.passive_joint(first) ? Real(0) : Real(Real(1) / spacing[first]), largest_mass_,
                        largest_spacing_});
    }
    return result;
  }

 private:
  void hang() {
    const std::vector<Real> z = distance_to_end(chain_);
    for (std::size_t i = 0; i < z.size(); ++i) {
      spacing_[i] = chain_.passive_joint(i) ? Real(0) : Real(z[i] / chain_.stiffness()[i] * z[i]);
      if (i < mass_.size()) mass_[i] = chain_.length()[i] / z[i] / z[i + 1];
    }
    if constexpr (Ordered<Real>) {
      largest_mass_ = *std::max_element(mass_.begin(), mass_.end());
      largest_spacing_ = *std::max_element(spacing_.begin(), spacing_.end());
    }
  }

  /// The same from the end point to the base, eight links at a time. The distance is summed with its rounding
  /// errors (Knuth), so that it is as good as exact for a million links.
  void hang_in_lanes() {
    const double *const L = chain_.length().data(), *const k = chain_.stiffness().data();
    double z = 0, lost = 0;
    const auto lengthen = [&](double by) {
      const double sum = z + by, part = sum - z;
      lost += (z - (sum - part)) + (by - part);
      z = sum;
    };
    const std::size_t n = chain_.size(), whole = (n - 1) / lane_count * lane_count;
    double behind = 0;
    Lanes largest_mass{}, largest_spacing{}, smallest = all_lanes(1);
    for (std::size_t i = n; i-- > whole;) {
      lengthen(L[i]);
      const double here = z + lost;
      spacing_[i] = k[i] > 0 ? here / k[i] * here : 0;
      if (i + 1 < n) mass_[i] = L[i] / here / behind;
      behind = here;
    }
    for (std::size_t i = whole; i > 0;) {
      i -= lane_count;
      Lanes length, stiffness;
      __builtin_memcpy(&length, L + i, sizeof length);
      __builtin_memcpy(&stiffness, k + i, sizeof stiffness);
      const Lanes sums = suffix_sums(length);
      const Lanes here = z + (lost + sums);
      const Lanes next = __builtin_shufflevector(here, all_lanes(behind), 1, 2, 3, 4, 5, 6, 7, 8);
      const Lanes spacing = stiffness > 0 ? here * here / stiffness : 0, mass = length / (here * next);
      largest_mass = larger(largest_mass, mass);
      largest_spacing = larger(largest_spacing, spacing);
      smallest = smaller(smallest, smaller(mass, stiffness > 0 ? spacing : mass));
      __builtin_memcpy(&spacing_[i], &spacing, sizeof spacing);
      __builtin_memcpy(&mass_[i], &mass, sizeof mass);
      lengthen(sums[0]);
      behind = here[0];
    }
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      largest_mass_ = std::max(largest_mass_, largest_mass[lane]);
      largest_spacing_ = std::max(largest_spacing_, largest_spacing[lane]);
      smallest_ = std::min(smallest_, smallest[lane]);
    }
    for (std::size_t i = whole; i < n; ++i) {
      largest_spacing_ = std::max(largest_spacing_, spacing_[i]);
      if (k[i] > 0) smallest_ = std::min(smallest_, spacing_[i]);
      if (i + 1 == n) break;
      largest_mass_ = std::max(largest_mass_, mass_[i]);
      smallest_ = std::min(smallest_, mass_[i]);
    }
  }

  const Chain<Real>& chain_;
  Scratch<Real> mass_, spacing_;
  Real largest_mass_{0}, largest_spacing_{0}, smallest_{1};  // the last for double only
};

}  // namespace plumbline
