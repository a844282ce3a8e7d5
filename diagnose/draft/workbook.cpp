#include "diagnose/draft/workbook.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <plumbline/base/error.hpp>
#include <pugixml.hpp>
#include <set>

#include "diagnose/draft/cell.hpp"
#include "diagnose/draft/zip_archive.hpp"
#include "support/files/csv_file.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double seconds_a_day = 86400;

/// Without its namespace: "x:row" is "row".
const char* plain_name(const pugi::xml_node& node) {
  const char* const colon = std::strchr(node.name(), ':');
  return colon == nullptr ? node.name() : colon + 1;
}

std::vector<pugi::xml_node> children(const pugi::xml_node& of, const char* name) {
  std::vector<pugi::xml_node> all;
  for (const pugi::xml_node& child : of.children())
    if (std::strcmp(plain_name(child), name) == 0) all.push_back(child);
  return all;
}

pugi::xml_node child(const pugi::xml_node& of, const char* name) {
  const auto all = children(of, name);
  return all.empty() ? pugi::xml_node() : all.front();
}

/// All text below, of a string in parts with formats of their own.
std::string text_below(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& one : node.children())
    if (one.type() == pugi::node_pcdata || one.type() == pugi::node_cdata) {
      text += one.value();
    } else if (std::strcmp(plain_name(one), "rPh") != 0) {  // how a word is spoken
      text += text_below(one);
    }
  return text;
}

/// Whether a format of numbers shows a date or a time.
bool shows_time(int id, const std::string& code) {
  if ((id >= 14 && id <= 22) || (id >= 45 && id <= 47)) return true;
  bool quoted = false, bracketed = false;
  for (const char c : code) {
    if (c == '"') quoted = !quoted;
    if (c == '[') bracketed = true;
    if (c == ']') bracketed = false;
    if (!quoted && !bracketed && std::string("yYdDhHsS").find(c) != std::string::npos) return true;
  }
  return false;
}

/// A serial number of a spreadsheet, days since 30 December 1899, as ISO 8601; below 1 a time of the day.
std::string as_time(double serial) {
  constexpr double days_to_1970 = 25569;
  const double seconds = std::round((serial - std::floor(serial)) * seconds_a_day * 1e6) / 1e6;
  const int whole = static_cast<int>(seconds);
  const std::string clock =
      fmt::format("{:02}:{:02}:{:09.6f}", whole / 3600, whole / 60 % 60, seconds - whole + whole % 60);
  if (serial < 1) return clock;
  const auto day =
      std::chrono::sys_days(std::chrono::days(static_cast<int>(std::floor(serial) - days_to_1970)));
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}T{}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock);
}

class Workbook {
 public:
  Workbook(const std::string& bytes, const std::string& source)
      : source_(source), files_(files_in_archive(bytes, source)) {}

  std::vector<Sheet> sheets() {
    read_strings();
    read_styles();
    std::map<std::string, std::string> targets;
    const pugi::xml_document links = document("xl/_rels/workbook.xml.rels");
    for (const pugi::xml_node& link : links.first_child().children())
      targets[link.attribute("Id").value()] = link.attribute("Target").value();
    const pugi::xml_document book = document("xl/workbook.xml");
    std::vector<Sheet> all;
    for (const pugi::xml_node& sheet : child(book.first_child(), "sheets").children()) {
      const std::string& target = targets[sheet.attribute("r:id").value()];
      Sheet one = read_sheet(target.starts_with('/') ? target.substr(1) : "xl/" + target);
      one.name = sheet.attribute("name").value();
      if (one.numbers > 0) all.push_back(std::move(one));
    }
    if (all.empty())
      throw Error(source_, "no sheet with numbers", "a workbook (.xlsx) with a table of readings");
    return all;
  }

 private:
  /// An absent part is empty.
  [[nodiscard]] pugi::xml_document document(const std::string& name) const {
    pugi::xml_document parsed;
    const auto found = files_.find(name);
    if (found == files_.end()) return parsed;
    if (!parsed.load_buffer(found->second.data(), found->second.size()))
      throw Error(source_, "damaged XML in " + name, "a workbook (.xlsx)");
    return parsed;
  }

  void read_strings() {
    const pugi::xml_document shared = document("xl/sharedStrings.xml");
    for (const pugi::xml_node& one : children(shared.first_child(), "si"))
      strings_.push_back(text_below(one));
  }

  void read_styles() {
    const pugi::xml_document styles = document("xl/styles.xml");
    std::map<int, std::string> codes;
    for (const pugi::xml_node& one : child(styles.first_child(), "numFmts").children())
      codes[one.attribute("numFmtId").as_int()] = one.attribute("formatCode").value();
    for (const pugi::xml_node& one : child(styles.first_child(), "cellXfs").children()) {
      const int id = one.attribute("numFmtId").as_int();
      is_time_.push_back(shows_time(id, codes[id]));
    }
  }

  Sheet read_sheet(const std::string& name) const {
    const pugi::xml_document parsed = document(name);
    Sheet sheet;
    for (const pugi::xml_node& row : children(child(parsed.first_child(), "sheetData"), "row")) {
      std::vector<std::string> fields;
      for (const pugi::xml_node& cell : children(row, "c")) {
        std::size_t column = column_of(cell.attribute("r").value(), fields.size());
        fields.resize(std::max(fields.size(), column + 1));
        fields[column] = value_of(cell);
        if (!std::isnan(cell_of(fields[column], '.').number)) ++sheet.numbers;
      }
      for (std::string& field : fields) field = files::csv_field(field);
      sheet.text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return sheet;
  }

  /// From "BC12", from 0; cells without a place follow one another.
  static std::size_t column_of(const std::string& place, std::size_t next) {
    std::size_t column = 0;
    for (const char c : place)
      if (std::isalpha(static_cast<unsigned char>(c)) != 0)
        column = 26 * column + static_cast<std::size_t>(std::toupper(c) - 'A') + 1;
    constexpr std::size_t most = 16384;  // of a spreadsheet
    return column == 0 || column > most ? next : column - 1;
  }

  [[nodiscard]] std::string value_of(const pugi::xml_node& cell) const {
    const std::string type = cell.attribute("t").value();
    if (type == "inlineStr") return text_below(child(cell, "is"));
    const std::string value = text_below(child(cell, "v"));
    if (type == "s") {
      const std::size_t place = std::strtoul(value.c_str(), nullptr, 10);
      return place < strings_.size() ? strings_[place] : "";
    }
    const auto style = static_cast<std::size_t>(cell.attribute("s").as_uint());
    const double number = number_of(value, '.');
    return type.empty() && style < is_time_.size() && is_time_[style] && !std::isnan(number) ? as_time(number)
                                                                                             : value;
  }

  const std::string& source_;
  std::map<std::string, std::string> files_;
  std::vector<std::string> strings_;
  std::vector<bool> is_time_;  ///< by style of a cell
};

}  // namespace

bool is_workbook(const std::string& bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::vector<Sheet> sheets_of(const std::string& bytes, const std::string& source) {
  return Workbook(bytes, source).sheets();
}

}  // namespace plumbline::diagnose
