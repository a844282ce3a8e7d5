#pragma once
/// \file
/// Diagnoses of benches that are written as a user writes them: experiment.toml, and a table whose measured
/// columns are what the bench would read with a cause, with noise.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "tests/folder.hpp"

namespace plumbline::diagnose::test {

using Told = std::function<double(double t)>;

/// What is imposed, by time; or, of no word for that, what a channel of this label reads.
struct TableColumn {
  std::string name;
  Told told;
  std::string reads = {};
};

struct WrittenBench {
  std::string settings;
  std::vector<TableColumn> columns;
};

inline Experiment read_as_written(const WrittenBench& bench, const std::string& table) {
  const Folder folder;
  folder.write("experiment.toml", bench.settings);
  folder.write("t.csv", table);
  return read_experiment(folder.path());
}

/// A reading every 0.4 s, not quite evenly.
inline std::string table_of(const WrittenBench& bench,
                            const std::function<double(const std::string& label, int row)>& read) {
  std::string text = "t";
  for (const TableColumn& column : bench.columns) text += "," + column.name;
  for (int i = 0; i < 48; ++i) {
    const double t = 0.4 * i + 0.05 * (i % 3);
    text += fmt::format("\n{:.9g}", t);
    for (const TableColumn& column : bench.columns)
      text += fmt::format(",{:.9g}", column.told ? column.told(t) : read(column.reads, i));
  }
  return text + "\n";
}

/// The bench before anything is read: all that will be is 0, or slowly more.
inline Experiment unread(const WrittenBench& bench) {
  const auto reads_angle = [](const TableColumn& one) { return one.reads.starts_with("q"); };
  const auto named_x = [](const TableColumn& one) { return one.name == "x"; };
  WrittenBench few = bench;
  // Angles would be held against a place that stands beside them.
  if (std::ranges::any_of(bench.columns, named_x)) std::erase_if(few.columns, reads_angle);
  Experiment experiment =
      read_as_written(few, table_of(few, [](const std::string&, int row) { return 0.01 * row; }));
  if (std::ranges::any_of(bench.columns, reads_angle))
    for (Reading& reading : experiment.runs[0].readings)
      for (std::size_t j = 0; j < experiment.link_length.size(); ++j)
        Channel(Channel::Name::q, j).in(reading) = 0;
  return experiment;
}

/// What the bench reads with this cause.
inline Study planted(const WrittenBench& bench, const Candidate& cause, const std::vector<double>& values) {
  const Study bare(unread(bench));
  const Prediction truth = predict(bare, cause, values);
  REQUIRE(truth.reached);
  const std::vector<Channel> channels = bare.experiment().runs[0].measured();
  std::mt19937 engine(11);
  std::normal_distribution<double> normal;
  const auto read = [&](const std::string& label, int row) {
    const auto channel = std::ranges::find(channels, label, &Channel::label);
    REQUIRE(channel != channels.end());
    return truth.runs[0](row, channel->column) + channel->sigma(bare.experiment().noise) * normal(engine);
  };
  return Study(read_as_written(bench, table_of(bench, read)));
}

/// Checks that the cause is named alone. \returns what else is said of it
inline Diagnosis check_named(const WrittenBench& bench, const Candidate& cause,
                             const std::vector<double>& values) {
  CAPTURE(cause.name());
  const Diagnosis found = diagnose::diagnose(planted(bench, cause, values));
  REQUIRE(!found.cause.ranking.empty());
  CAPTURE(found.cause.ranking[0].cause.label());
  CHECK(found.cause.named == 1);
  CHECK(found.cause.ranking[0].cause.is_form_of(cause));
  return found;
}

inline Told sine(double middle, double size, double rate, double phase = 0) {
  return [=](double t) { return middle + size * std::sin(rate * t + phase); };
}

}  // namespace plumbline::diagnose::test
