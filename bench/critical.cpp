/// \file
/// `bench-critical [FILE]`: critical forces, ours and other ways in turn in one process. Prints a table and
/// puts it between the markers in FILE, bench/RESULTS.md by default.

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <plumbline/critical_force_batch.hpp>
#include <random>
#include <sstream>

#include "bench/peers.hpp"
#include "bench/race.hpp"
#include "proofs/enclosure.hpp"

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace plumbline::bench {
namespace {

/// Lengths and stiffnesses log-uniform over 10^-decades … 10^decades.
Chain<double> random_chain(std::size_t n, double decades, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<double> length(n), stiffness(n);
  for (double& L : length) L = std::pow(10, exponent(random));
  for (double& k : stiffness) k = std::pow(10, exponent(random));
  return Chain<double>(length, stiffness);
}

Chain<Mpfr50> in_50_digits(const Chain<double>& chain) {
  return convert<Mpfr50>(chain, [](double value) { return Mpfr50(value); });
}

/// The lowest forces that errors are measured against: 50 digits, each certified to 25 of them by two counts,
/// in fractions for short chains and in 50 digits for long ones, where rounding shifts a count by no more
/// than n units of 1e-50.
std::vector<Mpfr50> certified(const Chain<double>& chain, std::size_t lowest) {
  const auto high = in_50_digits(chain);
  const auto forces = critical_forces(high, lowest);
  const Mpfr50 d("1e-25");
  for (std::size_t m = 0; m < forces.size(); ++m) {
    const Mpfr50 below = forces[m] * (1 - d), above = forces[m] * (1 + d);
    bool right = false;
    if (chain.size() <= 12) {
      const auto exact = convert<Rational>(chain, [](double value) { return Rational(value); });
      right = count_below(exact, Rational(below)) <= m && count_below(exact, Rational(above)) > m;
    } else if (m % 97 == 0) {
      right = count_below(high, below) <= m && count_below(high, above) > m;
    } else {
      continue;
    }
    if (!right) throw Error("bench", "a reference value that its counts refute", "none");
  }
  return forces;
}

double worst_error(const Forces& found, const std::vector<Mpfr50>& exact) {
  double worst = 0;
  for (std::size_t m = 0; m < std::min(found.size(), exact.size()); ++m) {
    worst = std::max(worst, std::abs((Mpfr50(found[m]) / exact[m] - 1).convert_to<double>()));
    if (std::isnan(found[m])) worst = INFINITY;
  }
  return worst;
}

std::string in_units(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.0f} ns", seconds * 1e9);
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

/// One line a runner: n, who, time, ratio, error.
void write_race(std::ostream& out, std::size_t n, const std::vector<Runner>& runners,
                const std::vector<Mpfr50>& exact) {
  for (const Runner& runner : runners) {
    out << fmt::format("| {} | {} | {} | {:.3g} | {:.1e} |\n", n, runner.name, in_units(runner.seconds),
                       runner.ratio, worst_error(runner.result, exact));
  }
  out << std::flush;
}

constexpr const char* race_head =
    "| n | method | time | time / ours | relative error |\n|--:|---|--:|--:|--:|\n";

void lowest_table(std::ostream& out) {
  out << "### Lowest critical force\n\n" << race_head;
  for (const std::size_t n : {4U, 10U, 100U, 1000U, 10000U, 100000U, 1000000U}) {
    const auto chain = random_chain(n, 0.3, 1);
    const auto as = [&](auto method) { return [&chain, method] { return method(chain); }; };
    std::vector<Runner> runners{{"ours", [&] { return critical_forces(chain, 1); }},
                                {"dpttrf inverse iteration", as(dpttrf_inverse_iteration)},
                                {"dstebz", as(dstebz_lowest)}};
    if (n <= 100000) runners.push_back({"Spectra, shift and invert", as(spectra_lowest)});
    if (n <= 1000) runners.push_back({"dsbgvx", as(dsbgvx_lowest)});
    if (n <= 1000) runners.push_back({"dsygv", as(dsygv_all)});
    if (n <= 1000) runners.push_back({"dggev, pencil (33)", as(dggev_all)});
    if (n <= 1000) runners.push_back({"Eigen, generalised self-adjoint", as(eigen_self_adjoint_all)});
    if (n <= 1000) runners.push_back({"Algorithm 1, Eigen", as(eigen_algorithm1_all)});
    race(runners, 2);
    write_race(out, n, runners, certified(chain, 1));
  }
}

void all_table(std::ostream& out) {
  out << "\n### All critical forces\n\n" << race_head;
  for (const std::size_t n : {10U, 100U, 1000U, 10000U}) {
    const auto chain = random_chain(n, 0.3, 1);
    const auto as = [&](auto method) { return [&chain, method] { return method(chain); }; };
    std::vector<Runner> runners{{"ours", [&] { return critical_forces(chain, n); }},
                                {"dlasq1", as(dlasq1_all)}};
    if (n <= 1000) runners.push_back({"dstebz", as(dstebz_all)});
    if (n <= 1000) runners.push_back({"dsygv", as(dsygv_all)});
    if (n <= 1000) runners.push_back({"Eigen, generalised self-adjoint", as(eigen_self_adjoint_all)});
    if (n <= 100) runners.push_back({"dggev, pencil (33)", as(dggev_all)});
    if (n <= 100) runners.push_back({"Algorithm 1, Eigen", as(eigen_algorithm1_all)});
    race(runners, 2);
    const std::size_t checked = n <= 100 ? n : 20;  // certified values of all would take longer than the race
    write_race(out, n, runners, certified(chain, checked));
    // the rest against dlasq1, which has few units in the last place of error, too
    double apart = 0;
    for (std::size_t m = 0; m + 1 < n; ++m) {
      apart = std::max(apart, std::abs(runners[0].result[m] / runners[1].result[m] - 1));
    }
    out << fmt::format("| {} | *largest difference of ours and dlasq1* | | | {:.1e} |\n", n, apart);
  }
}

void small_table(std::ostream& out) {
  constexpr std::size_t chains = 400000, n = 4;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-0.3, 0.3);
  std::vector<double> length(chains * n), stiffness(chains * n);
  for (double& L : length) L = std::pow(10, exponent(random));
  for (double& k : stiffness) k = std::pow(10, exponent(random));
  const ChainBatch batch{n, length, stiffness};
  const auto chain = batch.chain(0);
  std::vector<Runner> one{
      {"ours, one by one", [&] { return critical_forces(chain, 1); }},
      {"Algorithm 1, Eigen, fixed size", [&] { return eigen_algorithm1_four_links(chain); }}};
  race(one, 2);
  static_cast<void>(lowest_forces(batch));  // the first use of the pages
  std::vector<double> wall, processor;
  for (int round = 0; round < 9; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const double busy = processor_seconds();
    static_cast<void>(lowest_forces(batch));
    processor.push_back((processor_seconds() - busy) / chains);
    wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / chains);
  }
  out << "\n### Chains of four links\n\n| method | time a chain | Algorithm 1 / this |\n|---|--:|--:|\n";
  for (const Runner& runner : one) {
    out << fmt::format("| {} | {} | {:.3g} |\n", runner.name, in_units(runner.seconds),
                       one[1].seconds / runner.seconds);
  }
  out << fmt::format("| ours, a batch of {}, processor time of one core | {} | {:.3g} |\n", chains,
                     in_units(median(processor)), one[1].seconds / median(processor));
  out << fmt::format("| ours, the same, elapsed with {} threads | {} | {:.3g} |\n",
                     std::thread::hardware_concurrency(), in_units(median(wall)),
                     one[1].seconds / median(wall));
}

void memory_table(std::ostream& out) {
  const auto chain = random_chain(1000000, 0.3, 1);
  std::vector<double> other(1 << 24, 1.0);
  std::vector<double> read, ours;
  for (int round = 0; round < 15; ++round) {
    const auto evict = [&] {
      for (double& x : other) x += 1;
    };
    evict();
    double start = processor_seconds();
    Lanes sum{};
    for (const auto* list : {&chain.length(), &chain.stiffness()}) {
      Lanes sums[4]{};
      for (std::size_t i = 0; i < list->size(); i += 4 * lane_count) {
        for (std::size_t s = 0; s < 4; ++s) {
          Lanes next;
          __builtin_memcpy(&next, list->data() + i + s * lane_count, sizeof next);
          sums[s] += next;
        }
      }
      sum += sums[0] + sums[1] + sums[2] + sums[3];
    }
    static volatile double kept = 0;
    kept = sum[0];
    read.push_back(processor_seconds() - start);
    evict();
    start = processor_seconds();
    kept = critical_forces(chain, 1)[0];
    ours.push_back(processor_seconds() - start);
  }
  out << fmt::format(
      "\nA million links, lists not in the cache: {}; one read of the lists: {}; ratio {:.3g}.\n",
      in_units(median(ours)), in_units(median(read)), median(ours) / median(read));
}

void digits_table(std::ostream& out) {
  out << "\n### 50 digits, lowest force\n\n| n | ours | eigenvalues in Eigen / ours | certified enclosure / "
         "ours |\n"
         "|--:|--:|--:|--:|\n";
  for (const std::size_t n : {4U, 30U}) {
    const auto chain = random_chain(n, 0.3, 1);
    const auto high = in_50_digits(chain);
    const auto exact = convert<Rational>(chain, [](double value) { return Rational(value); });
    std::vector<Runner> runners{
        {"ours", [&] { return Forces{critical_forces(high, 1)[0].convert_to<double>()}; }},
        {"Eigen", [&] { return Forces{eigen_algorithm1_lowest(high).convert_to<double>()}; }},
        {"enclosure",
         [&] { return Forces{enclose_critical_forces(exact, 1, 50)[0].low.convert_to<double>()}; }}};
    race(runners, 2);
    out << fmt::format("| {} | {} | {:.4g} | {:.3g} |\n", n, in_units(runners[0].seconds), runners[1].ratio,
                       runners[2].ratio);
  }
}

void accuracy_table(std::ostream& out) {
  out << "\n### Largest relative error of the lowest force, graded chains\n\n"
         "| spread of L and k | chains | ours | dpttrf inverse iteration | dstebz | Algorithm 1, Eigen |\n"
         "|---|--:|--:|--:|--:|--:|\n";
  for (const double decades : {0.3, 2.0, 8.0}) {
    double worst[4] = {};
    const unsigned chains = 300;
    for (unsigned seed = 0; seed < chains; ++seed) {
      const auto chain = random_chain(2 + seed % 29, decades, seed);
      const auto exact = certified(chain, 1);
      const auto note = [&](std::size_t i, auto method) {
        double error = INFINITY;
        try {
          error = worst_error({method(chain)[0]}, exact);
        } catch (const Error&) {  // LAPACK found the matrix not positive definite
        }
        worst[i] = std::max(worst[i], error);
      };
      note(0, [](const auto& c) { return critical_forces(c, 1); });
      note(1, dpttrf_inverse_iteration);
      note(2, dstebz_lowest);
      note(3, eigen_algorithm1_all);
    }
    out << fmt::format("| 1e-{0:g} … 1e{0:g} | {1} | {2:.1e} | {3:.1e} | {4:.1e} | {5:.1e} |\n", decades,
                       chains, worst[0], worst[1], worst[2], worst[3]);
  }
}

/// Replaces what stands between the markers.
void put_into(const std::string& file, const std::string& table) {
  const std::string begin = "<!-- bench-critical:begin -->\n", end = "<!-- bench-critical:end -->\n";
  std::ostringstream old;
  old << std::ifstream(file).rdbuf();
  std::string text = old.str();
  const std::size_t from = text.find(begin), to = text.find(end);
  if (from == std::string::npos || to == std::string::npos)
    throw Error(file, "no markers", begin + "... " + end);
  text.replace(from + begin.size(), to - from - begin.size(), table);
  std::ofstream(file) << text;
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  try {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    std::ostringstream out;
    out << fmt::format("Written by `build/bench/bench-critical` on {}, {} lanes of {} bits.\n\n",
                       processor_name(), plumbline::lane_count, 64);
    for (const auto table :
         {lowest_table, all_table, small_table, memory_table, digits_table, accuracy_table}) {
      const std::size_t before = out.str().size();
      table(out);
      std::cout << out.str().substr(before) << std::flush;
    }
    put_into(argc > 1 ? argv[1] : PLUMBLINE_BENCH_RESULTS, out.str());
  } catch (const std::exception& error) {
    std::cerr << "bench-critical: " << error.what() << '\n';
    return 2;
  }
}
