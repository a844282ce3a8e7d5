#pragma once
/// \file
/// The format of the sample files: the tables [csv] and [columns] of experiment.toml.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/section.hpp"
#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

/// What a column says of a reading.
enum class Says { time, channel, command, wrench, other, covariate };

/// A column of a table. A value is sign * (reading - zero), in the unit.
struct Column {
  std::string channel;                  ///< "Fx", "torque", "q3", "q_command3", or the name of a covariate
  std::string name;                     ///< in the header; empty where the column has a number
  std::size_t number = 0;               ///< from 1, where there is no name
  std::optional<std::string> constant;  ///< a decimal that holds for all readings; there is no column
  Unit unit, usual_unit;                ///< the latter where [columns] does not say
  int sign = 1;
  std::string zero = "0";  ///< a decimal
  bool zero_is_first = false;
  std::string place = {};              ///< of the key that sets it; empty where none does
  const Quantity* quantity = nullptr;  ///< of which its unit is; null for a covariate that is no load
  Says says = Says::covariate;
  std::optional<Channel> reads = std::nullopt;  ///< the channel that it says
  /// Of columns that are there together or not at all, the name that they share: "q" of q1, q2 …; else empty.
  std::string group = {};

  [[nodiscard]] bool as_is() const { return unit.factor == 1 && sign == 1 && zero == "0" && !zero_is_first; }
  [[nodiscard]] bool reads_any(const std::vector<Channel>& channels) const {
    return reads && std::find(channels.begin(), channels.end(), *reads) != channels.end();
  }
  /// In [columns].
  [[nodiscard]] const std::string& key() const { return group.empty() ? channel : group; }
};

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
  bool all_known = false;          ///< a column that the format does not have is refused
  std::vector<std::string> ignored = {};  ///< but for these, which are left out
  Device device = Device::chain;
  std::vector<Column> columns = {};  ///< the time first, the covariates last

  [[nodiscard]] const EndKind& end() const { return end_kind(device); }
  [[nodiscard]] std::size_t covariates() const;
};

/// \param own  keys that the section may have
/// \throws Error for others; those of other benches' channels are told apart
void require_keys(const Section& section, const SampleFormat& format, const std::set<std::string>& own);

/// The format without any setting: docs/experiment-format.md, "Sample files". Its columns are t, x, y, Fx,
/// Fy, q1 … qn, q_command1 … q_commandn, Fx_2, Fy_2; of a joint alone t, angle, torque, q_command1, torque_2.
SampleFormat standard_format(std::size_t joints, Device device = Device::chain);

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

/// What a kind of sensor reads.
const Quantity& quantity_of(Sensor sensor);

/// A column of its own name.
/// \param place  of the key that names it, or empty
Column own_column(const std::string& channel, const Quantity* quantity, const std::string& place = "");

}  // namespace plumbline::diagnose
