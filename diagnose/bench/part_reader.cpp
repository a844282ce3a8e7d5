#include "diagnose/bench/part_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <system_error>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

}  // namespace

PartReader::PartReader(const SamplePart& part, const ColumnPlaces& places, const PartReader* before)
    : part_(part), places_(places) {
  if (before != nullptr) readings_before_ = before->readings_before_ + before->rows();
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const Column& column = format().columns[c];
    zeros_.push_back(before != nullptr && column.zero_is_first ? before->zeros_[c] : zero(c));
    constants_.push_back(column.constant ? in_si(*column.constant, column.unit) : not_given);
  }
}

std::string PartReader::written_time(std::size_t row) const {
  return files::shown(part_.table.rows[row].fields[*places_[place_t]]);
}

double PartReader::value(std::size_t c, std::size_t row) const {
  const Column& column = format().columns[c];
  if (column.constant) return constants_[c];
  if (is_no_force(c)) return 0;
  if (!places_[c]) return c == place_t ? static_cast<double>(readings_before_ + row) : not_given;
  const std::string text = field(c, row);
  if (text.empty()) return not_given;
  const double plain = number(text, c, row);
  if (column.as_is()) return plain;
  const Mpfr50 exact = Mpfr50(column.sign) * (Mpfr50(text) - zeros_[c]) * column.unit.factor;
  return exact.convert_to<double>();
}

bool PartReader::is_empty(std::size_t row) const {
  for (std::size_t c = place_t + 1; c < places_.size(); ++c)
    if (places_[c] && !is_missing(part_.table.rows[row].fields[*places_[c]])) return false;
  return true;
}

Origin PartReader::origin(std::size_t c) const {
  const Column& column = format().columns[c];
  const std::string from = column.constant  ? "constant " + *column.constant
                           : places_[c]     ? column_title(part_.table, *places_[c])
                           : is_no_force(c) ? "constant 0"
                                            : "";
  return {column.channel, from, column.unit.name, column.unit.in_si()};
}

/// Whether no force acts on commanded joints, for want of a column.
bool PartReader::is_no_force(std::size_t c) const {
  return format().commanded && (c == place_Fx || c == place_Fy) && !has(c);
}

bool PartReader::is_missing(const std::string& field) const {
  const std::vector<std::string>& entries = format().missing;
  return field.empty() || std::find(entries.begin(), entries.end(), field) != entries.end();
}

/// A field with a decimal point; empty for a missing value.
std::string PartReader::field(std::size_t c, std::size_t row) const {
  std::string text = part_.table.rows[row].fields[*places_[c]];
  if (is_missing(text)) return "";
  if (text.starts_with('+')) text.erase(0, 1);
  if (format().decimal == '.') return text;
  if (text.find('.') != std::string::npos) refuse(c, row);
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

void PartReader::refuse(std::size_t c, std::size_t row) const {
  const std::string& text = part_.table.rows[row].fields[*places_[c]];
  const bool comma = format().decimal == '.' && text.find(',') != std::string::npos;
  throw Error(where(row) + ", " + files::shown(column_title(part_.table, *places_[c])),
              "'" + files::shown(text) + "'",
              std::string("a finite number or an empty field") +
                  (comma ? "; csv.decimal = \",\" reads decimal commas" : ""));
}

double PartReader::number(const std::string& text, std::size_t c, std::size_t row) const {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end || !std::isfinite(value)) refuse(c, row);
  return value;
}

/// The reading that stands for 0.
Mpfr50 PartReader::zero(std::size_t c) const {
  const Column& column = format().columns[c];
  for (std::size_t row = 0; column.zero_is_first && places_[c] && row < rows(); ++row) {
    const std::string text = field(c, row);
    if (!text.empty() && std::isfinite(number(text, c, row))) return Mpfr50(text);
  }
  return Mpfr50(column.zero);
}

}  // namespace plumbline::diagnose
