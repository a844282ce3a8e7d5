#include "proofs/rod/inertia_of_rod.hpp"

#include <optional>

#include "proofs/rod/series.hpp"

namespace plumbline::proofs {
namespace {

constexpr std::size_t most_pieces = 20000;

/// Forces at the ends of a piece by w and θ there: of the first end, mixed, of the second.
struct PieceBlock {
  Interval ww, wt, tw, tt;
};
struct PieceStiffness {
  PieceBlock first, mixed, second;
};

/// Of the 2 x 2 matrix m, whose determinant is not zero for a piece that is stable when clamped.
PieceBlock inverse_of(const PieceBlock& m) {
  const Interval determinant = m.ww * m.tt - m.wt * m.tw;
  return {m.tt / determinant, -m.wt / determinant, -m.tw / determinant, m.ww / determinant};
}

PieceBlock product(const PieceBlock& a, const PieceBlock& b) {
  return {a.ww * b.ww + a.wt * b.tw, a.ww * b.wt + a.wt * b.tt, a.tw * b.ww + a.tt * b.tw,
          a.tw * b.wt + a.tt * b.tt};
}

PieceBlock sum(const PieceBlock& a, const PieceBlock& b) {
  return {a.ww + b.ww, a.wt + b.wt, a.tw + b.tw, a.tt + b.tt};
}

PieceBlock difference(const PieceBlock& a, const PieceBlock& b) {
  return {a.ww - b.ww, a.wt - b.wt, a.tw - b.tw, a.tt - b.tt};
}

PieceBlock transposed(const PieceBlock& m) {
  return {m.ww, m.tw, m.wt, m.tt};
}

/// The piece's second end is A (w, θ) + B (M, V) of its first; the form takes +V w - M θ from the first end
/// and -V w + M θ from the second.
PieceStiffness stiffness(const Rational& length, const RodEquation<Interval>& equation) {
  std::array<RodState<Interval>, 4> from;  // a start of 1 in w, θ, M, V
  for (std::size_t unit = 0; unit < 4; ++unit) {
    RodState<Interval> state;
    state[unit] = Interval(1);
    from[unit] = carried(state, length, equation);
  }
  const auto part = [&](std::size_t row, std::size_t column) {
    return PieceBlock{from[column][row], from[column + 1][row], from[column][row + 1],
                      from[column + 1][row + 1]};
  };
  // (M, V) at the first end by the deflections of the second and of the first
  const PieceBlock by_second = inverse_of(part(0, 2)), by_first = product(by_second, part(0, 0));
  // (M, V) at the second end by the deflections of the second
  const PieceBlock beyond = product(part(2, 2), by_second);
  return {{-by_first.tw, -by_first.tt, by_first.ww, by_first.wt},
          {by_second.tw, by_second.tt, -by_second.ww, -by_second.wt},
          {-beyond.tw, -beyond.tt, beyond.ww, beyond.wt}};
}

/// Negative eigenvalues of a symmetric 2 x 2 matrix.
std::size_t negative_of(const PieceBlock& m) {
  const Interval determinant = m.ww * m.tt - sqr(m.wt);
  if (certainly_negative(determinant)) return 1;
  if (certainly_positive(determinant)) {
    if (certainly_positive(m.ww) || certainly_positive(m.tt)) return 0;
    if (certainly_negative(m.ww) || certainly_negative(m.tt)) return 2;
  }
  throw Error("rod", "a sign that 64 digits leave open",
              "a softer bed, or a factor that is not critical itself");
}

/// Adds what a node has of its own; what is held there leaves a 1 on the diagonal and nothing beside it.
void hold_diagonal(PieceBlock& at, const RodNode& node) {
  const Interval zero(0);
  if (node.across.is_held())
    at = {Interval(1), zero, zero, at.tt};
  else
    at.ww += Interval(node.across.stiffness);
  if (node.turn.is_held())
    at = {at.ww, zero, zero, Interval(1)};
  else
    at.tt += Interval(node.turn.stiffness);
}
void hold_mixed(PieceBlock& mixed, const RodNode& first, const RodNode& second) {
  const Interval zero(0);
  if (first.across.is_held()) mixed.ww = mixed.wt = zero;
  if (first.turn.is_held()) mixed.tw = mixed.tt = zero;
  if (second.across.is_held()) mixed.ww = mixed.tw = zero;
  if (second.turn.is_held()) mixed.wt = mixed.tt = zero;
}

/// What compresses a stretch at a factor, the bed with the inertia of its swing.
struct LoadedStretch {
  Rational length, compression, slope, bed;

  /// So many equal pieces have short series and are stable when clamped: 16 / (4 pi^2) + 250 / 500 < 1. A bed
  /// only makes them stiffer.
  [[nodiscard]] std::size_t pieces() const {
    const Rational end = compression + slope * length, square = length * length;
    const Rational load = std::max(Rational(abs(compression)), Rational(abs(end))) * square / 16;
    const Rational beds = abs(bed) * square * square / (bed < 0 ? 250 : 10000);
    std::size_t count = 1;
    while (count <= most_pieces && (load > Rational(count) * count || beds > mp::pow(Integer(count), 4)))
      count += 1 + count / 16;
    return count;
  }
};

/// Eliminates node after node, from the base on.
class Elimination {
 public:
  explicit Elimination(const RodNode& base) : node_(base) {}

  /// A piece, and the node at its second end.
  void add(const PieceStiffness& piece, const RodNode& next) {
    PieceBlock at = sum(carried_, piece.first), mixed = piece.mixed;
    hold_diagonal(at, node_);
    hold_mixed(mixed, node_, next);
    negative_ += negative_of(at);
    carried_ = difference(piece.second, product(transposed(mixed), product(inverse_of(at), mixed)));
    node_ = next;
  }
  /// Of all nodes, the last one too.
  [[nodiscard]] std::size_t count() const {
    PieceBlock at = carried_;
    hold_diagonal(at, node_);
    return negative_ + negative_of(at);
  }

 private:
  RodNode node_;
  PieceBlock carried_;
  std::size_t negative_ = 0;
};

}  // namespace

std::size_t negative_directions(const DividedRod& rod, const Rational& factor,
                                const Rational& frequency_squared) {
  Elimination elimination(rod.nodes.front());
  for (std::size_t i = 0; i < rod.stretches.size(); ++i) {
    const RodStretch& stretch = rod.stretches[i];
    const auto now = [&](const Growing& growing) {
      return Rational(growing.fixed + growing.multiplied * factor);
    };
    const LoadedStretch loaded{stretch.length, now(stretch.compression), now(stretch.slope),
                               rod.bed - frequency_squared};
    const std::size_t pieces = loaded.pieces();
    if (pieces > most_pieces)
      throw Error("rod", "a load or a bed that asks for more than " + std::to_string(most_pieces) + " pieces",
                  "a smaller one");
    const Rational length = stretch.length / pieces;
    std::optional<PieceStiffness> same;  // pieces of equal compression are equal
    for (std::size_t p = 0; p < pieces; ++p) {
      if (!same || loaded.slope != 0) {
        const Rational N = loaded.compression + loaded.slope * length * p;
        same = stiffness(length, {Interval(N), Interval(loaded.slope), Interval(0), Interval(loaded.bed)});
      }
      elimination.add(*same, p + 1 == pieces ? rod.nodes[i + 1] : RodNode());
    }
  }
  return elimination.count();
}

}  // namespace plumbline::proofs
