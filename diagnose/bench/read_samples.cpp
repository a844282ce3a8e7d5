#include "diagnose/bench/read_samples.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <plumbline/base/error.hpp>
#include <system_error>

#include "diagnose/bench/sample_columns.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The meaning of the fields of a table.
class Reader {
 public:
  Reader(const SampleTable& table, const SampleFormat& format, std::string source, Control control)
      : table_(table), format_(format), source_(std::move(source)), control_(control) {
    places_ = column_places(table, format, source_, control);
    for (std::size_t c = 0; c < places_.size(); ++c) {
      const Column& column = format_.columns[c];
      zeros_.push_back(zero(c));
      constants_.push_back(column.constant ? in_si(*column.constant, column.unit) : none);
    }
  }

  /// \param row  from 0
  [[nodiscard]] Reading reading(std::size_t row) const {
    std::vector<double> v;
    for (std::size_t c = 0; c < place_q1; ++c) v.push_back(value(c, row));
    Reading reading{v[place_t], v[place_x], v[place_y], v[place_Fx], v[place_Fy], {}};
    reading.q = angles(place_q1, format_.absolute_angles, row);
    reading.rest = angles(format_.place_command1(), format_.absolute_commands, row);
    require_given(reading, row);
    return reading;
  }

  [[nodiscard]] std::vector<Origin> origins() const {
    std::vector<Origin> all;
    for (std::size_t c = 0; c < places_.size(); ++c) {
      const Column& column = format_.columns[c];
      const std::string source = column.constant  ? "constant " + *column.constant
                                 : places_[c]     ? column_title(table_, *places_[c])
                                 : is_no_force(c) ? "constant 0"
                                                  : "";
      all.push_back({column.channel, source, column.unit.name, column.unit.in_si()});
    }
    return all;
  }

  void require_order(std::size_t row, const Reading& before, const Reading& now) const {
    if (now.t >= before.t) return;
    const auto time = [&](std::size_t r) { return table_.rows[r].fields[*places_[place_t]]; };
    throw Error(where(row) + ", t", files::shown(time(row)),
                "a time not before the last reading's, " + files::shown(time(row - 1)));
  }

 private:
  /// Relative joint angles; empty where the table has none.
  [[nodiscard]] std::vector<double> angles(std::size_t first, bool absolute, std::size_t row) const {
    std::vector<double> all;
    for (std::size_t c = first; c < first + format_.joints() && places_[c]; ++c) all.push_back(value(c, row));
    if (absolute) std::adjacent_difference(all.begin(), all.end(), all.begin());
    return all;
  }

  /// Whether no force acts on commanded joints, for want of a column.
  [[nodiscard]] bool is_no_force(std::size_t c) const {
    return format_.commanded && (c == place_Fx || c == place_Fy) && !places_[c] &&
           !format_.columns[c].constant;
  }

  [[nodiscard]] std::string where(std::size_t row) const {
    return source_ + ":" + std::to_string(table_.rows[row].line);
  }

  /// A field with a decimal point; empty for a missing value.
  [[nodiscard]] std::string field(std::size_t c, std::size_t row) const {
    std::string text = table_.rows[row].fields[*places_[c]];
    if (std::find(format_.missing.begin(), format_.missing.end(), text) != format_.missing.end()) return "";
    if (text.starts_with('+')) text.erase(0, 1);
    if (format_.decimal == '.') return text;
    if (text.find('.') != std::string::npos) refuse(c, row);
    std::replace(text.begin(), text.end(), ',', '.');
    return text;
  }

  [[noreturn]] void refuse(std::size_t c, std::size_t row) const {
    const std::string& text = table_.rows[row].fields[*places_[c]];
    const bool comma = format_.decimal == '.' && text.find(',') != std::string::npos;
    throw Error(where(row) + ", " + files::shown(column_title(table_, *places_[c])),
                "'" + files::shown(text) + "'",
                std::string("a finite number or an empty field") +
                    (comma ? "; csv.decimal = \",\" reads decimal commas" : ""));
  }

  [[nodiscard]] double number(const std::string& text, std::size_t c, std::size_t row) const {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || stop != end || !std::isfinite(value)) refuse(c, row);
    return value;
  }

  [[nodiscard]] Mpfr50 zero(std::size_t c) const {
    const Column& column = format_.columns[c];
    for (std::size_t row = 0; column.zero_is_first && places_[c] && row < table_.rows.size(); ++row) {
      const std::string text = field(c, row);
      if (!text.empty() && std::isfinite(number(text, c, row))) return Mpfr50(text);
    }
    return Mpfr50(column.zero);
  }

  /// Readings without a time are counted; a channel without a column is not measured.
  [[nodiscard]] double value(std::size_t c, std::size_t row) const {
    const Column& column = format_.columns[c];
    if (column.constant) return constants_[c];
    if (is_no_force(c)) return 0;
    if (!places_[c]) return c == place_t ? static_cast<double>(row) : none;
    const std::string text = field(c, row);
    if (text.empty()) return none;
    const double plain = number(text, c, row);
    if (column.as_is()) return plain;
    const Mpfr50 exact = Mpfr50(column.sign) * (Mpfr50(text) - zeros_[c]) * column.unit.factor;
    return exact.convert_to<double>();
  }

  void require_given(const Reading& r, std::size_t row) const {
    if (std::isnan(r.t)) throw Error(where(row) + ", t", "an empty field", "the time of the reading");
    const bool displacement = control_ == Control::end_point;
    if (std::isnan(displacement ? r.x : r.Fx) || std::isnan(displacement ? r.y : r.Fy)) {
      const std::size_t first = displacement ? place_x : place_Fx, second = displacement ? place_y : place_Fy;
      const auto& name = format_.columns;
      throw Error(where(row), "an empty imposed channel",
                  "the commanded " + name[first].channel +
                      (format_.alone == Alone::no ? " and " + name[second].channel : ""));
    }
    if (std::any_of(r.rest.begin(), r.rest.end(), [](double angle) { return std::isnan(angle); }))
      throw Error(where(row), "an empty q_command", "the commanded angle of every joint");
  }

  const SampleTable& table_;
  const SampleFormat& format_;
  std::string source_;
  Control control_;
  ColumnPlaces places_;
  std::vector<Mpfr50> zeros_;      ///< by column of the format
  std::vector<double> constants_;  ///< likewise, in SI
};

}  // namespace

Samples read_samples(const SampleTable& table, const std::string& source, Control control,
                     const SampleFormat& format) {
  const Reader reader(table, format, source, control);
  Samples samples{{}, reader.origins()};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    samples.readings.push_back(reader.reading(row));
    if (row > 0) reader.require_order(row, samples.readings[row - 1], samples.readings[row]);
  }
  return samples;
}

}  // namespace plumbline::diagnose
