#pragma once
/// \file
/// The straight chain under compression as a taut string with beads (proofs/theorems.md, theorem
/// "Recursion").
///
/// In h_i = z_1 q_1 + … + z_i q_i and g_i = k_i q_i / z_i, z_i = L_i + … + L_n, equations (29) and (30) read
///
///     g_{i+1} = g_i - F m_i h_i,   h_{i+1} = h_i + r_{i+1} g_{i+1},   h_0 = h_n = 0,
///
/// with m_i = L_i / (z_i z_{i+1}) and r_i = z_i^2 / k_i, where the end point is guided; where it is free,
/// straight_chain.hpp says with what. That is a string of n - 1 beads of mass m_i, spaced
/// r_i apart and fixed at both ends: h is its deflection, g its slope, and the critical forces are the
/// squares of its frequencies. A passive joint is an infinite spacing: it cuts the string and leaves free
/// ends.

#include <cmath>
#include <plumbline/base/lanes.hpp>
#include <plumbline/base/scratch.hpp>
#include <plumbline/base/widest.hpp>
#include <plumbline/straight/straight_chain.hpp>
#include <span>

namespace plumbline::detail {

/// A piece of the string between cuts. All its frequencies are simple. With T = Lanes, pieces of eight
/// chains.
template <class T>
struct StringPiece {
  std::size_t first = 0;            ///< the joint (from 0) at its left end, whose link is its first bead
  std::span<const T> mass = {};     ///< one a bead
  std::span<const T> spacing = {};  ///< behind each bead; at a free right end there is one fewer
  T slope = {};                     ///< before the first bead where that has deflection 1; 0 at a free end
  T largest_mass = {}, largest_spacing = {};  ///< bounds that hold for all pieces

  [[nodiscard]] std::size_t size() const { return mass.size(); }
  /// Of the polynomial whose roots are the critical forces.
  [[nodiscard]] std::size_t degree() const { return mass.size(); }
  [[nodiscard]] bool free_end() const { return spacing.size() < mass.size(); }
  /// The same at the other end: slope behind the last bead, away from it.
  [[nodiscard]] T end_slope() const { return free_end() ? T(0) : T(T(1) / spacing.back()); }
};

/// One piece, or two where an interior joint is passive.
template <class T>
class StringPieces {
 public:
  void add(const StringPiece<T>& piece) { pieces_[count_++] = piece; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const StringPiece<T>* begin() const { return pieces_.data(); }
  [[nodiscard]] const StringPiece<T>* end() const { return pieces_.data() + count_; }
  const StringPiece<T>& operator[](std::size_t i) const { return pieces_[i]; }

 private:
  std::array<StringPiece<T>, 2> pieces_;
  std::size_t count_ = 0;
};

/// What an elastic joint and its link contribute, and what shows that nothing left the range of double on the
/// way. One division does for both: it costs as much as all the rest.
template <class T>
struct JointAndLink {
  T mass, spacing, inverse;

  /// \param z  distance to the end point; behind: of the next joint
  JointAndLink(const T& L, const T& k, const T& z, const T& behind) {
    const T product = z * behind;
    inverse = 1 / (product * k);
    mass = L * k * inverse;
    spacing = product * inverse * z * z;
  }
};

/// The string of a chain.
template <Number Real>
class BeadString {
 public:
  /// \throws Error for n = 1 or a mechanism
  explicit BeadString(const StraightChain<Real>& straight)
      : chain_(straight.chain), mass_(mode_count(chain_)), spacing_(chain_.size()) {
    if (straight.end_point == EndPoint::free) {
      hang_level();
    } else if constexpr (std::same_as<Real, double>) {
      in_widest([&] { hang_in_lanes(); });
    } else {
      hang();
    }
  }
  explicit BeadString(const Chain<Real>& chain) : BeadString(StraightChain<Real>(chain)) {}
  BeadString(const BeadString&) = delete;  // pieces look into it
  BeadString& operator=(const BeadString&) = delete;

  /// Whether masses and spacings leave a floating-point type enough of its range for the run along them.
  [[nodiscard]] bool in_range() const {
    const Real limit = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent / 8);
    return largest_mass_ < limit && largest_spacing_ < limit && smallest_ > 1 / limit && normal_;
  }

  /// The parts that interior passive joints cut the string into; one or two.
  [[nodiscard]] StringPieces<Real> pieces() const {
    StringPieces<Real> result;
    const std::span<const Real> mass(mass_.begin(), mass_.size()), spacing(spacing_.begin(), spacing_.size());
    for (std::size_t first = 0, end = 1; first < mass.size(); first = end++) {
      while (end < mass.size() && !chain_.passive_joint(end)) ++end;
      const std::size_t spacings = end - first - (chain_.passive_joint(end) ? 1 : 0);
      result.add({first, mass.subspan(first, end - first), spacing.subspan(first + 1, spacings),
                  chain_.passive_joint(first) ? Real(0) : Real(Real(1) / spacing[first]), largest_mass_,
                  largest_spacing_});
    }
    return result;
  }

 private:
  void hang() {
    const auto& L = chain_.length();
    Real z(0), behind(0);
    for (std::size_t i = chain_.size(); i-- > 0; behind = z) {
      z += L[i];
      if (chain_.passive_joint(i)) {
        spacing_[i] = Real(0);
      } else {
        spacing_[i] = z;
        spacing_[i] *= z;
        spacing_[i] /= chain_.stiffness()[i];
      }
      if (i == mass_.size()) continue;
      behind *= z;
      mass_[i] = L[i];
      mass_[i] /= behind;
    }
    note_all();
  }

  /// With arms of one.
  void hang_level() {
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (i < mass_.size()) mass_[i] = chain_.length()[i];
      spacing_[i] = chain_.passive_joint(i) ? Real(0) : Real(Real(1) / chain_.stiffness()[i]);
    }
    note_all();
  }

  void note_all() {
    if constexpr (std::floating_point<Real>) {
      for (std::size_t i = 0; i < spacing_.size(); ++i) {
        note(i < mass_.size() ? mass_[i] : Real(1), spacing_[i], !chain_.passive_joint(i));
      }
    }
  }

  void note(const Real& mass, const Real& spacing, bool elastic) {
    largest_mass_ = larger(largest_mass_, mass);
    largest_spacing_ = larger(largest_spacing_, spacing);
    smallest_ = smaller(smallest_, elastic ? smaller(mass, spacing) : mass);
  }

  /// The same from the end point to the base, eight links at a time. The distance is summed with its rounding
  /// errors (Knuth), so that it is as good as exact for a million links.
  void hang_in_lanes() {
    const double *const L = chain_.length().data(), *const k = chain_.stiffness().data();
    double z = 0, lost = 0, behind = 0;
    const auto lengthen = [&](double by) {
      const double sum = z + by, part = sum - z;
      lost += (z - (sum - part)) + (by - part);
      z = sum;
    };
    const double huge = std::ldexp(1.0, 500);
    const std::size_t n = chain_.size(), whole = (n - 1) / lane_count * lane_count;
    for (std::size_t i = n; i-- > whole;) {
      lengthen(L[i]);
      const double here = z + lost;
      const bool elastic = k[i] > 0;
      if (i + 1 == n) {
        spacing_[i] = elastic ? here / k[i] * here : 0;
        note(1, spacing_[i], elastic);
      } else {
        const JointAndLink<double> joint(L[i], elastic ? k[i] : 1, here, behind);
        spacing_[i] = elastic ? joint.spacing : 0;
        mass_[i] = joint.mass;
        normal_ = normal_ && joint.inverse < huge && joint.inverse > 1 / huge;
        note(mass_[i], spacing_[i], elastic);
      }
      behind = here;
    }
    Lanes largest_mass{}, largest_spacing{}, smallest = all_lanes(1);
    Mask<Lanes> normal = ~Mask<Lanes>{};
    for (std::size_t i = whole; i > 0;) {
      i -= lane_count;
      Lanes length, stiffness;
      __builtin_memcpy(&length, L + i, sizeof length);
      __builtin_memcpy(&stiffness, k + i, sizeof stiffness);
      const Lanes sums = suffix_sums(length);
      const Lanes here = z + (lost + sums);
      const Lanes next = __builtin_shufflevector(here, all_lanes(behind), 1, 2, 3, 4, 5, 6, 7, 8);
      const auto elastic = stiffness > 0;
      const JointAndLink<Lanes> joint(length, elastic ? stiffness : 1, here, next);
      const Lanes spacing = elastic ? joint.spacing : 0;
      largest_mass = larger(largest_mass, joint.mass);
      largest_spacing = larger(largest_spacing, spacing);
      smallest = smaller(smallest, smaller(joint.mass, elastic ? spacing : joint.mass));
      normal &= (joint.inverse < huge) & (joint.inverse > 1 / huge);
      __builtin_memcpy(&spacing_[i], &spacing, sizeof spacing);
      __builtin_memcpy(&mass_[i], &joint.mass, sizeof joint.mass);
      lengthen(sums[0]);
      behind = here[0];
    }
    if (whole == 0) return;
    normal_ = normal_ && !any(~normal);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      note(largest_mass[lane], largest_spacing[lane], false);
      smallest_ = smaller(smallest_, smallest[lane]);
    }
  }

  const Chain<Real>& chain_;
  Scratch<Real> mass_, spacing_;
  Real largest_mass_{0}, largest_spacing_{0}, smallest_{1};  // for machine types only
  bool normal_ = true;
};

}  // namespace plumbline::detail
