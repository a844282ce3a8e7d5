#include "diagnose/bench/read_samples.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <system_error>

#include "files/csv_file.hpp"
#include "files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Fields = std::vector<std::string>;

std::string place(const std::string& source, std::size_t line) {
  return source + ":" + std::to_string(line);
}

double number(const std::string& field, const std::string& where) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, fault] = std::from_chars(field.data() + (field.front() == '+' ? 1 : 0), end, value);
  if (fault != std::errc() || stop != end || !std::isfinite(value))
    throw Error(where, "'" + files::shown(field) + "'", "a finite number or an empty field");
  return value;
}

Fields expected_header(std::size_t joints) {
  Fields names{"t", "x", "y", "Fx", "Fy"};
  for (std::size_t i = 1; i <= joints; ++i) names.push_back("q" + std::to_string(i));
  return names;
}

std::string joined(const Fields& fields) {
  std::string text;
  for (const std::string& field : fields) text += (text.empty() ? "" : ",") + field;
  return text;
}

void require_header(const files::CsvRow& found, const std::string& source, std::size_t joints) {
  if (found.fields == expected_header(0) || found.fields == expected_header(joints)) return;
  throw Error(place(source, found.line), "the header '" + files::shown(joined(found.fields)) + "'",
              "'" + joined(expected_header(0)) + "' or '" + joined(expected_header(joints)) + "'");
}

Reading reading(const std::vector<double>& v) {
  return {v[0], v[1], v[2], v[3], v[4], std::vector<double>(v.begin() + 5, v.end())};
}

void require_given(const Reading& r, Control control, const std::string& where) {
  if (std::isnan(r.t)) throw Error(where + ", t", "an empty field", "the time of the reading");
  const bool displacement = control == Control::end_point;
  if (std::isnan(displacement ? r.x : r.Fx) || std::isnan(displacement ? r.y : r.Fy)) {
    throw Error(where, "an empty imposed channel",
                displacement ? "the commanded x and y" : "the commanded Fx and Fy");
  }
}

}  // namespace

std::vector<Reading> parse_samples(const std::string& text, const std::string& source, Control control,
                                   std::size_t joints) {
  const std::vector<files::CsvRow> rows = files::parse_csv(text, source);
  const Fields& header = rows.front().fields;
  require_header(rows.front(), source, joints);
  if (rows.size() == 1) throw Error(source, "a header alone", "at least one reading");
  std::vector<Reading> readings;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Fields& fields = rows[r].fields;
    const std::string where = place(source, rows[r].line);
    if (fields.size() != header.size()) {
      throw Error(where, std::to_string(fields.size()) + " fields",
                  std::to_string(header.size()) + ", as in the header");
    }
    std::vector<double> values;
    for (std::size_t c = 0; c < fields.size(); ++c)
      values.push_back(number(fields[c], where + ", " + header[c]));
    readings.push_back(reading(values));
    require_given(readings.back(), control, where);
    if (r > 1 && readings[r - 1].t < readings[r - 2].t) {
      throw Error(where + ", t", fields[0], "a time not before the last reading's, " + rows[r - 1].fields[0]);
    }
  }
  return readings;
}

}  // namespace plumbline::diagnose
