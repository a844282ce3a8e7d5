#include "app/chain_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>
#include <sstream>

#include "proofs/exact/decimal.hpp"
#include "support/files/csv_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::app {
namespace {

/// One number of a list. What the chain would refuse is refused here, where the text is still known.
Rational parse_number(const std::string& text, const std::string& list, std::size_t i) {
  const auto refuse = [&](const std::string& why, const std::string& expected) {
    throw Error(list + ", entry " + std::to_string(i + 1),
                text.empty() ? "nothing" : files::shown(text) + why, expected);
  };
  auto value = proofs::parse_decimal(text);
  if (!value) refuse("", "a decimal number");
  if ((list.ends_with("lengths") || list.ends_with("link_length")) && *value <= 0)
    refuse(", which is not positive", "a positive length");
  if (list.ends_with("stiffness") && *value < 0) refuse(", which is negative", "zero (passive) or positive");
  return *std::move(value);
}

/// Collects text in which decimals that follow each other in a list become one string, joined by ';': a
/// parser takes its time, and a hundred bytes, for every entry.
class JoinedDecimals {
 public:
  void decimal(const std::string& digits) {
    if (open_ && std::count(gap_.begin(), gap_.end(), ',') == 1) {
      lines_.append(static_cast<std::size_t>(std::count(gap_.begin(), gap_.end(), '\n')), '\n');
      gap_.clear();
      text_ += ';';
    } else {
      close();
      text_ += '"';
      open_ = true;
    }
    text_ += digits;
  }
  void other(const std::string& token) {
    if (open_ && token.find_first_not_of(", \t\r\n") == std::string::npos) {
      gap_ += token;
    } else {
      close();
      text_ += token;
    }
  }
  std::string text() {
    close();
    return std::move(text_);
  }

 private:
  /// Everything keeps its line.
  void close() {
    if (open_) text_ += '"' + lines_ + gap_;
    open_ = false;
    lines_.clear();
    gap_.clear();
  }
  std::string text_, lines_, gap_;
  bool open_ = false;  ///< the last string, behind which the gap stands
};

/// The text with every bare decimal quoted: a TOML parser rounds numbers to double and refuses those that
/// overflow, but keeps strings as they are. What is in quotes or a comment already stays.
std::string quote_decimals(const std::string& text) {
  JoinedDecimals result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (text[at] == '#') {
      end = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '"' || text[at] == '\'') {
      end = std::min(text.find_first_of({text[at], '\n'}, end), text.size() - 1) + 1;
    } else if (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '+' ||
               text[at] == '-') {
      const auto is_bare = [](unsigned char c) {
        return std::isalnum(c) != 0 || (c != 0 && std::strchr("+-._:", c));
      };
      while (end < text.size() && is_bare(static_cast<unsigned char>(text[end]))) ++end;
    }
    const std::string token = text.substr(at, end - at);
    std::string digits = token;
    std::erase(digits, '_');  // TOML groups digits with it
    proofs::parse_decimal(digits) ? result.decimal(digits) : result.other(token);
    at = end;
  }
  return result.text();
}

/// The numbers of a text that joins them by ';', behind those before.
void add_joined(std::vector<Rational>& values, const std::string& field, const std::string& list) {
  for (std::size_t at = 0; at <= field.size();) {
    const std::size_t end = std::min(field.find(';', at), field.size());
    const std::size_t first = std::min(field.find_first_not_of(' ', at), end);
    const std::size_t last = field.find_last_not_of(' ', end - 1);
    values.push_back(parse_number(field.substr(first, last + 1 - first), list, values.size()));
    at = end + 1;
  }
}

std::vector<Rational> number_list(const toml::table& table, const std::string& key,
                                  const std::string& source) {
  const toml::node* node = table.get(key);
  if (node == nullptr) throw Error(source, "no key " + key, "lengths and stiffness, a list each");
  const std::string where = files::place(*node, source) + ": " + key;
  const toml::array* list = node->as_array();
  if (list == nullptr) throw Error(where, "a single value", "a list of numbers in brackets");
  std::vector<Rational> values;
  for (const toml::node& item : *list) {
    std::ostringstream found;
    if (!item.is_string()) found << toml::node_view(item);
    add_joined(values, item.value_or(found.str()), where);
  }
  return values;
}

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
    return {name, place,
            Chain<Rational>(joined_numbers(row.fields[column[1]], "lengths"),
                            joined_numbers(row.fields[column[2]], "stiffness"))};
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

Chain<Rational> parse_chain(const std::string& text, const std::string& source) {
  const toml::table file = files::parse_toml(quote_decimals(text), source);
  const toml::table& table = chain_table(file, source);
  files::refuse_unknown_keys(table, {"lengths", "stiffness", "rest"}, source,
                             {"link_length", "joint_stiffness", "link_mass", "gravity"});
  const auto lengths = number_list(table, spelling(table, "lengths", "link_length", source), source);
  const auto stiffness = number_list(table, spelling(table, "stiffness", "joint_stiffness", source), source);
  const auto rest = table.contains("rest") ? number_list(table, "rest", source) : std::vector<Rational>();
  try {
    return Chain<Rational>(lengths, stiffness, rest);
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
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
