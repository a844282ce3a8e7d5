/// \file
/// `bench-critical`: critical forces, ours and other ways in turn in one process. Prints tables and puts them
/// between the markers in benchmarks/RESULTS.md.

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <plumbline/straight/critical_force_batch.hpp>
#include <random>
#include <sstream>

#include "benchmarks/bars.hpp"
#include "benchmarks/peers.hpp"
#include "benchmarks/race.hpp"
#include "benchmarks/results.hpp"
#include "proofs/exact/enclosure.hpp"

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

/// Makes the compiler compute a value that nothing else needs.
void keep(double value) {
  asm volatile("" : : "x"(value));
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

/// What the tables are made from, beside what they print.
struct Findings {
  std::vector<Bar> bars;

  void at_least(const std::string& what, double limit, double measured) {
    bars.push_back({what, limit, measured, true});
  }
  void at_most(const std::string& what, double limit, double measured) {
    bars.push_back({what, limit, measured, false});
  }
};

double ratio_of(const std::vector<Runner>& runners, const std::string& name) {
  return std::find_if(runners.begin(), runners.end(), [&](const Runner& r) { return r.name == name; })->ratio;
}

void lowest_table(std::ostream& out, Findings& findings) {
  double worst = 0;
  out << "### Lowest critical force\n\n" << race_head;
  for (const std::size_t n : {4U, 10U, 100U, 1000U, 10000U, 100000U, 1000000U}) {
    const auto chain = random_chain(n, 0.3, 1);
    const auto as = [&](auto method) { return [&chain, method] { return method(chain); }; };
    std::vector<Runner> runners{{"ours", [&] { return Forces{lowest_critical_force(chain)}; }},
                                {"dpttrf inverse iteration", as(dpttrf_inverse_iteration)},
                                {"dstebz", as(dstebz_lowest)}};
    if (n <= 100000) runners.push_back({"Spectra, shift and invert", as(spectra_lowest)});
    if (n <= 1000) runners.push_back({"dsbgvx", as(dsbgvx_lowest)});
    if (n <= 1000) runners.push_back({"dsygv", as(dsygv_all)});
    if (n <= 1000) runners.push_back({"dggev, pencil (33)", as(dggev_all)});
    if (n <= 1000) runners.push_back({"Eigen, generalised self-adjoint", as(eigen_self_adjoint_all)});
    if (n <= 1000) runners.push_back({"Algorithm 1, Eigen", as(eigen_algorithm1_all)});
    race(runners, 2);
    const auto exact = certified(chain, 1);
    write_race(out, n, runners, exact);
    worst = std::max(worst, worst_error(runners[0].result, exact));
    if (n != 1000) continue;
    const auto bar = [&](const char* peer, double limit) {
      findings.at_least(fmt::format("lowest force, n = 1000: times faster than {}", peer), limit,
                        ratio_of(runners, peer));
    };
    bar("dpttrf inverse iteration", 12);
    bar("dstebz", 60);
    bar("Algorithm 1, Eigen", 1e5);
  }
  findings.at_most("lowest force, n up to 10^6: relative error", 1e-13, worst);
}

void all_table(std::ostream& out, Findings& findings) {
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
    const auto exact = certified(chain, checked);
    write_race(out, n, runners, exact);
    if (n >= 100) {
      findings.at_least(fmt::format("all forces, n = {}: times faster than dlasq1", n), n == 100 ? 6 : 4,
                        runners[1].ratio);
      findings.at_most(fmt::format("all forces, n = {}: relative error", n), 1e-13,
                       worst_error(runners[0].result, exact));
    }
    // the rest against dlasq1, which has few units in the last place of error, too
    double apart = 0;
    for (std::size_t m = 0; m + 1 < n; ++m) {
      apart = std::max(apart, std::abs(runners[0].result[m] / runners[1].result[m] - 1));
    }
    out << fmt::format("| {} | *largest difference of ours and dlasq1* | | | {:.1e} |\n", n, apart);
  }
}

/// Chain by chain, so that no branch can be learnt by heart.
Runner one_by_one(const char* name, const std::vector<Chain<double>>& chains,
                  double (*method)(const Chain<double>&)) {
  return {name, [&chains, method] {
            Forces forces(chains.size());
            for (std::size_t c = 0; c < chains.size(); ++c) forces[c] = method(chains[c]);
            return forces;
          }};
}

void small_table(std::ostream& out, Findings& findings) {
  constexpr std::size_t count = 400000, few = 1000, n = 4;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-0.3, 0.3);
  std::vector<double> length(count * n), stiffness(count * n);
  for (double& L : length) L = std::pow(10, exponent(random));
  for (double& k : stiffness) k = std::pow(10, exponent(random));
  const ChainBatch batch{n, length, stiffness};
  std::vector<Chain<double>> chains;
  for (std::size_t c = 0; c < few; ++c) chains.push_back(batch.chain(c));
  std::vector<Runner> runners{
      one_by_one("ours, one by one", chains, lowest_critical_force<double>),
      one_by_one("Algorithm 1, Eigen, fixed size", chains, eigen_algorithm1_four_links)};
  race(runners, 2);
  const double peer = runners[1].seconds / few;
  static_cast<void>(lowest_forces(batch));  // the first use of the pages
  std::vector<double> wall, processor;
  for (int round = 0; round < 25; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const double busy = processor_seconds();
    static_cast<void>(lowest_forces(batch));
    processor.push_back((processor_seconds() - busy) / count);
    wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / count);
  }
  out << "\n### Chains of four links\n\n| method | time a chain | Algorithm 1 / this |\n|---|--:|--:|\n";
  const auto line = [&](const std::string& name, double seconds) {
    out << fmt::format("| {} | {} | {:.3g} |\n", name, in_units(seconds), peer / seconds);
  };
  for (const Runner& runner : runners) line(runner.name, runner.seconds / few);
  const unsigned threads = std::thread::hardware_concurrency();
  line(fmt::format("ours, a batch of {}, processor time of one core", count), median(processor));
  line(fmt::format("ours, the same, elapsed with {} threads", threads), median(wall));
  findings.at_least("n = 4, one by one: times faster than fixed-size Eigen Algorithm 1", 12,
                    runners[1].ratio);
  findings.at_least(fmt::format("n = 4, in batch on {} cores: times faster", threads), 60,
                    peer / median(wall));
}

void memory_table(std::ostream& out, Findings& findings) {
  const auto chain = random_chain(1000000, 0.3, 1);
  std::vector<double> other(1 << 24, 1.0);
  std::vector<double> read, ours;
  for (int round = 0; round < 15; ++round) {
    const auto evict = [&] {
      for (double& x : other) x += 1;
    };
    evict();
    double start = processor_seconds();
    detail::Lanes sum{};
    for (const auto* list : {&chain.length(), &chain.stiffness()}) {
      detail::Lanes sums[4]{};
      for (std::size_t i = 0; i < list->size(); i += 4 * detail::lane_count) {
        for (std::size_t s = 0; s < 4; ++s) {
          detail::Lanes next;
          __builtin_memcpy(&next, list->data() + i + s * detail::lane_count, sizeof next);
          sums[s] += next;
        }
      }
      sum += sums[0] + sums[1] + sums[2] + sums[3];
    }
    keep(sum[0]);
    read.push_back(processor_seconds() - start);
    evict();
    start = processor_seconds();
    keep(lowest_critical_force(chain));
    ours.push_back(processor_seconds() - start);
  }
  out << fmt::format(
      "\nA million links, lists not in the cache: {}; one read of the lists: {}; ratio {:.3g}.\n",
      in_units(median(ours)), in_units(median(read)), median(ours) / median(read));
  findings.at_most("lowest force, n = 10^6: time over one read of the lists", 8, median(ours) / median(read));
}

void digits_table(std::ostream& out, Findings& findings) {
  out << "\n### 50 digits, lowest force\n\n"
         "| n | ours | Eigen's eigenvalues, mpfr_float_50 / ours | the same in our number type, no heap / "
         "ours | "
         "certified enclosure / ours |\n|--:|--:|--:|--:|--:|\n";
  for (const std::size_t n : {4U, 30U}) {
    const auto chain = random_chain(n, 0.3, 1);
    const auto high = in_50_digits(chain);
    const auto stock = convert<StockMpfr50>(chain, [](double value) { return StockMpfr50(value); });
    const auto exact = convert<Rational>(chain, [](double value) { return Rational(value); });
    std::vector<Runner> runners{
        {"ours", [&] { return Forces{lowest_critical_force(high).convert_to<double>()}; }},
        {"Eigen", [&] { return Forces{eigen_algorithm1_lowest(stock)}; }},
        {"Eigen without heap", [&] { return Forces{eigen_algorithm1_lowest(high)}; }},
        {"enclosure",
         [&] { return Forces{proofs::enclose_critical_forces(exact, 1, 50)[0].low.convert_to<double>()}; }}};
    race(runners, 2);
    out << fmt::format("| {} | {} | {:.4g} | {:.4g} | {:.3g} |\n", n, in_units(runners[0].seconds),
                       runners[1].ratio, runners[2].ratio, runners[3].ratio);
    findings.at_least(
        fmt::format("50 digits, n = {}: times faster than Eigen's eigenvalues in 50-digit MPFR", n),
        n == 4 ? 70 : 1000, runners[1].ratio);
    findings.at_most(fmt::format("certified enclosure, n = {}: time over the 50 digits", n), n == 4 ? 2 : 3,
                     runners[3].ratio);
  }
}

void accuracy_table(std::ostream& out, Findings& findings) {
  std::string table =
      "\n### Largest relative error of the lowest force, graded chains\n\n"
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
      note(0, [](const auto& c) { return Forces{lowest_critical_force(c)}; });
      note(1, dpttrf_inverse_iteration);
      note(2, dstebz_lowest);
      note(3, eigen_algorithm1_all);
    }
    if (decades == 8) {
      findings.at_most("lowest force, n <= 30, L and k over 1e-8 … 1e8: relative error", 5e-15, worst[0]);
    }
    table += fmt::format("| 1e-{0:g} … 1e{0:g} | {1} | {2:.1e} | {3:.1e} | {4:.1e} | {5:.1e} |\n", decades,
                         chains, worst[0], worst[1], worst[2], worst[3]);
  }
  out << table;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  using namespace plumbline::bench;
  try {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    std::ostringstream out;
    Findings findings;
    const std::string by =
        fmt::format("Written by `build/benchmarks/bench-critical` on {}, {} lanes of {} bits.\n\n",
                    processor_name(), plumbline::detail::lane_count, 64);
    for (const auto table :
         {lowest_table, all_table, small_table, memory_table, digits_table, accuracy_table}) {
      const std::size_t before = out.str().size();
      table(out, findings);
      std::cout << out.str().substr(before) << std::flush;
    }
    const std::string bars = table_of(findings.bars);
    std::cout << '\n' << bars;
    put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS.md", "bench-critical",
             by + "### Bars\n\n" + bars + '\n' + out.str());
  } catch (const std::exception& error) {
    std::cerr << "bench-critical: " << error.what() << '\n';
    return 2;
  }
}
