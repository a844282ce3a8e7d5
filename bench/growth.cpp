/// \file
/// `bench-growth`: what certified critical forces and modes of all kinds cost as chains and digits grow.
/// Prints a table and puts it between the markers in bench/RESULTS-growth.md.

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <random>

#include "bench/race.hpp"
#include "bench/results.hpp"
#include "proofs/critical_modes.hpp"

namespace plumbline::bench {
namespace {

/// Lengths and stiffnesses of five decimals, log-uniform over a factor of 4.
Chain<Rational> random_chain(std::size_t links) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(0, 2);
  const auto list = [&] {
    std::vector<Rational> values;
    for (std::size_t i = 0; i < links; ++i)
      values.emplace_back(std::lround(1e5 * std::exp2(exponent(random))), 100000);
    return values;
  };
  std::vector<Rational> length = list(), stiffness = list();
  return Chain<Rational>(std::move(length), std::move(stiffness));
}

struct Work {
  const char* name;
  std::vector<proofs::CriticalMode> (*compute)(const Chain<Rational>&, std::size_t, int);
  std::size_t modes;  ///< the lowest so many
  int digits;
  double expected;  ///< the power of n
  std::vector<std::size_t> links;
};

double seconds(const Work& work, std::size_t links) {
  const Chain<Rational> chain = random_chain(links);
  const double start = processor_seconds();
  const auto modes = work.compute(chain, work.modes, work.digits);
  const double taken = processor_seconds() - start;
  if (modes.size() != std::min(work.modes, links - 1))
    throw Error(work.name, "another number of modes", "all");
  return taken;
}

std::string rows(const Work& work) {
  std::string text;
  double before = 0;
  for (std::size_t i = 0; i < work.links.size(); ++i) {
    const double taken = seconds(work, work.links[i]);
    const double power =
        i == 0 ? 0 : std::log(taken / before) / std::log(double(work.links[i]) / double(work.links[i - 1]));
    text += fmt::format("| {} | {} | {} | {:.3g} s | {} | {} |\n", work.name, work.digits, work.links[i],
                        taken, i == 0 ? "" : fmt::format("{:.1f}", power),
                        i == 0 ? "" : fmt::format("{:.0f}", work.expected));
    before = taken;
  }
  return text;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  using namespace plumbline;
  using namespace plumbline::bench;
  constexpr std::size_t all = 1000000;
  try {
    std::string table = fmt::format("Written by `build/bench/bench-growth` on {}.\n\n", processor_name()) +
                        "| work | digits | links | processor time | power of n, measured | expected |\n"
                        "|---|--:|--:|--:|--:|--:|\n";
    for (const Work& work :
         {Work{"all forces", proofs::forces_in_decimals, all, 15, 2, {125, 250, 500, 1000}},
          Work{"all forces", proofs::forces_in_decimals, all, 40, 2, {125, 250, 500, 1000}},
          Work{"all modes", proofs::modes_in_decimals, all, 15, 2, {125, 250, 500, 1000}},
          Work{"lowest force", proofs::forces_in_decimals, 1, 15, 1, {1000, 10000, 100000}},
          Work{"lowest force", proofs::forces_in_decimals, 1, 40, 1, {1000, 10000, 100000}}})
      table += rows(work);
    std::cout << table;
    put_into(PLUMBLINE_SOURCE_DIR "/bench/RESULTS-growth.md", "bench-growth", table);
  } catch (const std::exception& error) {
    std::cerr << "bench-growth: " << error.what() << '\n';
    return 2;
  }
}
