#include "diagnose/read_samples.hpp"

#include <csv.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <plumbline/error.hpp>
#include <system_error>
#include <utility>

namespace plumbline {
namespace {

using Line = std::vector<std::string>;

struct Table {
  std::vector<Line> lines;
  Line open;
};

void end_field(void* text, std::size_t size, void* table) {
  static_cast<Table*>(table)->open.emplace_back(static_cast<const char*>(text), size);
}

void end_line(int, void* data) {
  auto* table = static_cast<Table*>(data);
  table->lines.push_back(std::exchange(table->open, {}));
}

std::string contents(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw Error(file.string(), "no such file", "a sample file");
  if (!std::filesystem::is_regular_file(file))
    throw Error(file.string(), "something that is not a file", "a sample file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string(), "a file that cannot be read", "a readable sample file");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::erase(text, '\r');
  return text;
}

std::vector<Line> parse(const std::filesystem::path& file) {
  const std::string text = contents(file);
  Table table;
  csv_parser parser;
  // Unquoted line ends are all reported, so that a line's number in the file is its number here.
  csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL);
  const bool good =
      csv_parse(&parser, text.data(), text.size(), end_field, end_line, &table) == text.size() &&
      csv_fini(&parser, end_field, end_line, &table) == 0;
  csv_free(&parser);
  if (!good) {
    throw Error(file.string() + ":" + std::to_string(table.lines.size() + 1), "a quotation mark out of place",
                "plain comma-separated numbers");
  }
  return table.lines;
}

std::string place(const std::filesystem::path& file, std::size_t line) {
  return file.string() + ":" + std::to_string(line + 1);
}

double number(const std::string& field, const std::string& where) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, fault] = std::from_chars(field.data() + (field.front() == '+' ? 1 : 0), end, value);
  if (fault != std::errc() || stop != end || !std::isfinite(value))
    throw Error(where, "'" + field + "'", "a finite number or an empty field");
  return value;
}

Line expected_header(std::size_t joints) {
  Line names{"t", "x", "y", "Fx", "Fy"};
  for (std::size_t i = 1; i <= joints; ++i) names.push_back("q" + std::to_string(i));
  return names;
}

std::string joined(const Line& fields) {
  std::string text;
  for (const std::string& field : fields) text += (text.empty() ? "" : ",") + field;
  return text;
}

void require_header(const Line& found, const std::filesystem::path& file, std::size_t joints) {
  if (found == expected_header(0) || found == expected_header(joints)) return;
  throw Error(place(file, 0), "the header '" + joined(found) + "'",
              "'" + joined(expected_header(0)) + "' or '" + joined(expected_header(joints)) + "'");
}

Reading reading(const std::vector<double>& v) {
  return {v[0], v[1], v[2], v[3], v[4], std::vector<double>(v.begin() + 5, v.end())};
}

void require_given(const Reading& r, Control control, const std::string& where) {
  if (std::isnan(r.t)) throw Error(where + ", t", "an empty field", "the time of the reading");
  const bool displacement = control == Control::displacement;
  if (std::isnan(displacement ? r.x : r.Fx) || std::isnan(displacement ? r.y : r.Fy)) {
    throw Error(where, "an empty imposed channel",
                displacement ? "the commanded x and y" : "the commanded Fx and Fy");
  }
}

}  // namespace

std::vector<Reading> read_samples(const std::filesystem::path& file, Control control, std::size_t joints) {
  std::vector<Line> lines = parse(file);
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  if (lines.empty()) throw Error(file.string(), "an empty file", "a header line and readings");
  require_header(lines.front(), file, joints);
  if (lines.size() == 1) throw Error(file.string(), "a header alone", "at least one reading");
  std::vector<Reading> readings;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string where = place(file, i);
    if (lines[i].size() != lines[0].size()) {
      throw Error(where, std::to_string(lines[i].size()) + " fields",
                  std::to_string(lines[0].size()) + ", as in the header");
    }
    std::vector<double> values;
    for (std::size_t c = 0; c < lines[i].size(); ++c)
      values.push_back(number(lines[i][c], where + ", " + lines[0][c]));
    readings.push_back(reading(values));
    require_given(readings.back(), control, where);
    if (i > 1 && readings[i - 1].t < readings[i - 2].t) {
      throw Error(where + ", t", lines[i][0], "a time not before the last reading's, " + lines[i - 1][0]);
    }
  }
  return readings;
}

}  // namespace plumbline
