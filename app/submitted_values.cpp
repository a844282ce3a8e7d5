#include "app/submitted_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "proofs/exact/decimal.hpp"
#include "support/files/csv_file.hpp"
#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

std::size_t column(const files::CsvRow& header, const std::string& name, const std::string& path) {
  const auto found = std::find(header.fields.begin(), header.fields.end(), name);
  if (found == header.fields.end())
    throw Error(fmt::format("{}:{}", path, header.line), fmt::format("no column {}", name),
                "the columns chain,mode,force");
  return static_cast<std::size_t>(found - header.fields.begin());
}

bool not_a_number(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  static const std::set<std::string> names{"nan", "-nan", "inf", "-inf", "+inf", "infinity", "-infinity"};
  return names.count(text) > 0;
}

verify::SubmittedForce parse_force(const files::CsvRow& row, const std::string& place,
                                   const std::string& mode, const std::string& force, std::size_t modes) {
  verify::SubmittedForce result{row.line, 0, force};
  const auto [end, error] = std::from_chars(mode.data(), mode.data() + mode.size(), result.mode);
  if (error != std::errc() || end != mode.data() + mode.size() || result.mode < 1 || result.mode > modes)
    throw Error(place, fmt::format("mode \"{}\"", files::shown(mode)),
                fmt::format("a mode from 1 to {}", modes));
  if (!proofs::parse_decimal(force) && !not_a_number(force))
    throw Error(place, fmt::format("force \"{}\"", files::shown(force)), "a decimal number");
  return result;
}

}  // namespace

SubmittedValues parse_values(const std::string& text, const std::string& source, const Chains& chains) {
  const std::vector<files::CsvRow> rows = files::parse_csv(text, source);
  const std::size_t chain_column = column(rows.front(), "chain", source),
                    mode_column = column(rows.front(), "mode", source),
                    force_column = column(rows.front(), "force", source);
  if (rows.size() == 1) throw Error(source, "no row below the header", "a row for each critical force");
  SubmittedValues submitted;
  std::set<std::pair<std::string, std::size_t>> seen;
  const auto take = [&](const files::CsvRow& row, const std::string& place) {
    if (row.fields.size() != rows.front().fields.size())
      throw Error(place, fmt::format("{} fields", row.fields.size()),
                  fmt::format("{} as in the header", rows.front().fields.size()));
    const std::string& name = row.fields[chain_column];
    const auto chain = chains.find(name);
    if (chain == chains.end())
      throw Error(place, fmt::format("chain \"{}\"", files::shown(name)),
                  "a chain of the reference set (or name yours by --chains)");
    const auto force =
        parse_force(row, place, row.fields[mode_column], row.fields[force_column], mode_count(chain->second));
    if (!seen.emplace(name, force.mode).second)
      throw Error(place, fmt::format("mode {} of {} again", force.mode, name), "each mode once");
    submitted.values[name].push_back(force);
  };
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    try {
      take(*row, fmt::format("{}:{}", source, row->line));
    } catch (const Error& error) {
      submitted.errors.emplace_back(error.what());
    }
  }
  return submitted;
}

}  // namespace plumbline::app
