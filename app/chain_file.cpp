#include "app/chain_file.hpp"

#include <algorithm>
#include <set>

#include "app/decimal_toml.hpp"
#include "app/structure_file.hpp"
#include "support/files/csv_file.hpp"
#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

/// The key as chain files spell it or as experiments do, whichever stands there.
std::string spelling(const toml::table& table, const std::string& here, const std::string& in_experiments,
                     const std::string& source) {
  if (!table.contains(in_experiments)) return here;
  if (table.contains(here))
    throw Error(files::place(*table.get(in_experiments), source), "both " + here + " and " + in_experiments,
                "one of the two, which mean the same");
  return in_experiments;
}

std::vector<Rational> joined_numbers(const std::string& field, const std::string& list) {
  std::vector<Rational> values;
  add_joined(values, field, list);
  return values;
}

NamedStructure parse_row(const files::CsvRow& row, const std::vector<std::size_t>& column,
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
    return {name, place, std::move(structure), true, {}};
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

/// Where the lists of a chain stand: in the table [nominal], as experiments and `plumbline chain` have it, or
/// in the file itself.
const toml::table& chain_table(const toml::table& file, const std::string& source) {
  const toml::table* const nominal = file["nominal"].as_table();
  if (nominal == nullptr) return file;
  files::refuse_unknown_keys(file, {"nominal"}, source);
  for (const char* beyond : {"effect", "torque_law"})
    if (const toml::node* const more = nominal->get(beyond))
      throw Error(files::place(*more, source), std::string("[[nominal.") + beyond + "]]", "springs alone");
  return *nominal;
}

}  // namespace

NamedStructure parse_structure(const std::string& text, const std::string& source) {
  const toml::table file = parse_decimal_toml(text, source);
  const toml::table& table = chain_table(file, source);
  std::vector<std::string_view> known{"lengths", "stiffness", "rest"};
  known.insert(known.end(), structure_keys.begin(), structure_keys.end());
  files::refuse_unknown_keys(table, known, source,
                             {"link_length", "joint_stiffness", "link_mass", "gravity"});
  if (table.contains("beam")) {
    Beam beam;
    NamedStructure result{"", source, read_beam(table, source, beam), false, {}};
    result.beam = beam;
    read_structure(table, source, result.structure);
    return result;
  }
  const auto lengths = number_list(table, spelling(table, "lengths", "link_length", source), source);
  const auto stiffness = number_list(table, spelling(table, "stiffness", "joint_stiffness", source), source);
  const auto rest = table.contains("rest") ? number_list(table, "rest", source) : std::vector<Rational>();
  NamedStructure result{"",
                        source,
                        Structure<Rational>([&] {
                          try {
                            return Chain<Rational>(lengths, stiffness, rest);
                          } catch (const Error& error) {
                            throw Error(source + ": " + error.what());
                          }
                        }()),
                        std::none_of(structure_keys.begin(), structure_keys.end(),
                                     [&](std::string_view key) { return table.contains(key); }),
                        {}};
  read_structure(table, source, result.structure);
  return result;
}

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

}  // namespace plumbline::app
