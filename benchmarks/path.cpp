/// \file
/// `bench-path`: the path of the Z-chain of Table 1 from 0 to 1.5 L with the stability of every point, beside
/// a SciPy script and AUTO-07p; and how the cost of a point grows with the chain. Processor time, one thread.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <plumbline/base/error.hpp>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "benchmarks/race.hpp"

namespace plumbline::bench {
namespace {

namespace fs = std::filesystem;
using Model = NominalModel<double>;

constexpr double tolerance =
    1e-8;  ///< of the peers' last Newton increment; our own points are exact to rounding

/// Processor time of the programs that have been run.
double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void run(const std::string& command) {
  if (std::system(command.c_str()) != 0)
    throw Error("bench-path", "a failure of: " + command, "its package; ./setup.sh --bench");
}

Branch<double> follow(const Chain<double>& chain, double reach, double last, double longest,
                      std::size_t points) {
  const Model model(chain);
  const Vector<double> shape = absolute_angles(chain.rest());
  Brancher<Model> brancher(model, {Control::end_point, {reach, 0}, {-1, 0}}, shape);
  return Tracer<Model>(brancher, {0, last, longest, points}).run(brancher.start(0, shape));
}

const std::vector<double> length{1, 1, 1, 1}, stiffness{1, 1, 1, 1}, rest{-0.2417, 0.6821, -0.7958, 0.5170};

struct Timed {
  std::size_t points = 0;
  double seconds = 0;  ///< of all points
  [[nodiscard]] double per_point() const { return 1e6 * seconds / static_cast<double>(points); }
};

Timed ours(double longest) {
  const Chain<double> chain(length, stiffness, rest);
  Timed best;
  for (int round = 0; round < 15; ++round) {
    const double start = processor_seconds();
    const Branch<double> branch = follow(chain, 3.8, 1.5, longest, 1000000);
    const double seconds = processor_seconds() - start;
    if (round == 0 || seconds < best.seconds) best = {branch.points.size(), seconds};
  }
  return best;
}

/// The script at the points of our path.
Timed scipy(const fs::path& folder, double longest) {
  const Branch<double> branch = follow(Chain<double>(length, stiffness, rest), 3.8, 1.5, longest, 1000000);
  nlohmann::json task{{"length", length}, {"stiffness", stiffness}, {"rest", rest}, {"tolerance", tolerance}};
  for (const auto& point : branch.points) {
    task["x"].push_back(point.end_point.x);
    task["y"].push_back(0.0);
  }
  std::ofstream(folder / "task.json") << task;
  run(fmt::format("OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 {} < {} > {}", PATH_SCIPY,
                  (folder / "task.json").string(), (folder / "scipy.json").string()));
  const auto answer = nlohmann::json::parse(std::ifstream(folder / "scipy.json"));
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    if (std::abs(answer["Fx"][i].get<double>() - branch.points[i].force.x) > 1e-6)
      throw Error("bench-path", "another force from SciPy", "the same path");
  }
  return {branch.points.size(), answer["seconds"].get<double>()};
}

struct Auto {
  Timed all;
  double own = 0;  ///< the time that it prints, elapsed
};

/// Its library from the package, the equations in Fortran with their derivatives; small steps, so that its
/// beginning and its output do not count.
Auto auto07p(const fs::path& folder) {
  const std::string lib = "/usr/lib/auto-07p/lib";
  run(fmt::format("gfortran -O3 -march=native -fopenmp {} {}/*.o -L{} -lauto_c -o {}/chain", PATH_AUTO, lib,
                  lib, folder.string()));
  std::ofstream(folder / "fort.2")
      << "NDIM=6, IPS=0, IRS=0, ILP=1, ICP=[1], NTST=1, NCOL=4, IAD=3, ISP=1, ISW=1, IPLT=0, NBC=0, NINT=0\n"
      << "NMX=1000000, NPR=0, MXBF=0, IID=0, ITMX=8, ITNW=5, NWTN=3, JAC=1\n"
      << fmt::format("EPSL={0}, EPSU={0}, EPSS=1e-6\n", tolerance)
      << "DS=0.0001, DSMIN=1e-9, DSMAX=0.0005, IADS=1\nNPAR=1, THL={}, THU={}, UZSTOP={1: 1.5}\n";
  Auto result;
  for (int round = 0; round < 5; ++round) {
    const double before = children_seconds();
    run(fmt::format("cd {} && OMP_NUM_THREADS=1 ./chain > out 2> errors", folder.string()));
    const double seconds = children_seconds() - before;
    if (round == 0 || seconds < result.all.seconds) result.all.seconds = seconds;
  }
  std::ifstream out(folder / "out");
  for (std::string line; std::getline(out, line);) {
    const std::size_t own = line.find("Total Time");
    if (own != std::string::npos) result.own = std::stod(line.substr(own + 10));
    if (line.find(" UZ ") != std::string::npos) result.all.points = std::stoul(line.substr(5, 8));
  }
  if (result.all.points == 0) throw Error("AUTO-07p", "no end at 1.5 L", "a path to there");
  return result;
}

/// A curved beam of n links, compressed over its ends; microseconds a point.
double long_chain(std::size_t n) {
  const auto count = static_cast<double>(n);
  std::vector<double> angle(n, 2 / count);
  angle[0] = -1 + 1 / count;
  const Chain<double> chain(std::vector<double>(n, 1 / count), std::vector<double>(n, count), angle);
  const double reach = end_point(chain, angle).x;
  double best = 0;
  for (int round = 0; round < 3; ++round) {
    const double start = processor_seconds();
    const Branch<double> branch = follow(chain, reach, 0.3, 0.05, 40);
    const double each = 1e6 * (processor_seconds() - start) / static_cast<double>(branch.points.size());
    if (round == 0 || each < best) best = each;
  }
  return best;
}

std::string row(const std::string& way, const Timed& timed, double ratio) {
  return fmt::format("| {} | {} | {:.2f} | {:.{}f} |\n", way, timed.points, timed.per_point(), ratio,
                     ratio < 100 ? 1 : 0);
}

std::string reached(double ratio, double aim) {
  return ratio >= aim ? "reached" : fmt::format("missed by a factor of {:.1f}", aim / ratio);
}

std::string report(const fs::path& folder) {
  std::string text = fmt::format(
      "# Following a path, beside peers\n\n"
      "`build/benchmarks/bench-path` writes this. The Z-chain of Table 1, end point held, from 0 to 1.5 L; "
      "processor time, one\n"
      "thread; best of 15 runs for Plumbline, of 5 for the peers. The peers' last Newton increment is "
      "below "
      "{}; every\n"
      "point of Plumbline is an equilibrium to rounding (tests/core/branch_series.test.cpp).\n\n"
      "| way | points | µs a point | ratio |\n|---|---|---|---|\n",
      tolerance);
  std::vector<double> script_ratio;
  std::vector<std::size_t> script_points;
  for (const double longest : {0.05, 0.005, 0.001}) {
    const Timed one = ours(longest), script = scipy(folder, longest);
    script_ratio.push_back(script.per_point() / one.per_point());
    script_points.push_back(one.points);
    text += row(fmt::format("Plumbline, points {} apart, types of all points and events", longest), one, 1);
    text +=
        row("SciPy `root` at the same points, types from the projected Hessian", script, script_ratio.back());
  }
  const Auto peer = auto07p(folder);
  const double path = 1.24;  // its length in our measure, radians
  const Timed fine = ours(path / static_cast<double>(peer.all.points));
  const double fine_ratio = peer.all.per_point() / fine.per_point();
  text += row("Plumbline, as many points as AUTO-07p, types of all points and events", fine, 1);
  text += row("AUTO-07p 0.9, fine steps, derivatives given, folds and branch points but no types", peer.all,
              fine_ratio);
  text += fmt::format(
      "\nThe time that AUTO prints itself (elapsed, on a machine that may be busy) is {:.3g} s, {:.2f} µs a "
      "point. "
      "Fine steps\n"
      "favour it: its beginning and its output do not count, and a short step takes few iterations.\n\n"
      "Aimed at are 300 times the speed of SciPy and 40 times that of AUTO-07p, per point. Plumbline's work "
      "is in "
      "16 strides,\n"
      "each a power series of order 30 that is exact to rounding as far as the nearest singularity lets it; "
      "a point "
      "on a stride\n"
      "is one evaluation of the series. So the ratios grow with the number of points: with {} (the default "
      "of `path`) "
      "the aim is\n"
      "{}; with {} it is {}. Beside AUTO-07p it is {}.\n\n"
      "The last table shows a point's cost along a chain's length. From n = 10^4 on the series outgrow the "
      "caches, and "
      "memory sets\n"
      "the pace.\n\n"
      "| links n | µs a point | ns a point and link |\n|---|---|---|\n",
      peer.own, 1e6 * peer.own / static_cast<double>(peer.all.points), script_points[1],
      reached(script_ratio[1], 300), script_points[0], reached(script_ratio[0], 300),
      reached(fine_ratio, 40));
  double of_a_thousand = 0, last = 0;  // a link
  for (const std::size_t n : {4U, 10U, 100U, 1000U, 10000U, 100000U}) {
    const double each = long_chain(n);
    last = each / static_cast<double>(n);
    if (n == 1000) of_a_thousand = last;
    text += fmt::format("| {} | {:.2f} | {:.1f} |\n", n, each, 1000 * last);
  }
  constexpr double aim = 1.5;
  const double ratio = last / of_a_thousand;
  return text +
         fmt::format("\nA link of 10^5 takes {:.2g} times as long as one of 1000; aimed at is {:.2g}: {}.\n",
                     ratio, aim, ratio <= aim ? "reached" : "missed");
}

int main_program() {
  std::string pattern = fs::temp_directory_path() / "plumbline-bench-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern, "no folder", "a place for the peers");
  const std::string text = report(pattern);
  fs::remove_all(pattern);
  std::ofstream(PATH_RESULTS) << text;
  fmt::print("{}", text);
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  try {
    return plumbline::bench::main_program();
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench-path: {}\n", error.what());
    return 1;
  }
}
