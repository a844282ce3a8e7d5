#include "diagnose/bench/field.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <system_error>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {

bool is_missing(const std::string& field, const SampleFormat& format) {
  return field.empty() ||
         std::find(format.missing.begin(), format.missing.end(), field) != format.missing.end();
}

double nearest_double(const std::string& decimal) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const char* const end = decimal.data() + decimal.size();
  const auto [stop, fault] = std::from_chars(decimal.data(), end, value);
  return fault == std::errc() && stop == end ? value : std::numeric_limits<double>::quiet_NaN();
}

std::optional<std::string> decimal_in(const std::string& field, const SampleFormat& format) {
  if (is_missing(field, format)) return "";
  std::string text = field;
  if (text.starts_with('+')) text.erase(0, 1);
  if (format.decimal != '.') {
    if (text.find('.') != std::string::npos) return std::nullopt;
    std::replace(text.begin(), text.end(), format.decimal, '.');
  }
  if (!std::isfinite(nearest_double(text))) return std::nullopt;
  return text;
}

void refuse_field(const std::string& field, const SampleFormat& format, const std::string& place) {
  const bool comma = format.decimal == '.' && field.find(',') != std::string::npos;
  throw Error(place, "'" + files::shown(field) + "'",
              std::string("a finite number or an empty field") +
                  (comma ? "; csv.decimal = \",\" reads decimal commas" : ""));
}

}  // namespace plumbline::diagnose
