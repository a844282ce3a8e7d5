#include "verify/chains/three_link_plane.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>

#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

/// Half the squared distance and its derivatives, the energy's derivatives, the curve g and its own.
struct PlaneValues {
  Interval half_square, r_a,
      r_b;  // (L_1^2 + L_2^2 + L_3^2)/2 + L_1 L_2 cos a + L_2 L_3 cos b + L_1 L_3 cos(a + b)
  Interval e_a, e_b;
  Interval g, g_a, g_b;
};

class Plane {
 public:
  Plane(const Chain<Interval>& chain, const Interval& nearest, const Interval& farthest)
      : chain_(chain), nearest_(nearest), farthest_(farthest) {}

  /// Adds the pieces of a box to a proof.
  void cover(const Interval& a, const Interval& b, int depth, PlaneProof& proof) const {
    ++proof.boxes;
    const PlaneValues here = values(a, b);
    if (outside(here.half_square) || !here.g.contains_zero()) return;
    // in the middle, and by the mean value theorem what the box can add to it
    const Interval a0(a.middle(), a.middle()), b0(b.middle(), b.middle());
    const PlaneValues middle = values(a0, b0);
    const Interval distance = middle.half_square + here.r_a * (a - a0) + here.r_b * (b - b0);
    const Interval g = middle.g + here.g_a * (a - a0) + here.g_b * (b - b0);
    if (outside(distance) || !g.contains_zero()) return;
    const Interval turned = here.g_a * here.r_b - here.g_b * here.r_a;
    const std::string signs{sign_character(a), sign_character(b)};
    const Interval slope = sqr(here.r_a) + sqr(here.r_b);
    constexpr double fine =
        1.0 / 16;  // radians: so that energies and forces of different shapes can be told apart
    const bool clear =
        !turned.contains_zero() && inside_window(a) && inside_window(b) && signs.find('0') == signs.npos;
    if (clear && certainly_positive(slope) && a.width() < fine && b.width() < fine) {
      // E is stationary at a given r: its gradient is the force times that of r
      const Interval square = Interval(2) * here.half_square;
      const Interval pull = sqrt(square) * (here.e_a * here.r_a + here.e_b * here.r_b) / slope;
      proof.pieces.push_back({signs, square, energy(a, b), -pull});
    } else if (depth == 0) {
      proof.whole = false;
    } else {
      for (const bool upper : {false, true}) {
        if (certainly_less(Interval(b.width(), b.width()), Interval(a.width(), a.width())))
          cover(half(a, upper), b, depth - 1, proof);
        else
          cover(a, half(b, upper), depth - 1, proof);
      }
    }
  }

 private:
  [[nodiscard]] static Interval half(const Interval& x, bool upper) {
    return upper ? Interval(x.middle(), x.upper()) : Interval(x.lower(), x.middle());
  }
  [[nodiscard]] static bool inside_window(const Interval& q) {
    return certainly_less(q, Interval::pi()) && certainly_less(-Interval::pi(), q);
  }
  [[nodiscard]] bool outside(const Interval& half_square) const {
    const Interval square = Interval(2) * half_square;
    return certainly_less(square, sqr(nearest_)) || certainly_less(sqr(farthest_), square);
  }
  [[nodiscard]] Interval energy(const Interval& a, const Interval& b) const {
    return (chain_.stiffness()[1] * sqr(a - chain_.rest()[1]) +
            chain_.stiffness()[2] * sqr(b - chain_.rest()[2])) /
           Interval(2);
  }

  [[nodiscard]] PlaneValues values(const Interval& a, const Interval& b) const {
    const std::vector<Interval>& L = chain_.length();
    const std::vector<Interval>& k = chain_.stiffness();
    const Interval ab = L[0] * L[1], bc = L[1] * L[2], ac = L[0] * L[2], both = a + b;
    const Interval c_a = ab * cos(a), c_b = bc * cos(b), c = ac * cos(both), s = ac * sin(both);
    PlaneValues v;
    v.half_square = (sqr(L[0]) + sqr(L[1]) + sqr(L[2])) / Interval(2) + c_a + c_b + c;
    v.r_a = -(ab * sin(a) + s), v.r_b = -(bc * sin(b) + s);
    v.e_a = k[1] * (a - chain_.rest()[1]), v.e_b = k[2] * (b - chain_.rest()[2]);
    v.g = v.e_a * v.r_b - v.e_b * v.r_a;
    v.g_a = k[1] * v.r_b - v.e_a * c + v.e_b * (c_a + c);
    v.g_b = -v.e_a * (c_b + c) - k[2] * v.r_a + v.e_b * c;
    return v;
  }

  const Chain<Interval>& chain_;
  Interval nearest_, farthest_;
};

/// A short decimal, as it was given.
std::string shown(const Interval& x) {
  return fmt::format("{:.6g}", static_cast<double>(x.middle()));
}

}  // namespace

std::string PlaneProof::text() const {
  return fmt::format(
      "at every deflection from {} to {} L: {} boxes cover the plane of both joint angles within half a "
      "turn; all "
      "equilibria are in {} of them, where the curve of equilibria crosses the lines of equal deflection, so "
      "that none "
      "begins, ends or changes its type, and no joint is straight",
      shown(from), shown(to), boxes, pieces.size());
}

bool PlaneProof::least(const std::string& signs, Interval PlanePiece::*what) const {
  if (!whole) return false;
  return std::all_of(pieces.begin(), pieces.end(), [&](const PlanePiece& one) {
    return one.signs != signs || std::all_of(pieces.begin(), pieces.end(), [&](const PlanePiece& other) {
             return other.signs == signs || certainly_less(one.distance, other.distance) ||
                    certainly_less(other.distance, one.distance) || certainly_less(one.*what, other.*what);
           });
  });
}

const PlaneProof& prove_in_plane(const HeldChain& held, const Rational& from, const Rational& to) {
  static std::map<std::string, PlaneProof> known;
  const std::string key = fmt::format("{} {} {}", key_of(held), from.str(), to.str());
  if (const auto found = known.find(key); found != known.end()) return found->second;
  PlaneProof proof{Interval(from), Interval(to), true, {}, 0};
  const Plane plane(held.chain, held.reach - Interval(to), held.reach - Interval(from));
  const Interval window = hull(-Interval::pi(), Interval::pi());
  constexpr int most_halvings = 60;
  plane.cover(window, window, most_halvings, proof);
  return known.emplace(key, std::move(proof)).first->second;
}

}  // namespace plumbline::verify
