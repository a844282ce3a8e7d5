/// \file
/// `bench-structures`: critical factors of other ends and loads, ours and LAPACK's on the same pencil. Prints
/// tables and puts them between the markers in benchmarks/RESULTS-structures.md.

#include <cmath>
#include <iostream>
#include <plumbline/straight/pencil_sweep.hpp>
#include <plumbline/straight/string_form.hpp>
#include <random>

#include "benchmarks/peers.hpp"
#include "benchmarks/race.hpp"
#include "benchmarks/results.hpp"
#include "proofs/exact/straight_structure.hpp"

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace plumbline::bench {
namespace {

/// Lengths and stiffnesses of three decimals over a factor of 4.
Structure<Rational> random_structure(std::size_t n) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> thousandths(500, 2000);
  std::vector<Rational> length, stiffness;
  for (std::size_t i = 0; i < n; ++i) {
    length.emplace_back(thousandths(random), 1000);
    stiffness.emplace_back(thousandths(random), 1000);
  }
  return Structure<Rational>(Chain<Rational>(length, stiffness));
}

Structure<Rational> cantilever(std::size_t n) {
  Structure<Rational> structure = random_structure(n);
  structure.end_point = {};
  structure.add_compression();
  return structure;
}

Structure<Rational> heavy(std::size_t n) {
  Structure<Rational> structure = random_structure(n);
  structure.end_point = {};
  for (std::size_t link = 1; link <= n; ++link) structure.add_weight(link, {-1, 0});
  return structure;
}

Structure<Rational> on_a_bed(std::size_t n) {
  Structure<Rational> structure = random_structure(n);
  structure.end_point.turn = Restraint<Rational>::sprung(Rational(1, 2));
  structure.add_foundation(Rational(1, 10));
  structure.add_compression();
  return structure;
}

double error_of(const Forces& found, const std::vector<proofs::ForceEnclosure>& exact) {
  double worst = 0;
  for (std::size_t m = 0; m < std::min(found.size(), exact.size()); ++m) {
    const Mpfr50 proved = from_rational<Mpfr50>(exact[m].low);
    worst = std::max(worst, std::abs((Mpfr50(found[m]) / proved - 1).convert_to<double>()));
  }
  return worst;
}

std::string rows(const std::string& what, std::size_t n, const std::vector<Runner>& runners,
                 const std::vector<proofs::ForceEnclosure>& exact) {
  std::string text;
  for (const Runner& runner : runners)
    text += fmt::format("| {} | {} | {} | {} | {:.3g} | {:.1e} |\n", what, n, runner.name,
                        in_units(runner.seconds), runner.ratio, error_of(runner.result, exact));
  return text;
}

Runner proved(const Structure<Rational>& structure, std::size_t lowest) {
  return {"ours, 15 digits proved", [structure, lowest] {
            Forces factors;
            for (const auto& one : proofs::StraightStructure(structure).enclose(lowest, 15))
              factors.push_back(one.low.convert_to<double>());
            return factors;
          }};
}

/// The lowest factor where a string has it.
std::string lowest_of_string(const char* what, Structure<Rational> (*draw)(std::size_t), std::size_t n) {
  const Structure<Rational> exact = draw(n);
  const auto structure = from_rational<double>(exact);
  const auto form = string_form(structure);
  if (!form) throw Error("bench", "no string", "one");
  std::vector<Runner> runners{
      {"ours", [&] { return Forces{lowest_critical_force(string_form(structure)->straight())}; }},
      {"dpttrf inverse iteration", [&] { return dpttrf_inverse_iteration(form->straight()); }}};
  if (n <= 1000) {
    runners.push_back({"dsbgvx", [&] { return dsbgvx_lowest_of_pencil(straight_pencil(structure)); }});
    runners.push_back(proved(exact, 1));
  }
  race(runners, 2);
  const auto reference =
      n <= 1000 ? proofs::StraightStructure(exact).enclose(1, 20) : std::vector<proofs::ForceEnclosure>();
  if (reference.empty()) {
    const auto form50 = string_form(from_rational<Mpfr50>(exact));
    const Mpfr50 force = lowest_critical_force(form50->straight());
    return rows(what, n, runners, {{1, Rational(force), Rational(force), 0, 1}});
  }
  return rows(what, n, runners, reference);
}

std::string of_pencil(std::size_t n, bool all) {
  const Structure<Rational> exact = on_a_bed(n);
  const auto pencil = straight_pencil(from_rational<double>(exact));
  const std::size_t modes = kind_of(straight_pencil(exact)).modes, lowest = all ? modes : 1;
  std::vector<Runner> runners{
      {"ours, doubles", [&] { return critical_factors(pencil, lowest, modes); }},
      {"dsbgvx", [&] { return all ? dsbgvx_all_of_pencil(pencil) : dsbgvx_lowest_of_pencil(pencil); }},
      {"dsygv", [&] { return dsygv_all_of_pencil(pencil); }},
      proved(exact, lowest)};
  race(runners, 2);
  return rows(all ? "bed, all" : "bed, lowest", n, runners,
              proofs::StraightStructure(exact).enclose(lowest, 20));
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  using namespace plumbline::bench;
  try {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    std::string table =
        fmt::format("Written by `build/benchmarks/bench-structures` on {}.\n\n", processor_name()) +
        "| case | n | method | time | time / ours | relative error |\n|---|--:|---|--:|--:|--:|\n";
    const auto add = [&](const std::string& rows) {
      std::cout << rows << std::flush;
      table += rows;
    };
    for (const std::size_t n : {10U, 1000U, 1000000U}) {
      add(lowest_of_string("cantilever, lowest", cantilever, n));
      add(lowest_of_string("own weight, lowest", heavy, n));
    }
    for (const std::size_t n : {10U, 100U, 1000U}) add(of_pencil(n, false));
    for (const std::size_t n : {10U, 100U}) add(of_pencil(n, true));
    put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-structures.md", "bench-structures", table);
  } catch (const std::exception& error) {
    std::cerr << "bench-structures: " << error.what() << '\n';
    return 2;
  }
}
