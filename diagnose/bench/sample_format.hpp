#pragma once
/// \file
/// The format of the sample files: the tables [csv] and [columns] of experiment.toml.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/bench/section.hpp"
#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

/// The column of one channel. A value is sign * (reading - zero), in the unit.
struct Column {
  std::string channel;                  ///< "Fx", "torque", "q3", "q_command3", or the name of a covariate
  std::string name;                     ///< in the header; empty where the column has a number
  std::size_t number = 0;               ///< from 1, where there is no name
  std::optional<std::string> constant;  ///< a decimal that holds for all readings; there is no column
  Unit unit;
  int sign = 1;
  std::string zero = "0";  ///< a decimal
  bool zero_is_first = false;
  std::string place = {};              ///< of the key that sets it; empty where none does
  const Quantity* quantity = nullptr;  ///< of which its unit is; null for a covariate that is no load

  [[nodiscard]] bool as_is() const { return unit.factor == 1 && sign == 1 && zero == "0" && !zero_is_first; }
};

/// The places of t, x, y, Fx, Fy and q1 to qn among the columns; q_command1 to q_commandn, the two of a
/// second sensor of the load and the covariates follow.
enum : std::size_t { place_t, place_x, place_y, place_Fx, place_Fy, place_q1 };

struct SampleFormat {
  char delimiter = ',';  ///< ' ' for any number of blanks
  char decimal = '.';
  bool header = true;
  bool transposed = false;  ///< a line is a column: its name first, then a field for each reading
  std::size_t skip_lines = 0, skip_after_header = 0;
  std::string comment = {};               ///< the beginning of lines that are skipped
  std::vector<std::string> missing = {};  ///< entries for missing values, beside empty fields
  bool any_order = false;          ///< further columns are allowed; without [columns] the header is fixed
  bool absolute_angles = false;    ///< angles against x, not against the previous link
  bool absolute_commands = false;  ///< likewise
  bool commanded = false;          ///< of a run that imposes joint angles: q_command is required
  bool free_end = false;           ///< no force acts on the end point for want of a column
  Alone alone = Alone::no;         ///< of a joint alone: x and Fx are its angle and torque, y and Fy are 0
  /// t, x, y, Fx, Fy, q1 … qn, q_command1 … q_commandn, Fx_2, Fy_2, covariates
  std::vector<Column> columns;
  std::size_t covariates = 0;  ///< number of these

  [[nodiscard]] std::size_t joints() const { return (place_second1() - place_q1) / 2; }
  /// The places of q_command1, of the second sensor and of the first covariate among the columns.
  [[nodiscard]] std::size_t place_command1() const { return place_q1 + joints(); }
  [[nodiscard]] std::size_t place_second1() const { return place_covariate1() - 2; }
  [[nodiscard]] std::size_t place_covariate1() const { return columns.size() - covariates; }
};

/// Whether a chain, or a joint alone, has the channel of a key of [columns] or [noise].
bool has_channel(Alone alone, const std::string& key);
/// \throws Error for the key of a channel that it does not have
[[noreturn]] void refuse_channel(const Section& section, Alone alone, const std::string& key);

/// The format without any setting: docs/experiment-format.md, "Sample files".
SampleFormat standard_format(std::size_t joints, Alone alone = Alone::no);

/// Adds a covariate, or a value of a load, of its own name.
/// \param place     of the key that names it
/// \param quantity  of a load
/// \throws Error for a name that expressions cannot have, or one covariate too many
/// \returns its column
Column& add_covariate(SampleFormat& format, const std::string& name, const std::string& place,
                      const Quantity* quantity = nullptr);

/// The format after the tables [csv] and [columns] of a section.
/// \throws Error that names file, line and key
SampleFormat read_sample_format(const Section& section, SampleFormat format);

/// The table [csv] of a section alone, for files whose columns are told by their names.
/// \throws Error likewise
SampleFormat read_csv_format(const Section& section);

}  // namespace plumbline::diagnose
