/// \file
/// `bench-digits`: all critical forces to 50 and to 1000 proved digits, as `critical --all --digits` computes
/// them, beside FLINT and Arb. Prints a table and puts it between the markers in
/// benchmarks/RESULTS-digits.md.

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <random>

#include "benchmarks/flint_peers.hpp"
#include "benchmarks/race.hpp"
#include "benchmarks/random_chain.hpp"
#include "benchmarks/results.hpp"
#include "proofs/exact/critical_modes.hpp"

namespace plumbline::bench {
namespace {

/// The chains of this table, always the same.
Chain<Rational> random_chain(std::size_t links) {
  std::mt19937 random(1);
  return bench::random_chain(links, random);
}

std::vector<std::string> ours(const Chain<Rational>& chain, int digits) {
  std::vector<std::string> decimals;
  for (const auto& mode : proofs::forces_in_decimals(chain, chain.size(), digits))
    decimals.push_back(mode.force);
  return decimals;
}

struct Way {
  std::string name;
  FlintPeer compute;
  std::size_t most;  ///< links times digits; for more it would take minutes
};

const std::vector<Way> ways{{"`arb_fmpz_poly_complex_roots`", polynomial_roots, 1000000},
                            {"the same to isolate, then `arb_poly` Newton", refined_roots, 1000000},
                            {"`acb_mat_eig_simple`", matrix_eigenvalues, 30000}};

/// The fewest bits, by powers of two, with which a peer reaches the digits: its best setting.
long guard_of(const Way& way, const Chain<Rational>& chain, int digits) {
  const auto decimals = ours(chain, digits);
  for (long guard = 16; guard < 100000; guard *= 2) {
    const Balls balls = way.compute(chain, digits, guard);
    if (!balls.reach(digits)) continue;
    if (!balls.agree(decimals, digits)) throw Error(way.name, "other forces", "the same");
    return guard;
  }
  throw Error(way.name, "no enclosures", "some at some precision");
}

std::string in_units(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

std::string row(std::size_t links, int digits) {
  const auto chain = random_chain(links);
  std::vector<Runner> runners{{"ours", [&] { return std::vector<double>(ours(chain, digits).size()); }}};
  for (const Way& way : ways) {
    if (links * static_cast<std::size_t>(digits) > way.most) continue;
    const long guard = guard_of(way, chain, digits);
    runners.push_back({way.name, [&, guard] { return way.compute(chain, digits, guard).middles(); }});
  }
  race(runners, 3);
  std::string text = fmt::format("| {} | {} | {} |", links, digits, in_units(runners[0].seconds));
  double best = INFINITY;
  for (std::size_t i = 1; i < runners.size(); ++i) {
    text += fmt::format(" {:.3g} |", runners[i].ratio);
    best = std::min(best, runners[i].ratio);
  }
  for (std::size_t i = runners.size(); i <= ways.size(); ++i) text += " |";
  return text + fmt::format(" **{:.2g}** |\n", best);
}

int main_program() {
  std::string table = fmt::format("Written by `build/benchmarks/bench-digits` on {}.\n\n", processor_name()) +
                      "| n | digits | ours |";
  std::string rule = "|--:|--:|--:|";
  for (const Way& way : ways) {
    table += fmt::format(" {} / ours |", way.name);
    rule += "--:|";
  }
  table += " the fastest of these / ours |\n" + rule + "--:|\n";
  std::cout << table << std::flush;
  for (const int digits : {50, 1000}) {
    for (const std::size_t links : {4U, 10U, 30U, 100U}) {
      const std::string line = row(links, digits);
      std::cout << line << std::flush;
      table += line;
    }
  }
  put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-digits.md", "bench-digits", table);
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  try {
    return plumbline::bench::main_program();
  } catch (const std::exception& error) {
    std::cerr << "bench-digits: " << error.what() << '\n';
    return 2;
  }
}
