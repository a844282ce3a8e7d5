#include "verify/reference/chains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "verify/reference/draw.hpp"

namespace plumbline::verify {
namespace {

using Rationals = std::vector<Rational>;

class Collection {
 public:
  Collection(ReferenceSize size, std::uint64_t seed) : full_(size == ReferenceSize::full), seed_(seed) {}

  void add(const std::string& name, const Rationals& length, const Rationals& stiffness) {
    const std::size_t n = length.size(), all = n - 1;
    const std::size_t modes = n <= 30 ? all : n <= 200 ? 5 : 2;
    const std::size_t shapes = n <= (full_ ? 12U : 4U) ? all : full_ && n <= 200 ? 1 : 0;
    chains_.push_back({name, Chain<Rational>(length, stiffness), modes, shapes});
  }
  /// `count` chains named family-0001 …, of `low` to `high` links, entries by `entry(draw)`; with a passive
  /// joint somewhere between `passive_from` and the end, unless that is 0.
  template <class Entry>
  void add_random(const std::string& family, std::size_t count, std::size_t low, std::size_t high,
                  Entry entry, std::size_t passive_from = 0, std::size_t passive_to = 0) {
    for (std::size_t i = 1; i <= count; ++i) {
      const std::string name = fmt::format("{}-{:04}", family, i);
      Draw draw(name, seed_);
      const std::size_t n = draw.count(low, high);
      Rationals length, stiffness;
      for (std::size_t j = 0; j < n; ++j) {
        length.push_back(entry(draw));
        stiffness.push_back(entry(draw));
      }
      if (passive_from > 0) stiffness[draw.count(passive_from, std::min(passive_to, n)) - 1] = 0;
      add(name, length, stiffness);
    }
  }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  std::vector<ReferenceChain> take() { return std::move(chains_); }

 private:
  bool full_;
  std::uint64_t seed_;
  std::vector<ReferenceChain> chains_;
};

void add_uniform(Collection& set, const std::vector<std::size_t>& sizes) {
  for (const std::size_t n : sizes) {
    Rationals ones(n, Rational(1)), pinned = ones;
    pinned[0] = 0;
    set.add(fmt::format("uniform-pinned-n{:04}", n), ones, pinned);
    set.add(fmt::format("uniform-clamped-n{:04}", n), ones, ones);
  }
}

Rationals progression(const std::string& ratio, std::size_t n) {
  const Rational factor = *proofs::parse_decimal(ratio);
  Rationals values{1};
  while (values.size() < n) values.push_back(values.back() * factor);
  return values;
}

void add_geometric(Collection& set, const std::vector<std::size_t>& sizes) {
  for (const auto& [length, stiffness] : {std::pair{"1", "2"},
                                          {"1", "0.5"},
                                          {"2", "1"},
                                          {"0.5", "1"},
                                          {"1", "10"},
                                          {"1", "0.1"},
                                          {"10", "1"},
                                          {"0.1", "1"},
                                          {"10", "10"},
                                          {"10", "0.1"},
                                          {"0.1", "10"},
                                          {"0.1", "0.1"}}) {
    for (const std::size_t n : sizes)
      set.add(fmt::format("geometric-{}-{}-n{:02}", length, stiffness, n), progression(length, n),
              progression(stiffness, n));
  }
}

Rationals scaled(Rationals values, const Rational& factor) {
  for (Rational& x : values) x *= factor;
  return values;
}

/// Three kinds of chains whose parts before and behind a passive joint share critical forces, all scaled at
/// random: one force, k_1 z_2 / (z_1 L_1) = k_3 (1 / L_2 + 1 / L_3); one of three, F = 2; and two of three,
/// F = 2 -+ sqrt 2, irrational. A tie in `off` is broken by that part of k_1.
void add_tie(Collection& set, const std::string& name, int kind, const Rational& off) {
  Draw draw(name, set.seed());
  const Rational unit_length = draw.decimal(-1, 1), unit_stiffness = draw.decimal(-1, 1);
  Rationals length, stiffness;
  if (kind == 0) {
    const Rational L1 = draw.decimal(-1, 1), L2(draw.whole(1, 2)), L3(draw.whole(4, 5));
    length = {L1, L2, L3};
    stiffness = {L1 * (L1 + L2 + L3) / (L2 * L3), 0, 1};
  } else if (kind == 1) {
    length = {1, 1, 1, 1, 1};
    stiffness = {Rational(5, 2), 0, 1, 1, 1};
  } else {
    length = {5, 1, 1, 1, 1, 1};
    stiffness = {10, Rational(5, 2), 0, 1, 1, 1};
  }
  stiffness[0] *= 1 + off;
  set.add(name, scaled(length, unit_length), scaled(stiffness, unit_stiffness));
}

}  // namespace

std::vector<ReferenceChain> reference_chains(const ReferenceWish& wish) {
  const bool full = wish.size == ReferenceSize::full;
  const auto moderate = [](Draw& draw) { return draw.decimal(-1, 1); };
  Collection set(wish.size, wish.seed);
  set.add("paper-two-link", {1, 1}, {0, 1});
  set.add("paper-three-link", {1, 1, 1}, {0, 1, 1});
  set.add("paper-four-link", {1, 1, 1, 1}, {1, 1, 1, 1});

  std::vector<std::size_t> sizes{2, 3, 4, 5, 6, 8, 10, 20, 100, 1000};
  if (full) {
    for (std::size_t n = 7; n <= 60; ++n) sizes.push_back(n);
    for (const std::size_t n : {64U, 128U, 200U, 256U, 500U, 512U}) sizes.push_back(n);
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  }
  add_uniform(set, sizes);
  set.add_random("random", wish.random > 0 ? wish.random : full ? 900 : 12, 2, 12, moderate);
  set.add_random("binary", full ? 500 : 6, 2, 12, [](Draw& draw) { return draw.binary(); });
  set.add_random("graded", full ? 900 : 12, 2, 30, [](Draw& draw) { return draw.decimal(-8, 8); });
  add_geometric(set, full ? std::vector<std::size_t>{4, 8, 16} : std::vector<std::size_t>{4});
  set.add_random("passive-base", full ? 300 : 6, 2, 12, moderate, 1, 1);
  set.add_random("passive-interior", full ? 300 : 6, 3, 12, moderate, 2, 12);
  for (int i = 1; i <= (full ? 90 : 6); ++i) add_tie(set, fmt::format("tie-{:04}", i), i % 3, 0);
  for (int exponent = 1; exponent <= 60; ++exponent) {
    if (!full && exponent != 3 && exponent != 15 && exponent != 60) continue;
    const Rational off = *proofs::parse_decimal(fmt::format("1e-{}", exponent));
    for (int kind = 0; kind < 3; ++kind)
      add_tie(set, fmt::format("near-tie-{}-1e-{:02}", kind + 1, exponent), kind, off);
  }
  set.add_random("long", full ? 60 : 1, 100, 1000, moderate);
  return set.take();
}

}  // namespace plumbline::verify
