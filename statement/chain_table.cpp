#include "statement/chain_table.hpp"

#include <algorithm>
#include <set>

#include "statement/decimal_toml.hpp"
#include "support/files/csv_file.hpp"
#include "support/files/printable.hpp"

namespace plumbline::statement {
namespace {

std::vector<Rational> joined_numbers(const std::string& field, const std::string& list) {
  std::vector<Rational> values;
  add_joined(values, field, list);
  return values;
}

NamedChain parse_row(const files::CsvRow& row, const std::vector<std::size_t>& column,
                     const std::string& where, std::set<std::string>& names) {
  if (row.fields.size() != column.size()) {
    throw Error(where, std::to_string(row.fields.size()) + " fields", std::to_string(column.size()));
  }
  const std::string& name = row.fields[column[0]];
  if (name.empty()) throw Error(where, "a chain without a name", "a name in the column chain");
  files::require_name(name, where + ": chain");
  const std::string place = where + ": chain " + name;
  if (!names.insert(name).second) throw Error(place, "a name that occurred before", "every chain once");
  try {
    Structure<Rational> structure(Chain<Rational>(joined_numbers(row.fields[column[1]], "lengths"),
                                                  joined_numbers(row.fields[column[2]], "stiffness")));
    structure.add_compression();
    return {{std::move(structure), true, {}}, name, place, ""};
  } catch (const Error& error) {
    throw Error(place + ": " + error.what());
  }
}

/// Where the columns `chain`, `lengths`, `stiffness` stand.
std::vector<std::size_t> find_columns(const files::CsvRow& header, const std::string& source) {
  std::vector<std::size_t> column;
  for (const std::string name : {"chain", "lengths", "stiffness"}) {
    const auto found = std::find(header.fields.begin(), header.fields.end(), name);
    if (found == header.fields.end() || header.fields.size() != 3) {
      std::string fields;
      for (const std::string& field : header.fields) fields += (fields.empty() ? "" : ",") + field;
      throw Error(source + ":" + std::to_string(header.line), "the header " + files::shown(fields),
                  "chain,lengths,stiffness");
    }
    column.push_back(static_cast<std::size_t>(found - header.fields.begin()));
  }
  return column;
}

}  // namespace

bool is_chain_table(const std::string& text) {
  try {
    find_columns(files::parse_csv(text.substr(0, text.find('\n')), "").front(), "");
    return true;
  } catch (const Error&) {
    return false;
  }
}

ChainTable parse_chain_table(const std::string& text, const std::string& source) {
  const std::vector<files::CsvRow> rows = files::parse_csv(text, source);
  const std::vector<std::size_t> column = find_columns(rows.front(), source);
  if (rows.size() == 1) throw Error(source, "a header and no chain", "a row for each chain");
  ChainTable table;
  std::set<std::string> names;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    try {
      table.chains.push_back(parse_row(rows[i], column, source + ":" + std::to_string(rows[i].line), names));
    } catch (const Error& error) {
      table.errors.emplace_back(error.what());
    }
  }
  return table;
}

}  // namespace plumbline::statement
