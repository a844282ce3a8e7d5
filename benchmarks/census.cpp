/// \file
/// `bench-census`: all equilibria of a chain, beside PHCpack, which follows all complex roots of a polynomial
/// system that is nearly the same. Prints a table and puts it between the markers in
/// benchmarks/RESULTS-census.md.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "benchmarks/race.hpp"
#include "benchmarks/results.hpp"
#include "proofs/census/census_task.hpp"
#include "proofs/census/found_equilibria.hpp"

namespace plumbline::bench {
namespace {

namespace fs = std::filesystem;
using Model = NominalModel<double>;

constexpr double near_enough = 1e-6;  ///< of sine and cosine, and of imaginary parts to nothing
constexpr int most_seconds = 120;     ///< of the peer's processor time

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

/// What is asked, and within which absolute angle all answers lie.
struct Question {
  proofs::CensusTask task;
  double widest;
};

/// Compressed by a force that lets no link turn farther than four radians.
Question under_force(std::size_t links) {
  proofs::CensusTask task{"random", random_chain(links), false, proofs::Given::force, {}, 0};
  const auto z = distance_to_end(task.chain);
  Rational turn(4), per_force(0);
  for (std::size_t i = 0; i < links; ++i) {
    turn -= abs(task.chain.rest()[i]);
    per_force += z[i] / task.chain.stiffness()[i];
  }
  const auto force = static_cast<long>(std::floor(1000 * static_cast<double>(turn / per_force)));
  task.load = {Rational(-force, 1000), 0};
  return {std::move(task), 4};
}

/// Its end point pushed in by half a link.
Question at_end_point(std::size_t links) {
  proofs::CensusTask task{
      "random", random_chain(links), false, proofs::Given::deflection, {Rational(1, 2), Rational(1, 10)}, 0};
  const double first = std::abs(static_cast<double>(task.chain.rest()[0]));
  return {std::move(task), first + static_cast<double>(links) * std::numbers::pi};
}

/// Coefficients of Chebyshev's polynomial T_m.
std::vector<double> chebyshev(int m) {
  std::vector<double> before{1}, now{0, 1};
  if (m == 0) return before;
  for (; m > 1; --m) {
    std::vector<double> next(now.size() + 1);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = 2 * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(now, next);
  }
  return now;
}

/// The even degree up to which the series in T_m(u) of cos(widest u) and sin(widest u), |u| <= 1, are summed,
/// and one more for the sine: what they leave out is `near_enough` to nothing.
int degree_for(double widest) {
  int m = 4;
  while (std::abs(std::cyl_bessel_j(m + 2, widest)) > near_enough / 4) m += 2;
  return m;
}

/// Coefficients of that sum, for the cosine or the sine.
std::vector<double> circular(bool sine, double widest) {
  const int last = degree_for(widest) + (sine ? 1 : 0);
  std::vector<double> sum(static_cast<std::size_t>(last) + 1);
  for (int m = sine ? 1 : 0; m <= last; m += 2) {
    const double factor = (m == 0 ? 1 : 2) * (m % 4 < 2 ? 1 : -1) * std::cyl_bessel_j(m, widest);
    const std::vector<double> T = chebyshev(m);
    for (std::size_t i = 0; i < T.size(); ++i) sum[i] += factor * T[i];
  }
  return sum;
}

std::string term(double factor, const std::string& variables) {
  return fmt::format("{:+.17e}{}", factor, variables);
}

std::string terms(double factor, const std::vector<double>& coefficients, const std::string& variable,
                  const std::string& times = "") {
  std::string text;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] == 0) continue;
    const std::string power = i == 0 ? "" : i == 1 ? "*" + variable : fmt::format("*{}^{}", variable, i);
    text += term(factor * coefficients[i], times + power);
  }
  return text;
}

/// The equilibrium equations (8) in u_j = theta_j / widest and, with the end point held, the force, as
/// PHCpack reads them: k_i (q_i - rest_i) - k_{i+1} (q_{i+1} - rest_{i+1}) = L_i (Fy cos theta_i - Fx sin
/// theta_i).
std::string system_of(const Question& question) {
  const auto chain = from_rational<double>(question.task.chain);
  const std::size_t n = chain.size();
  const bool held = question.task.control() == Control::end_point;
  const double widest = question.widest;
  const auto cosine = circular(false, widest), sine = circular(true, widest);
  const auto u = [](std::size_t i) { return fmt::format("u{}", i + 1); };
  const auto load = proofs::enclosed_load(question.task);
  const double x = static_cast<double>(load.x.middle()), y = static_cast<double>(load.y.middle());
  std::string text = fmt::format("{}\n", held ? n + 2 : n), closed_x, closed_y;
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t joint : {i, i + 1}) {
      if (joint == n) continue;
      const double k = (joint == i ? 1 : -1) * chain.stiffness()[joint];
      text += term(k * widest, "*" + u(joint)) + term(-k * chain.rest()[joint], "");
      if (joint > 0) text += term(-k * widest, "*" + u(joint - 1));
    }
    const double L = chain.length()[i];
    text += held ? terms(L, sine, u(i), "*fx") + terms(-L, cosine, u(i), "*fy")
                 : terms(L * x, sine, u(i)) + terms(-L * y, cosine, u(i));
    text += ";\n";
    closed_x += terms(L, cosine, u(i));
    closed_y += terms(L, sine, u(i));
  }
  if (held) text += closed_x + term(-x, "") + ";\n" + closed_y + term(-y, "") + ";\n";
  return text;
}

struct Peer {
  double seconds = 0;                     ///< processor time
  std::size_t paths = 0;                  ///< that are followed: to all complex roots
  std::size_t roots = 0;                  ///< of them found
  std::vector<std::vector<double>> real;  ///< theta, and the force where the end point is held
};

double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The number behind the last colon of the first line that begins so; 0 where there is none.
std::size_t number_in(const fs::path& file, const std::string& beginning) {
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with(beginning)) return std::stoul(line.substr(line.rfind(':') + 1));
  }
  return 0;
}

/// The real solutions among those that `phc -b` has appended to its system.
std::vector<std::vector<double>> real_solutions(const fs::path& file, const Question& question) {
  std::vector<std::vector<double>> all;
  std::vector<double> one;
  bool real = false;
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("the solution for t")) {
      one.assign(question.task.chain.size() + 2, 0);
      real = true;
    } else if (line.starts_with("==") && real) {
      all.push_back(one);
    } else if (line.starts_with(" u") || line.starts_with(" f")) {
      std::istringstream words(line);
      std::string name, colon;
      double value = NAN, imaginary = NAN;
      words >> name >> colon >> value >> imaginary;
      real = real && std::abs(imaginary) < near_enough;
      if (name[0] == 'u') {
        real = real && std::abs(value) < 1 + near_enough;
        one[std::stoul(name.substr(1)) - 1] = value * question.widest;
      } else {
        one[question.task.chain.size() + (name == "fx" ? 0 : 1)] = value;
      }
    }
  }
  return all;
}

/// The blackbox solver, without tasks, its random numbers the same at every call.
Peer phc(const fs::path& folder, const Question& question) {
  const fs::path system = folder / "system", output = folder / "output";
  std::ofstream(system) << system_of(question);
  fs::remove(output);
  const double before = children_seconds();
  const std::string command = fmt::format("ulimit -t {}; phc -b -0 {} {} > {} 2>&1", most_seconds,
                                          system.string(), output.string(), (folder / "words").string());
  const bool done = std::system(command.c_str()) == 0;
  Peer peer{children_seconds() - before, number_in(output, "mixed volume"), 0, {}};
  // with many variables it may find no mixed volume
  if (peer.paths == 0) peer.paths = number_in(output, "2-homogeneous Bezout number");
  if (!done && peer.seconds < most_seconds / 2.0) throw Error("phc -b", "a failure", "solutions");
  if (!done) return peer;
  peer.roots = number_in(output, "Number of regular solutions");
  peer.real = real_solutions(system, question);
  return peer;
}

/// How many of the proved equilibria Newton's method reaches from the peer's real solutions.
std::size_t reached(const Peer& peer, const Question& question, const proofs::Census& census) {
  const auto n = static_cast<Eigen::Index>(question.task.chain.size());
  const Model model(from_rational<double>(question.task.chain));
  EquilibriumSolver<Model> solver(model);
  const auto load = proofs::enclosed_load(question.task);
  const Point<double> imposed{static_cast<double>(load.x.middle()), static_cast<double>(load.y.middle())};
  std::vector<bool> hit(census.equilibria.size());
  for (const auto& one : peer.real) {
    const auto size = static_cast<std::size_t>(n);
    const auto found = solver.under(question.task.control(), imposed, Vector<double>::Map(one.data(), n),
                                    {one[size], one[size + 1]});
    for (std::size_t e = 0; e < hit.size(); ++e) {
      double theta = 0, apart = 0;
      for (std::size_t j = 0; j < size; ++j) {
        theta += static_cast<double>(census.equilibria[e].q[j].middle());
        apart = std::max(apart, std::abs(theta - found.theta(static_cast<Eigen::Index>(j))));
      }
      hit[e] = hit[e] || apart < near_enough;
    }
  }
  return static_cast<std::size_t>(std::count(hit.begin(), hit.end(), true));
}

/// Processor time of one call, from as many as fit into a second or so.
template <class Call>
double seconds_of(const Call& call) {
  std::vector<double> times;
  double sum = 0;
  while (times.size() < 3 || (sum < 1 && times.size() < 100)) {
    const double start = processor_seconds();
    call();
    times.push_back(processor_seconds() - start);
    sum += times.back();
  }
  return median(times);
}

std::string row(const fs::path& folder, const char* load, const Question& question) {
  const auto census = proofs::take_census(question.task);
  if (!census.complete()) throw Error("census", "something undecided", "nothing");
  const double proved = seconds_of([&] { static_cast<void>(proofs::take_census(question.task)); });
  const double found = seconds_of([&] { static_cast<void>(proofs::find_equilibria(question.task)); });
  const Peer peer = phc(folder, question);
  const bool done = peer.roots > 0;
  const std::string roots = done ? fmt::format("{} | {} of {}", peer.roots, reached(peer, question, census),
                                               census.equilibria.size())
                                 : "– | –";
  return fmt::format("| {} | {} | {} | {:.3g} | {:.3g} | {} | {} | {} | {}{:.3g} | {}{:.3g} |\n", load,
                     question.task.chain.size(), census.equilibria.size(), 1e3 * proved, 1e3 * found,
                     degree_for(question.widest) + 1, peer.paths, roots, done ? "" : "> ", 1e3 * peer.seconds,
                     done ? "" : "> ", peer.seconds / proved);
}

int main_program() {
  std::string pattern = fs::temp_directory_path() / "plumbline-bench-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern, "no folder", "a place for the peer");
  std::string table = fmt::format("Written by `build/benchmarks/bench-census` on {}.\n\n", processor_name()) +
                      "| load | n | equilibria, proved | census, ms | from random shapes, ms | degree | "
                      "complex roots | PHCpack "
                      "found | of the equilibria | PHCpack, ms | PHCpack / census |\n"
                      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  std::cout << table << std::flush;
  const auto add = [&](const std::string& line) {
    std::cout << line << std::flush;
    table += line;
  };
  for (const std::size_t links : {2U, 3U, 4U}) add(row(pattern, "force", under_force(links)));
  for (const std::size_t links : {2U, 3U, 4U}) add(row(pattern, "end point held", at_end_point(links)));
  fs::remove_all(pattern);
  put_into(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-census.md", "bench-census", table);
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  try {
    return plumbline::bench::main_program();
  } catch (const std::exception& error) {
    std::cerr << "bench-census: " << error.what() << '\n';
    return 2;
  }
}
