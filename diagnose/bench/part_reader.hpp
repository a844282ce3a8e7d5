#pragma once
/// \file
/// The meaning of the fields of one part of a run's samples.

#include <limits>
#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/sample_columns.hpp"

namespace plumbline::diagnose {

/// Rows and columns count from 0, columns those of the format. Both arguments outlive it.
class PartReader {
 public:
  /// \param before  the part that this one follows, whose first readings are zeros; or nullptr
  PartReader(const SamplePart& part, const ColumnPlaces& places, const PartReader* before);

  [[nodiscard]] const SampleFormat& format() const { return part_.format; }
  [[nodiscard]] const std::string& source() const { return part_.source; }
  [[nodiscard]] std::size_t rows() const { return part_.table.rows.size(); }
  /// Whether a column of the table, or a constant, says it.
  [[nodiscard]] bool has(std::size_t c) const { return places_[c] || format().columns[c].constant; }

  /// "press.csv:7".
  [[nodiscard]] std::string where(std::size_t row) const { return part_.table.place_of(row, source()); }
  /// The time as it is written.
  [[nodiscard]] std::string written_time(std::size_t row) const;
  /// In SI; NaN for an empty field. Readings without a time are counted; a channel without a column is not
  /// measured.
  /// \throws Error for a field that is no finite number
  [[nodiscard]] double value(std::size_t c, std::size_t row) const;
  /// Whether nothing but the time has a value in a row.
  [[nodiscard]] bool is_empty(std::size_t row) const;
  [[nodiscard]] Origin origin(std::size_t c) const;

 private:
  /// Whether it is the force on an end point that is free for want of a column.
  [[nodiscard]] bool is_no_force(std::size_t c) const;
  [[nodiscard]] std::string field(std::size_t c, std::size_t row) const;
  [[nodiscard]] Mpfr50 zero(std::size_t c) const;

  const SamplePart& part_;
  const ColumnPlaces& places_;
  std::size_t readings_before_ = 0;  ///< of the parts that this one follows
  std::vector<Mpfr50> zeros_;        ///< by column of the format
  std::vector<double> constants_;    ///< likewise, in SI
};

}  // namespace plumbline::diagnose
