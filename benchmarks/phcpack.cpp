#include "benchmarks/phcpack.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "proofs/census/found_equilibria.hpp"

namespace plumbline::bench {
namespace {

namespace fs = std::filesystem;

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

/// Coefficients of the sum of the series in T_m(u) of cos(widest u) or sin(widest u), |u| <= 1.
std::vector<double> circular(bool sine, const Question& question) {
  const double widest = question.widest;
  const int last = question.degree - (sine ? 0 : 1);
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
  const auto cosine = circular(false, question), sine = circular(true, question);
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

}  // namespace

int degree_for(double widest, double accuracy) {
  int m = 4;
  while (std::abs(std::cyl_bessel_j(m + 2, widest)) > accuracy / 4) m += 2;
  return m + 1;
}

Peer phc(const fs::path& folder, const Question& question, int seed, int most_seconds) {
  const fs::path system = folder / "system", output = folder / "output";
  std::ofstream(system) << system_of(question);
  fs::remove(output);
  const double before = children_seconds();
  const std::string command = fmt::format("ulimit -t {}; phc -b -0{} {} {} > {} 2>&1", most_seconds,
                                          seed == 0 ? "" : std::to_string(seed), system.string(),
                                          output.string(), (folder / "words").string());
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

}  // namespace plumbline::bench
