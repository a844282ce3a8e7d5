// What others published of rods and short chains, beside what is proved here: the table of
// benchmarks/RESULTS-rods.md.

#include <doctest/doctest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "proofs/rod/elastica.hpp"
#include "tests/proofs/rod/some_rods.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

constexpr int digits = 15;

Rational exact(const Interval::End& end) {
  Rational result;
  mpfr_get_q(result.backend().data(), end.backend().data());
  return result;
}

/// As many digits as both ends share, fifteen at most.
std::string shared_digits(const Interval& x) {
  const Rational low = exact(x.lower()), high = exact(x.upper());
  for (int kept = digits; kept > 0; --kept) {
    if (to_decimal(low, kept) == to_decimal(high, kept)) return to_decimal(low, kept);
  }
  return "";
}

Interval enclosed(const Rod& rod) {
  const NarrowBracket factor = critical_rod(rod, digits + 2).factor;
  return hull(Interval(factor.low), Interval(factor.high));
}

std::string factor(const Rod& rod) {
  return shared_digits(enclosed(rod));
}

/// Length of the pinned rod that buckles at the same force.
Interval reduced_length(const Interval& force) {
  return Interval::pi() / sqrt(force);
}

std::string on_bed(const Rational& sixteenths) {
  Rod rod = compressed_rod(pinned<Rational>(), guided<Rational>());
  rod.bed = 16 * sixteenths;
  return shared_digits(reduced_length(enclosed(rod)));
}

/// One at the top, so many times it with that in the middle.
std::string two_loads(const Rational& times) {
  Rod rod = compressed_rod(pinned<Rational>(), guided<Rational>());
  rod.loads.push_back({Rational(1, 2), times - 1});
  return shared_digits(reduced_length(enclosed(rod) * Interval(times)));
}

/// The lowest so many factors of a chain with springs and links of 1.
std::string chain(std::size_t links, bool base_spring, const Support<Rational>& end, std::size_t lowest = 1) {
  std::vector<Rational> stiffness(links, 1);
  if (!base_spring) stiffness[0] = 0;
  Structure<Rational> structure(Chain<Rational>(std::vector<Rational>(links, 1), stiffness));
  structure.end_point = end;
  structure.add_compression();
  std::string text;
  for (const auto& mode : StraightStructure(structure).in_decimals(lowest, digits, false))
    text += (text.empty() ? "" : " and ") + mode.force;
  return text;
}

std::string bent(int degrees) {
  const BentCantilever shape = bent_cantilever(Interval(Rational(degrees, 180)) * Interval::pi());
  const Interval straight = sqr(Interval::pi()) / Interval(4);
  return shared_digits(shape.force / straight) + "; " + shared_digits(shape.x) + "; " +
         shared_digits(shape.y);
}

std::string pushed_across(int force) {
  const BentCantilever shape = cantilever_pushed_across(Interval(force));
  return shared_digits(shape.y) + "; " + shared_digits(Interval(1) - shape.x) + "; " +
         shared_digits(shape.tip);
}

const Support<Rational> pin = pinned<Rational>(), roller = guided<Rational>(), clamp = clamped<Rational>(),
                        nothing = {};

std::string mid_spring() {
  Rod rod = compressed_rod(pin, roller);
  rod.supports = {{Rational(1, 2), Restraint<Rational>::sprung(Rational(1579, 10))}};
  return factor(rod);
}

std::string spring_base() {
  Rod rod = compressed_rod(pin, nothing);
  rod.base.turn = Restraint<Rational>::sprung(1);
  return factor(rod);
}

std::string leipholz() {
  Rod rod = heavy_rod(clamped_base(), nothing);
  rod.weights[0].kind = LoadKind::follower;
  return factor(rod);
}

std::string ziegler() {
  Structure<Rational> structure{Chain<Rational>({1, 1}, {1, 1})};
  structure.end_point = nothing;
  structure.mass = {0, 2, 1};
  structure.loads.push_back({2, {-1, 0}, true, LoadKind::follower});
  return stability_loss(straight_motion(structure), digits).factor;
}

struct Row {
  const char *what, *quantity, *published, *source;
  std::function<std::string()> proved;
};

constexpr const char *timoshenko = "Timoshenko, Gere 1961", *mattiasson = "Mattiasson 1981";

const Row rows[] = {
    {"rod, pinned and pinned", "P", "9.8696", timoshenko, [] { return factor(compressed_rod(pin, roller)); }},
    {"rod, clamped and free", "P", "2.4674", timoshenko,
     [] { return factor(compressed_rod(clamped_base(), nothing)); }},
    {"rod, clamped and pinned", "P", "20.19", timoshenko,
     [] { return factor(compressed_rod(clamped_base(), roller)); }},
    {"rod, clamped and clamped", "P", "39.478", timoshenko,
     [] { return factor(compressed_rod(clamped_base(), clamp)); }},
    {"rod, clamped; turning held, free across", "P", "9.8696", timoshenko,
     [] {
       return factor(compressed_rod(clamped_base(), {{}, {}, Restraint<Rational>::held()}));
     }},
    {"own weight q, clamped below, free", "q", "7.837", "Greenhill 1881",
     [] { return factor(heavy_rod(clamped_base(), nothing)); }},
    {"own weight, pinned and pinned", "q", "18.57", "Wang, Wang, Reddy 2005",
     [] { return factor(heavy_rod(pin, roller)); }},
    {"own weight, clamped below, pinned", "q", "52.50", "Wang, Wang, Reddy 2005",
     [] { return factor(heavy_rod(clamped_base(), roller)); }},
    {"own weight, pinned below, clamped", "q", "30.01", "Wang, Wang, Reddy 2005",
     [] { return factor(heavy_rod(pin, clamp)); }},
    {"own weight, clamped and clamped", "q", "74.63", "Wang, Wang, Reddy 2005",
     [] { return factor(heavy_rod(clamped_base(), clamp)); }},
    {"pinned, bed b = 16", "reduced length", "0.927", timoshenko, [] { return on_bed(1); }},
    {"pinned, bed b = 80", "reduced length", "0.741", timoshenko, [] { return on_bed(5); }},
    {"pinned, bed b = 320", "reduced length", "0.483", timoshenko, [] { return on_bed(20); }},
    {"pinned, bed b = 800", "reduced length", "0.406", timoshenko, [] { return on_bed(50); }},
    {"pinned, bed b = 1600", "reduced length", "0.351", timoshenko, [] { return on_bed(100); }},
    {"pinned, a quarter of the top's in the middle", "reduced length", "0.95", timoshenko,
     [] { return two_loads(Rational(5, 4)); }},
    {"pinned, half of the top's in the middle", "reduced length", "0.91", timoshenko,
     [] { return two_loads(Rational(3, 2)); }},
    {"pinned, as much in the middle as at the top", "reduced length", "0.87", timoshenko,
     [] { return two_loads(2); }},
    {"pinned, twice the top's in the middle", "reduced length", "0.82", timoshenko,
     [] { return two_loads(3); }},
    {"pinned, spring of 157.9 in the middle", "P", "39.48", timoshenko, mid_spring},
    {"spring of 1 against turning, free", "P", "0.7402", timoshenko, spring_base},
    {"clamped and free, follower (Beck)", "P", "20.05", "Beck 1952", [] { return factor(beck_rod()); }},
    {"clamped and free, distributed follower (Leipholz)", "q", "40.05", "Leipholz 1962", leipholz},
    {"two links, follower, masses 2 and 1", "P", "2.086", "Ziegler 1952", ziegler},
    {"two links, free", "P", "0.382", "Ziegler 1968", [] { return chain(2, true, nothing); }},
    {"one link, free", "P", "1", timoshenko, [] { return chain(1, true, nothing); }},
    {"two links, pinned", "P", "2", "Hencky 1920", [] { return chain(2, false, roller); }},
    {"three links, pinned", "P", "1 and 3", "Thompson, Hunt 1973", [] { return chain(3, false, roller, 2); }},
    {"four links, pinned", "P", "0.5858", "Hencky 1920", [] { return chain(4, false, roller); }},
    {"three links, free", "P", "0.198062", "Wang et al. 2020", [] { return chain(3, true, nothing); }},
    {"five links, free", "P", "0.081014", "Wang et al. 2020", [] { return chain(5, true, nothing); }},
    {"ten links, free", "P", "0.022338", "Wang et al. 2020", [] { return chain(10, true, nothing); }},
    {"bent cantilever, tip at 20°", "P / P_crit; x; y", "1.015; 0.97; 0.22", timoshenko,
     [] { return bent(20); }},
    {"bent cantilever, tip at 60°", "P / P_crit; x; y", "1.152; 0.741; 0.593", timoshenko,
     [] { return bent(60); }},
    {"bent cantilever, tip at 100°", "P / P_crit; x; y", "1.518; 0.349; 0.792", timoshenko,
     [] { return bent(100); }},
    {"bent cantilever, tip at 140°", "P / P_crit; x; y", "2.541; -0.107; 0.75", timoshenko,
     [] { return bent(140); }},
    {"bent cantilever, tip at 176°", "P / P_crit; x; y", "9.116; -0.577; 0.421", timoshenko,
     [] { return bent(176); }},
    {"strut far beyond buckling, tip at 176°", "P; x - 1; y", "22.493; -1.577; 0.421", "NAFEMS NL6",
     [] {
       const BentCantilever shape = bent_cantilever(Interval(Rational(176, 180)) * Interval::pi());
       return shared_digits(shape.force) + "; " + shared_digits(shape.x - Interval(1)) + "; " +
              shared_digits(shape.y);
     }},
    {"cantilever, across 1", "y; 1 - x; tip", "0.30172; 0.05643; 0.46135", mattiasson,
     [] { return pushed_across(1); }},
    {"cantilever, across 2", "y; 1 - x; tip", "0.49346; 0.16064; 0.78175", mattiasson,
     [] { return pushed_across(2); }},
    {"cantilever, across 5", "y; 1 - x; tip", "0.71379; 0.38763; 1.21537", mattiasson,
     [] { return pushed_across(5); }},
    {"cantilever, across 10", "y; 1 - x; tip", "0.81061; 0.555; 1.43029", mattiasson,
     [] { return pushed_across(10); }},
};

std::vector<std::string> parts(const std::string& list) {
  std::vector<std::string> found(1);
  for (const char c : list) {
    if (c == ';')
      found.emplace_back();
    else if (c != ' ')
      found.back() += c;
  }
  return found;
}

/// Digits of the published value that the proved one, rounded alike, has too; of the worst in a list.
std::string agreeing_digits(const std::string& published, const std::string& proved) {
  if (published.find("and") != std::string::npos) return "all";
  const auto printed = parts(published), known = parts(proved);
  bool all = true;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const auto point = printed[i].find('.');
    const int places = point == std::string::npos ? 0 : static_cast<int>(printed[i].size() - point - 1);
    all = all && to_fixed(*parse_decimal(known[i]), places) == to_fixed(*parse_decimal(printed[i]), places);
  }
  return all ? "all" : "**not all**";
}

}  // namespace

TEST_CASE("published values of rods: the table of benchmarks/RESULTS-rods.md") {
  std::ifstream file(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-rods.md");
  std::ostringstream document;
  document << file.rdbuf();
  for (const Row& row : rows) {
    const std::string proved = row.proved();
    const std::string line = std::string("| ") + row.what + " | " + row.quantity + " | " + row.published +
                             " | " + row.source + " | " + proved + " | " +
                             agreeing_digits(row.published, proved) + " |";
    MESSAGE(line);
    CHECK_MESSAGE(document.str().find(line) != std::string::npos, "benchmarks/RESULTS-rods.md lacks: ", line);
  }
}
