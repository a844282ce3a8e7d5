/// \file
/// `bench-growth`: what critical forces, modes, tables of chains, paths, censuses and diagnoses cost in time
/// and memory as they grow. Prints a table, puts it between the markers in benchmarks/RESULTS-growth.md and
/// draws it beside it. `bench-growth --check` writes nothing: it fails where a power has risen above the one
/// in that table.

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>
#include <sstream>

#include "benchmarks/race.hpp"
#include "benchmarks/random_chain.hpp"
#include "benchmarks/results.hpp"
#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/decimate.hpp"
#include "proofs/census/census.hpp"
#include "proofs/exact/critical_modes.hpp"

namespace plumbline::bench {
namespace {

const std::string document = PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-growth.md";
const std::string drawing = PLUMBLINE_SOURCE_DIR "/benchmarks/growth.svg";

/// The chains of this table, always the same.
Chain<Rational> random_chain(std::size_t links) {
  static std::mt19937 random(1);
  return bench::random_chain(links, random);
}

/// A curved beam of n links, compressed over its ends through forty points.
void follow_beam(std::size_t n) {
  using Model = NominalModel<double>;
  const auto count = static_cast<double>(n);
  std::vector<double> angle(n, 2 / count);
  angle[0] = -1 + 1 / count;
  const Chain<double> chain(std::vector<double>(n, 1 / count), std::vector<double>(n, count), angle);
  const Model model(chain);
  const Vector<double> shape = absolute_angles(chain.rest());
  Brancher<Model> brancher(model, {Control::end_point, {end_point(chain, angle).x, 0}, {-1, 0}}, shape);
  Tracer<Model>(brancher, {0, 0.3, 0.05, 40}).run(brancher.start(0, shape));
}

/// All equilibria, certified, of five random chains of so many links, their end points pushed in.
void take_censuses(std::size_t links) {
  std::mt19937 random(1);
  const auto thousandths = [&](int low, int high) {
    return Interval(Rational(std::uniform_int_distribution<int>(low, high)(random), 1000));
  };
  for (int c = 0; c < 5; ++c) {
    std::vector<Interval> length, stiffness, rest;
    for (std::size_t i = 0; i < links; ++i) {
      length.push_back(thousandths(800, 1200));
      stiffness.push_back(thousandths(800, 1200));
      rest.push_back(thousandths(-500, 500));
    }
    const Chain<Interval> chain(length, stiffness, rest);
    Point<Interval> place = end_point(chain, chain.rest());
    place.x -= Interval(Rational(1, 2));
    place.y += Interval(Rational(1, 10));
    proofs::census_at_end_point(chain, place);
  }
}

/// Presses on a chain of so many links, one of whose springs is soft, in turn along x and aslant: so many
/// runs with so many readings together, with noise.
diagnose::Experiment pressed(std::size_t links, std::size_t runs, std::size_t readings) {
  diagnose::Experiment experiment;
  experiment.name = "pressed";
  experiment.link_length.assign(links, 1.0 / static_cast<double>(links));
  experiment.joint_stiffness.assign(links, 0.5 * static_cast<double>(links));
  experiment.link_mass.assign(links, 0);
  experiment.gravity = {0, 0};
  experiment.bench = {diagnose::Bench::Plane::horizontal, {0, 0}, false};
  experiment.noise = {0, 0, 0.02, 0.02, 0};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-1, 1);
  for (std::size_t r = 0; r < runs; ++r) {
    diagnose::Run run{fmt::format("run-{}", r + 1), Control::end_point, {}, {}};
    for (std::size_t j = 0; j < links; ++j) run.rest.push_back(angle(random) / std::sqrt(double(links)));
    double theta = 0, x = 0, y = 0;
    for (std::size_t j = 0; j < links; ++j) {
      theta += run.rest[j];
      x += experiment.link_length[j] * std::cos(theta);
      y += experiment.link_length[j] * std::sin(theta);
    }
    const std::size_t count = readings / runs;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = 1 - std::abs(1 - 2 * static_cast<double>(i) / static_cast<double>(count - 1));
      run.readings.push_back(
          {static_cast<double>(i), {x - 0.1 * share, y + (r % 2 == 0 ? 0 : 0.05) * share, 0, 0}});
    }
    experiment.runs.push_back(std::move(run));
  }
  const diagnose::Study study(experiment);
  const diagnose::Candidate soft{{{"joint_stiffness", 2}}};
  const auto predicted = predict(study, soft, {study.ranges(soft)[0].scale / 2});
  std::normal_distribution<double> noise(0, experiment.noise[diagnose::Channel::Name::Fx]);
  for (std::size_t r = 0; r < runs; ++r) {
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
      diagnose::Reading& reading = experiment.runs[r].readings[i];
      reading[diagnose::column_Fx] =
          predicted.runs[r](static_cast<Eigen::Index>(i), diagnose::column_Fx) + noise(random);
      reading[diagnose::column_Fy] =
          predicted.runs[r](static_cast<Eigen::Index>(i), diagnose::column_Fy) + noise(random);
    }
  }
  return experiment;
}

using Job = std::function<void()>;

struct Work {
  std::string name, sizes;                  ///< sizes: of what
  std::function<Job(std::size_t)> prepare;  ///< what is to be timed, its input made
  std::string expected;                     ///< the power of the size
  std::vector<std::size_t> size;
};

std::vector<Work> all_work() {
  constexpr std::size_t all = 1000000;
  const auto of_a_chain = [](auto compute, std::size_t modes, int digits) {
    return [=](std::size_t links) -> Job {
      return [=, chain = random_chain(links)] { compute(chain, modes, digits); };
    };
  };
  const auto table = [](std::size_t chains) -> Job {
    return [=] {
      for (std::size_t c = 0; c < chains; ++c) proofs::forces_in_decimals(random_chain(4), 1, 15);
    };
  };
  const auto beam = [](std::size_t links) -> Job { return [=] { follow_beam(links); }; };
  const auto census = [](std::size_t links) -> Job { return [=] { take_censuses(links); }; };
  const auto diagnosis = [](diagnose::Experiment experiment) -> Job {
    return [experiment = std::move(experiment)] {
      diagnose::diagnose(diagnose::Study(diagnose::decimated(experiment)));
    };
  };
  const auto of_readings = [=](std::size_t readings) { return diagnosis(pressed(4, 1, readings)); };
  const auto of_runs = [=](std::size_t runs) { return diagnosis(pressed(4, runs, 40 * runs)); };
  const auto of_links = [=](std::size_t links) { return diagnosis(pressed(links, 2, 200)); };
  const auto &forces = proofs::forces_in_decimals, &modes = proofs::modes_in_decimals;
  return {{"all forces, 15 digits", "links", of_a_chain(forces, all, 15), "2", {250, 500, 1000, 2000}},
          {"all forces, 40 digits", "links", of_a_chain(forces, all, 40), "2", {125, 250, 500, 1000}},
          {"all modes, 15 digits", "links", of_a_chain(modes, all, 15), "2", {125, 250, 500, 1000}},
          {"lowest force, 15 digits", "links", of_a_chain(forces, 1, 15), "1", {1000, 10000, 100000}},
          {"lowest force, 40 digits", "links", of_a_chain(forces, 1, 40), "1", {1000, 10000, 100000}},
          {"a table of four-link chains", "chains", table, "1", {1000, 10000, 100000}},
          {"forty points of a path", "links", beam, "1", {1000, 10000, 100000}},
          {"five censuses, end point held", "links", census, "exponential", {2, 3, 4, 5, 6}},
          {"a diagnosis of one run, four links", "readings", of_readings, "0", {1000, 10000, 100000}},
          {"a diagnosis, 40 readings a run, four links", "runs", of_runs, "1", {1, 5, 20, 50}},
          {"a diagnosis of two runs, 200 readings", "links", of_links, "2", {3, 10, 30}}};
}

struct Cost {
  double seconds;    ///< of all processors together
  double megabytes;  ///< at most at once
};

/// In a process of its own, whose memory is not that of the rows before. What it makes first is in the memory
/// and not in the time.
Cost cost(const Work& work, std::size_t size) {
  int ends[2];
  if (pipe(ends) != 0) throw Error(work.name, "no pipe", "one to a process");
  const pid_t child = fork();
  if (child == 0) {
    const Job job = work.prepare(size);
    const double start = processor_seconds();
    job();
    const double seconds = processor_seconds() - start;
    std::_Exit(::write(ends[1], &seconds, sizeof seconds) == sizeof seconds ? 0 : 1);
  }
  close(ends[1]);
  double seconds = 0;
  const bool told = ::read(ends[0], &seconds, sizeof seconds) == sizeof seconds;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0 || !told)
    throw Error(work.name, "no end", "a run to the end");
  return {seconds, static_cast<double>(usage.ru_maxrss) / 1024};
}

std::vector<Cost> costs(const Work& work) {
  std::vector<Cost> all;
  for (const std::size_t size : work.size) all.push_back(cost(work, size));
  return all;
}

/// The power of the size that the time grows with over the last step.
double power(const Work& work, const std::vector<Cost>& all) {
  const std::size_t last = work.size.size() - 1;
  return std::log(all[last].seconds / all[last - 1].seconds) /
         std::log(double(work.size[last]) / double(work.size[last - 1]));
}

std::string row(const Work& work, const std::vector<Cost>& all) {
  std::string sizes, seconds, memory;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* const between = i == 0 ? "" : ", ";
    sizes += fmt::format("{}{}", between, work.size[i]);
    seconds += fmt::format("{}{:.3g}", between, all[i].seconds);
    memory += fmt::format("{}{:.0f}", between, all[i].megabytes);
  }
  return fmt::format("| {} | {} {} | {} | {} | {:.1f} | {} |\n", work.name, sizes, work.sizes, seconds,
                     memory, power(work, all), work.expected);
}

/// The powers in the table as it is stored, by work.
std::map<std::string, double> stored() {
  std::map<std::string, double> powers;
  std::ifstream file(document);
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, '|');) cells.push_back(cell);
    if (cells.size() == 7 && cells[0].empty() && cells[5].find_first_of("0123456789") == 1)
      powers[cells[1].substr(1, cells[1].size() - 2)] = std::stod(cells[5]);
  }
  return powers;
}

/// Powers over one step, of times taken once, are good to two tenths where it is a doubling; half a power is
/// a change. So is over a shorter step what adds half to the time.
double change(const Work& work) {
  const std::size_t last = work.size.size() - 1;
  return std::max(0.5, std::log(1.5) / std::log(double(work.size[last]) / double(work.size[last - 1])));
}

int check() {
  const auto before = stored();
  int risen = 0;
  for (const Work& work : all_work()) {
    const double now = power(work, costs(work)), then = before.at(work.name);
    std::cout << fmt::format("{}: {:.1f}, was {:.1f}\n", work.name, now, then);
    if (now > then + change(work)) ++risen;
  }
  return risen == 0 ? 0 : 1;
}

void draw(const std::vector<Work>& all, const std::vector<std::vector<Cost>>& found) {
  FILE* const plot = popen("gnuplot", "w");
  if (plot == nullptr) throw Error("gnuplot", "no program", "one that draws");
  std::string text = fmt::format(
      "set terminal svg size 900,540 font 'sans-serif,13'\nset output '{}'\nset logscale xy\nset grid\n"
      "set key outside right\nset xlabel 'links, chains, readings, or runs'\nset ylabel 'processor time, "
      "s'\nplot ",
      drawing);
  for (std::size_t w = 0; w < all.size(); ++w)
    text += fmt::format("{}'-' with linespoints title '{}'", w == 0 ? "" : ", ", all[w].name);
  text += "\n";
  for (std::size_t w = 0; w < all.size(); ++w) {
    for (std::size_t i = 0; i < found[w].size(); ++i)
      text += fmt::format("{} {}\n", all[w].size[i], found[w][i].seconds);
    text += "e\n";
  }
  std::fputs(text.c_str(), plot);
  if (pclose(plot) != 0) throw Error("gnuplot", "a failure", drawing);
}

void write() {
  std::string table = fmt::format("Written by `build/benchmarks/bench-growth` on {}.\n\n", processor_name()) +
                      "| work | sizes | processor time, s | memory, MB | power, last step | expected |\n"
                      "|---|---|---|---|--:|--:|\n";
  std::cout << table << std::flush;
  const std::vector<Work> all = all_work();
  std::vector<std::vector<Cost>> found;
  for (const Work& work : all) {
    found.push_back(costs(work));
    const std::string line = row(work, found.back());
    std::cout << line << std::flush;
    table += line;
  }
  put_into(document, "bench-growth", table);
  draw(all, found);
}

}  // namespace
}  // namespace plumbline::bench

int main(int count, char** arguments) {
  try {
    if (count > 1 && arguments[1] == std::string("--check")) return plumbline::bench::check();
    plumbline::bench::write();
  } catch (const std::exception& error) {
    std::cerr << "bench-growth: " << error.what() << '\n';
    return 2;
  }
}
