/// \file
/// `bench-portable`: what a portable build costs beside one for this machine, in turn in one process. Prints
/// a table and puts it between the markers in benchmarks/RESULTS.md.

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <plumbline/base/widest.hpp>
#include <random>

#include "benchmarks/kernels.hpp"
#include "benchmarks/race.hpp"
#include "benchmarks/results.hpp"

namespace plumbline::bench {
namespace {

ChainList random_chains(std::size_t count, std::size_t links) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-0.3, 0.3);
  ChainList chains{links, std::vector<double>(count * links), std::vector<double>(count * links)};
  for (double& L : chains.length) L = std::pow(10, exponent(random));
  for (double& k : chains.stiffness) k = std::pow(10, exponent(random));
  return chains;
}

struct Work {
  std::string name;
  ChainList chains;
  std::vector<double> (*Kernels::*kernel)(const ChainList&);
};

/// \throws Error where the two builds answer differently by more than rounding
double portable_over_native(const Work& work) {
  const auto run = [&](const Kernels& build) {
    return [&work, f = build.*work.kernel] { return f(work.chains); };
  };
  std::vector<Runner> runners{{"native", run(native_kernels())}, {"portable", run(portable_kernels())}};
  race(runners, 3);
  const auto &a = runners[0].result, &b = runners[1].result;
  // Either is right to a few units in the last place of numbers that are sums of n terms; a path is corrected
  // to its square root of that or better.
  constexpr double rounding = 1e-8;
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i)
    same = std::abs(a[i] - b[i]) <= rounding * (1 + std::abs(a[i]));
  if (!same) throw Error("bench-portable, " + work.name, "two answers", "one");
  return runners[1].ratio;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  using namespace plumbline::bench;
  try {
    const std::vector<Work> all{
        {"lowest force, n = 4, one by one", random_chains(1000, 4), &Kernels::lowest_one_by_one},
        {"lowest force, n = 4, a batch", random_chains(10000, 4), &Kernels::lowest_as_batch},
        {"lowest force, n = 1000", random_chains(1, 1000), &Kernels::lowest_one_by_one},
        {"all forces, n = 100", random_chains(1, 100), &Kernels::all_forces},
        {"a path, n = 4", random_chains(1, 4), &Kernels::path},
        {"a path, n = 100", random_chains(1, 100), &Kernels::path}};
    std::string table =
        fmt::format("Written by `build/benchmarks/bench-portable` on {}; the portable build takes {}.\n\n",
                    processor_name(),
                    plumbline::detail::widens() ? "registers of eight doubles where it has lanes"
                                                : "the registers that it is compiled for") +
        "| work | time of a portable build over one for the machine |\n|---|--:|\n";
    for (const Work& work : all)
      table += fmt::format("| {} | {:.2f} |\n", work.name, portable_over_native(work));
    std::cout << table;
    put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS.md", "bench-portable", table);
  } catch (const std::exception& error) {
    std::cerr << "bench-portable: " << error.what() << '\n';
    return 2;
  }
}
