#include "diagnose/bench/part_reader.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "diagnose/bench/field.hpp"
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
  return files::shown(part_.table.rows[row].fields[*places_.front()]);
}

double PartReader::value(std::size_t c, std::size_t row) const {
  const Column& column = format().columns[c];
  if (column.constant) return constants_[c];
  if (is_no_force(c)) return 0;
  if (!places_[c]) return column.says == Says::time ? static_cast<double>(readings_before_ + row) : not_given;
  const std::string text = field(c, row);
  if (text.empty() || column.as_is()) return nearest_double(text);
  const Mpfr50 exact = Mpfr50(column.sign) * (Mpfr50(text) - zeros_[c]) * column.unit.factor;
  return exact.convert_to<double>();
}

bool PartReader::is_empty(std::size_t row) const {
  for (std::size_t c = 1; c < places_.size(); ++c)
    if (places_[c] && !is_missing(part_.table.rows[row].fields[*places_[c]], format())) return false;
  return true;
}

Origin PartReader::origin(std::size_t c) const {
  const Column& column = format().columns[c];
  const std::string from = column.constant  ? "constant " + *column.constant
                           : places_[c]     ? column_title(part_.table, *places_[c])
                           : is_no_force(c) ? "constant 0"
                                            : "";
  return {column.channel,      from,         column.unit.name,
          column.unit.in_si(), column.reads, column.quantity ? column.quantity->si : ""};
}

bool PartReader::is_no_force(std::size_t c) const {
  return format().free_end && format().columns[c].reads_any(format().end().load) && !has(c);
}

/// A number with a decimal point; empty for a missing value.
std::string PartReader::field(std::size_t c, std::size_t row) const {
  const std::string& text = part_.table.rows[row].fields[*places_[c]];
  std::optional<std::string> decimal = decimal_in(text, format());
  if (!decimal)
    refuse_field(text, format(), where(row) + ", " + files::shown(column_title(part_.table, *places_[c])));
  return *std::move(decimal);
}

/// The reading that stands for 0.
Mpfr50 PartReader::zero(std::size_t c) const {
  const Column& column = format().columns[c];
  for (std::size_t row = 0; column.zero_is_first && places_[c] && row < rows(); ++row) {
    const std::string text = field(c, row);
    if (!text.empty()) return Mpfr50(text);
  }
  return Mpfr50(column.zero);
}

}  // namespace plumbline::diagnose
