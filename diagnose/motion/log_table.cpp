#include "diagnose/motion/log_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::motion {

LogTable::LogTable(const std::string& text, std::string source)
    : LogTable(files::parse_csv(text, source), source) {}

LogTable::LogTable(std::vector<files::CsvRow> rows, std::string source)
    : source_(std::move(source)), rows_(std::move(rows)) {
  if (rows_.size() < 2) throw Error(source_, "a header alone", "rows of numbers");
  for (const files::CsvRow& row : rows_)
    if (row.fields.size() != rows_.front().fields.size())
      throw Error(fmt::format("{}:{}", source_, row.line), fmt::format("{} fields", row.fields.size()),
                  fmt::format("{}, as the header has", rows_.front().fields.size()));
}

std::string LogTable::place(std::size_t row) const {
  return fmt::format("{}:{}", source_, rows_[row + 1].line);
}

std::size_t LogTable::column(const std::string& name, const std::string& place) const {
  const std::vector<std::string>& header = rows_.front().fields;
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw Error(place, fmt::format("no column '{}' in {}", files::printable(name), source_),
                "one of " + files::shown(fmt::format("{}", fmt::join(header, " "))));
  return static_cast<std::size_t>(found - header.begin());
}

std::vector<double> LogTable::numbers(const std::string& name) const {
  const std::size_t number = column(name, source_ + ":1");
  std::vector<double> all;
  for (std::size_t i = 0; i < rows(); ++i)
    all.push_back(number_in(entry(i, number), fmt::format("{}, column {}", place(i), name)));
  return all;
}

double number_in(const std::string& field, const std::string& place) {
  double value = 0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value))
    throw Error(place, "'" + files::shown(field) + "'", "a number");
  return value;
}

}  // namespace plumbline::motion
