#pragma once
/// \file
/// The number in a field of a table: plain, with its unit behind it, or a time by the clock.

#include <string>

namespace plumbline::diagnose {

struct Cell {
  double number;          ///< NaN where there is none; of a clock, seconds
  std::string unit = {};  ///< that stands behind the number
  bool clock = false;     ///< a time of the day, or a date with one: ISO 8601, 14:02:11,5, 03.11.2026 14:02
  bool dated = false;     ///< a clock with a date: seconds from 1970 on
};

/// \param decimal  the decimal mark, '.' or ','
Cell cell_of(const std::string& field, char decimal);

/// A plain number, or NaN.
double number_of(std::string field, char decimal);

}  // namespace plumbline::diagnose
