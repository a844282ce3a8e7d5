/// \file
/// `bench-census`: all equilibria of a chain, beside PHCpack. Prints two tables and puts them between the
/// markers in benchmarks/RESULTS-census.md.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "benchmarks/phcpack.hpp"
#include "benchmarks/race.hpp"
#include "benchmarks/results.hpp"
#include "proofs/census/found_equilibria.hpp"

namespace plumbline::bench {
namespace {

namespace fs = std::filesystem;
using Model = NominalModel<double>;

constexpr int most_seconds = 120;  ///< of the peer's processor time, a run
constexpr int most_runs = 5;       ///< of the peer, with random numbers of their own
constexpr double coarse = 0.1;     ///< accuracy of sine and cosine at which many links are within its reach

Rational in_thousandths(std::mt19937& random, int low, int high) {
  return {std::uniform_int_distribution<int>(low, high)(random), 1000};
}

Chain<Rational> random_chain(std::size_t links) {
  std::mt19937 random(1);
  std::vector<Rational> length, stiffness, rest;
  for (std::size_t i = 0; i < links; ++i) {
    length.push_back(in_thousandths(random, 800, 1200));
    stiffness.push_back(in_thousandths(random, 800, 1200));
    rest.push_back(in_thousandths(random, -500, 500));
  }
  return Chain<Rational>(std::move(length), std::move(stiffness), std::move(rest));
}

/// Compressed by a force that lets no link turn farther than so many radians.
proofs::CensusTask under_force(std::size_t links, int widest) {
  proofs::CensusTask task{"random", random_chain(links), false, proofs::Given::force, {}, 0};
  const auto z = distance_to_end(task.chain);
  Rational turn(widest), per_force(0);
  for (std::size_t i = 0; i < links; ++i) {
    turn -= abs(task.chain.rest()[i]);
    per_force += z[i] / task.chain.stiffness()[i];
  }
  const auto force = static_cast<long>(std::floor(1000 * static_cast<double>(turn / per_force)));
  task.load = {Rational(-force, 1000), 0};
  return task;
}

/// Its end point pushed in by half a link.
proofs::CensusTask at_end_point(std::size_t links) {
  return {"random", random_chain(links), false, proofs::Given::deflection, {Rational(1, 2), Rational(1, 10)},
          0};
}

/// Absolute angle that no link exceeds in the window of the census.
double widest_at_end_point(const proofs::CensusTask& task) {
  const double first = std::abs(static_cast<double>(task.chain.rest()[0]));
  return first + static_cast<double>(task.chain.size()) * std::numbers::pi;
}

std::vector<double> absolute_angles_of(const proofs::Census& census, std::size_t equilibrium) {
  std::vector<double> theta;
  double sum = 0;
  for (const auto& q : census.equilibria[equilibrium].q)
    theta.push_back(sum += static_cast<double>(q.middle()));
  return theta;
}

/// Which of the proved equilibria Newton's method reaches from the peer's real solutions.
std::vector<bool> reached(const Peer& peer, const Question& question, const proofs::Census& census) {
  const auto n = static_cast<Eigen::Index>(question.task.chain.size());
  const Model model(from_rational<double>(question.task.chain));
  EquilibriumSolver<Model> solver(model);
  const auto load = proofs::enclosed_load(question.task);
  const Point<double> imposed{static_cast<double>(load.x.middle()), static_cast<double>(load.y.middle())};
  std::vector<bool> hit(census.equilibria.size());
  for (const auto& one : peer.real) {
    const auto size = static_cast<std::size_t>(n);
    const auto found = [&]() -> std::optional<Equilibrium<double>> {
      try {
        return solver.under(question.task.control(), imposed, Vector<double>::Map(one.data(), n),
                            {one[size], one[size + 1]});
      } catch (const Error&) {  // this start leads to no equilibrium
        return std::nullopt;
      }
    }();
    for (std::size_t e = 0; found && e < hit.size(); ++e) {
      const auto theta = absolute_angles_of(census, e);
      double apart = 0;
      for (std::size_t j = 0; j < size; ++j)
        apart = std::max(apart, std::abs(theta[j] - found->theta(static_cast<Eigen::Index>(j))));
      hit[e] = hit[e] || apart < near_enough;
    }
  }
  return hit;
}

/// Processor time of one call, from as many as fit into a second or so.
template <class Call>
double seconds_of(const Call& call) {
  std::vector<double> times;
  double sum = 0;
  while (times.empty() || (sum < 1 && times.size() < 100)) {
    const double start = processor_seconds();
    call();
    times.push_back(processor_seconds() - start);
    sum += times.back();
  }
  return median(times);
}

proofs::Census complete_census(const proofs::CensusTask& task) {
  auto census = proofs::take_census(task);
  if (!census.complete()) throw Error("census", "something undecided", "nothing");
  return census;
}

std::string precise_row(const fs::path& folder, const char* load, const proofs::CensusTask& task,
                        double widest) {
  const Question question{task, widest, degree_for(widest, near_enough)};
  const auto census = complete_census(task);
  const double proved = seconds_of([&] { static_cast<void>(proofs::take_census(task)); });
  const double found = seconds_of([&] { static_cast<void>(proofs::find_equilibria(task)); });
  const Peer peer = phc(folder, question, 0, most_seconds);
  const bool done = peer.roots > 0;
  const auto hit = reached(peer, question, census);
  const std::string roots =
      done ? fmt::format("{} | {} of {}", peer.roots, std::count(hit.begin(), hit.end(), true), hit.size())
           : "– | –";
  return fmt::format("| {} | {} | {} | {:.3g} | {:.3g} | {} | {} | {} | {}{:.3g} | {}{:.3g} |\n", load,
                     task.chain.size(), census.equilibria.size(), 1e3 * proved, 1e3 * found, question.degree,
                     peer.paths, roots, done ? "" : "> ", 1e3 * peer.seconds, done ? "" : "> ",
                     peer.seconds / proved);
}

/// The peer again and again, until a run takes too long.
std::string repeated_row(const fs::path& folder, const char* load, const proofs::CensusTask& task,
                         double widest) {
  const Question question{task, widest, degree_for(widest, coarse)};
  const auto census = complete_census(task);
  const double proved = seconds_of([&] { static_cast<void>(proofs::take_census(task)); });
  std::vector<bool> within(census.equilibria.size()), all(within.size());
  for (std::size_t e = 0; e < within.size(); ++e) {
    const auto theta = absolute_angles_of(census, e);
    within[e] = std::all_of(theta.begin(), theta.end(), [&](double t) { return std::abs(t) < widest; });
  }
  const auto counted = [&](const std::vector<bool>& hit) {
    std::size_t count = 0;
    for (std::size_t e = 0; e < hit.size(); ++e) count += hit[e] && within[e] ? 1 : 0;
    return count;
  };
  std::vector<std::string> by_run;
  std::vector<double> seconds;
  std::size_t paths = 0;
  double sum = 0;
  for (int run = 0; run < most_runs && sum < most_seconds; ++run) {
    const Peer peer = phc(folder, question, run, most_seconds);
    paths = std::max(paths, peer.paths);
    seconds.push_back(peer.seconds);
    sum += peer.seconds;
    if (peer.roots == 0) {
      by_run.emplace_back("cut off");
      break;
    }
    const auto hit = reached(peer, question, census);
    for (std::size_t e = 0; e < hit.size(); ++e) all[e] = all[e] || hit[e];
    by_run.push_back(fmt::format("{}", counted(hit)));
  }
  const std::size_t inside = counted(std::vector<bool>(within.size(), true));
  return fmt::format("| {} | {} | {} | {:.3g} | {} | {} | {} | {} | {} | {:.3g} |\n", load, task.chain.size(),
                     census.equilibria.size(), proved, question.degree, paths, inside,
                     fmt::join(by_run, ", "), counted(all), median(seconds));
}

class Table {
 public:
  Table(std::string marker, const std::string& head) : marker_(std::move(marker)) { add(head); }
  void add(const std::string& line) {
    std::cout << line << std::flush;
    text_ += line;
  }
  void put() const { put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-census.md", marker_, text_); }

 private:
  std::string marker_, text_;
};

void precise_table(const fs::path& folder, const std::string& written) {
  Table table("bench-census",
              written +
                  "| load | n | equilibria, proved | census, ms | from random shapes, ms | degree | "
                  "complex roots | PHCpack found | of the equilibria | PHCpack, ms | PHCpack / census |\n"
                  "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const std::size_t links : {2U, 3U, 4U})
    table.add(precise_row(folder, "force", under_force(links, 4), 4));
  for (const std::size_t links : {2U, 3U, 4U}) {
    const auto task = at_end_point(links);
    table.add(precise_row(folder, "end point held", task, widest_at_end_point(task)));
  }
  table.put();
}

void repeated_table(const fs::path& folder, const std::string& written) {
  Table table(
      "bench-census-runs",
      written +
          "| load | n | equilibria, proved | census, s | degree | paths of PHCpack | equilibria in its "
          "range | found, run by run | found by all runs | PHCpack, s a run |\n"
          "|---|--:|--:|--:|--:|--:|--:|---|--:|--:|\n");
  for (const std::size_t links : {3U, 4U, 5U, 6U, 7U})
    table.add(repeated_row(folder, "force", under_force(links, 3), 3));
  for (const std::size_t links : {3U, 4U, 5U, 6U, 7U})
    table.add(repeated_row(folder, "end point held", at_end_point(links), 3));
  table.put();
}

int main_program(int count, char** words) {
  std::string pattern = fs::temp_directory_path() / "plumbline-bench-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern, "no folder", "a place for the peer");
  const std::string written =
      fmt::format("Written by `build/benchmarks/bench-census` on {}.\n\n", processor_name());
  const std::string asked = count > 1 ? words[1] : "";
  if (asked != "runs") precise_table(pattern, written);
  if (asked != "precise") repeated_table(pattern, written);
  fs::remove_all(pattern);
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main(int count, char** words) {
  try {
    return plumbline::bench::main_program(count, words);
  } catch (const std::exception& error) {
    std::cerr << "bench-census: " << error.what() << '\n';
    return 2;
  }
}
