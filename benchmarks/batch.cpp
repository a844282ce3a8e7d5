/// \file
/// The batch of lowest critical forces on chains that benchmarks/batch.py hands over, alone in C++: processor
/// seconds of the fastest of so many runs.
///
/// usage: batch FILE LINKS RUNS, where FILE holds all lengths and then all stiffnesses as doubles

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <plumbline/straight/critical_force_batch.hpp>

#include "benchmarks/race.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::vector<double> all(std::filesystem::file_size(argv[1]) / sizeof(double));
  std::ifstream(argv[1], std::ios::binary)
      .read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size() * sizeof(double)));
  const std::span<const double> lengths(all.data(), all.size() / 2),
      stiffness(all.data() + all.size() / 2, all.size() / 2);
  const plumbline::ChainBatch batch{std::stoul(argv[2]), lengths, stiffness};
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for (int run = 0; run < std::stoi(argv[3]); ++run) {
    const double start = plumbline::bench::processor_seconds();
    const std::vector<double> forces = lowest_forces(batch);
    best = std::min(best, plumbline::bench::processor_seconds() - start);
    sum += forces.front();
  }
  std::printf("%.9g %.17g\n", best, sum);
}
