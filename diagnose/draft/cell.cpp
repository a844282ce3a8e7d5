#include "diagnose/draft/cell.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include "diagnose/draft/unit_words.hpp"

namespace plumbline::diagnose {
namespace {

/// Reads digits and what must stand behind them.
class ClockReader {
 public:
  explicit ClockReader(const std::string& text) : rest_(text) {}

  std::optional<int> digits(std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < most && count < rest_.size() &&
           std::isdigit(static_cast<unsigned char>(rest_[count])) != 0)
      value = 10 * value + (rest_[count++] - '0');
    if (count == 0) return {};
    rest_.remove_prefix(count);
    return value;
  }
  bool skip(std::string_view one_of) {
    if (rest_.empty() || one_of.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// The digits behind a decimal mark, as a fraction.
  double fraction() {
    double value = 0, step = 0.1;
    for (; !rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0; step /= 10) {
      value += step * (rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    return value;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// Days since 1970 of 2026-11-03, 2026/11/03, 03.11.2026 or 03/11/2026, whose order of day and month matters
/// for nothing but runs over midnight; the separator tells.
std::optional<double> date(ClockReader& in) {
  const auto first = in.digits(4);
  if (!first || !in.skip("-/.")) return {};
  const auto second = in.digits(2);
  if (!second || !in.skip("-/.")) return {};
  const auto third = in.digits(4);
  if (!third) return {};
  constexpr int years = 1900;
  const bool year_first = *first > years;
  const int year = year_first ? *first : *third, day = year_first ? *third : *first;
  const std::chrono::year_month_day at{std::chrono::year(year),
                                       std::chrono::month(static_cast<unsigned>(*second)),
                                       std::chrono::day(static_cast<unsigned>(day))};
  if (year < years || !at.ok()) return {};
  return static_cast<double>(std::chrono::sys_days(at).time_since_epoch().count());
}

/// Seconds since midnight; 14:02, 14:02:11, 14:02:11.250, with or without a zone, which all readings share.
std::optional<double> time_of_day(ClockReader& in) {
  const auto hour = in.digits(2);
  if (!hour || !in.skip(":")) return {};
  const auto minute = in.digits(2);
  if (!minute || *minute >= 60) return {};
  double seconds = 3600.0 * *hour + 60.0 * *minute;
  if (in.skip(":")) {
    const auto second = in.digits(2);
    if (!second || *second > 60) return {};
    seconds += *second;
    if (in.skip(".,")) seconds += in.fraction();
  }
  if (in.skip("Z")) return seconds;
  if (in.skip("+-")) in.digits(4), in.skip(":"), in.digits(2);
  return seconds;
}

std::optional<Cell> clock_of(const std::string& field) {
  constexpr double day = 86400;
  ClockReader with_date(field);
  if (const auto days = date(with_date)) {
    if (with_date.skip("T "))
      if (const auto seconds = time_of_day(with_date); seconds && with_date.rest().empty())
        return Cell{*days * day + *seconds, "", true, true};
    return {};
  }
  ClockReader alone(field);
  if (const auto seconds = time_of_day(alone); seconds && alone.rest().empty())
    return Cell{*seconds, "", true};
  return {};
}

bool is_unit(const std::string& text) {
  static const std::array quantities{&quantity::length,  &quantity::force, &quantity::angle,
                                     &quantity::time,    &quantity::mass,  &quantity::torque,
                                     &quantity::pressure};
  return is_temperature_unit(text) || is_current_unit(text) ||
         std::any_of(quantities.begin(), quantities.end(),
                     [&](const Quantity* one) { return !unit_in(text, *one).empty(); });
}

/// "-90°", "12,5 kg".
std::optional<Cell> with_unit(const std::string& field, char decimal) {
  const std::size_t last = field.find_last_of("0123456789");
  if (last == std::string::npos || last + 1 == field.size()) return {};
  const double number = number_of(field.substr(0, last + 1), decimal);
  std::string unit = field.substr(last + 1);
  unit.erase(0, unit.find_first_not_of(' '));
  constexpr std::size_t longest = 8;
  if (std::isnan(number) || unit.size() > longest || !is_unit(unit)) return {};
  return Cell{number, unit};
}

}  // namespace

double number_of(std::string field, char decimal) {
  if (decimal == ',' && field.find('.') != std::string::npos) return NAN;
  if (decimal == ',') std::replace(field.begin(), field.end(), ',', '.');
  if (field.starts_with('+')) field.erase(0, 1);
  double value = NAN;
  const char* const end = field.data() + field.size();
  const auto [stop, fault] = std::from_chars(field.data(), end, value);
  return !field.empty() && fault == std::errc() && stop == end && std::isfinite(value) ? value : NAN;
}

Cell cell_of(const std::string& field, char decimal) {
  if (const double plain = number_of(field, decimal); !std::isnan(plain)) return {plain};
  if (const auto clock = clock_of(field)) return *clock;
  return with_unit(field, decimal).value_or(Cell{NAN});
}

}  // namespace plumbline::diagnose
