#include "diagnose/bench/sample_table.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <string_view>

namespace plumbline::diagnose {
namespace {

constexpr const char* blanks = " \t\r";

/// Splits at blanks by turning them into tabs.
std::string tabbed(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; (at = line.find_first_not_of(blanks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    if (!text.empty()) text += '\t';
    text += line.substr(at, end - at);
    at = end;
  }
  return text;
}

/// The text with skipped lines emptied, so that line numbers remain.
std::string without_skipped(std::string_view text, const SampleFormat& format) {
  std::string result;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::size_t start = std::min(line.find_first_not_of(blanks), line.size());
    const bool comment = !format.comment.empty() && line.substr(start).starts_with(format.comment);
    if (line_number++ >= format.skip_lines && !comment)
      result += format.delimiter == ' ' ? tabbed(line) : std::string(line);
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

/// Removes delimiters after the last column of a line.
void drop_trailing(std::vector<std::string>& fields, std::size_t columns) {
  while (fields.size() > columns && fields.back().empty()) fields.pop_back();
}

bool is_number(const std::string& field) {
  return !field.empty() && field.find_first_not_of("0123456789.,+-eE ") == std::string::npos;
}

/// A hint for a file whose line has more fields than its header.
std::string how_to_read(const SampleTable& table, const files::CsvRow& uneven, const SampleFormat& format) {
  if (const std::string other = other_delimiter(table, format); !other.empty()) return other;
  const std::size_t columns = table.header.size(), fields = uneven.fields.size();
  if (!format.header || fields < columns) return "";
  if (std::none_of(uneven.fields.begin(), uneven.fields.end(), is_number))
    return "; if the header is line " + std::to_string(uneven.line) +
           ": csv.skip_lines = " + std::to_string(uneven.line - 1);
  if (format.delimiter == ',' && fields + 1 >= 2 * columns && columns > 1)
    return "; where commas are decimal marks: another mark between the columns";
  return "; a name for every column in line " + std::to_string(table.header_line);
}

/// Lines as columns: row k has field k of every line.
/// \throws Error for lines of different lengths
std::vector<files::CsvRow> transposed(std::vector<files::CsvRow> lines, const std::string& source) {
  const std::size_t count = lines.front().fields.size();
  std::vector<files::CsvRow> rows;
  for (std::size_t field = 0; field < count; ++field) rows.push_back({field + 1, {}});
  for (files::CsvRow& line : lines) {
    drop_trailing(line.fields, count);
    if (line.fields.size() != count)
      throw Error(source + ":" + std::to_string(line.line), std::to_string(line.fields.size()) + " fields",
                  std::to_string(count) + ", as in the first line");
    for (std::size_t field = 0; field < count; ++field)
      rows[field].fields.push_back(std::move(line.fields[field]));
  }
  return rows;
}

}  // namespace

std::string SampleTable::place_of(std::size_t row, const std::string& source) const {
  return source + (transposed ? ", field " : ":") + std::to_string(rows[row].line);
}

SampleTable parse_sample_table(const std::string& text, const std::string& source,
                               const SampleFormat& format) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";  // the byte order mark of spreadsheets
  const std::string_view content = std::string_view(text).substr(text.starts_with(mark) ? mark.size() : 0);
  SampleTable table;
  table.rows = files::parse_csv(without_skipped(content, format), source,
                                format.delimiter == ' ' ? '\t' : format.delimiter);
  table.transposed = format.transposed;
  if (format.transposed) table.rows = transposed(std::move(table.rows), source);
  auto first = table.rows.begin();
  if (format.header) {
    table.header_line = first->line;
    table.header = std::move(first->fields);
    drop_trailing(table.header, 1);
    ++first;
  }
  const auto left = static_cast<std::size_t>(table.rows.end() - first);
  first += static_cast<std::ptrdiff_t>(std::min(format.skip_after_header, left));
  table.rows.erase(table.rows.begin(), first);
  if (table.rows.empty())
    throw Error(source, format.header ? "a header alone" : "no line", "at least one reading");
  const std::size_t columns = format.header ? table.header.size() : table.rows.front().fields.size();
  for (files::CsvRow& row : table.rows) {
    drop_trailing(row.fields, columns);
    if (row.fields.size() == columns) continue;
    throw Error(source + ":" + std::to_string(row.line), std::to_string(row.fields.size()) + " fields",
                std::to_string(columns) + ", as in the " + (format.header ? "header" : "first line") +
                    how_to_read(table, row, format));
  }
  return table;
}

std::string other_delimiter(const SampleTable& table, const SampleFormat& format) {
  constexpr std::pair<char, const char*> others[] = {{';', ";"}, {'\t', "tab"}, {'|', "|"}, {',', ","}};
  const auto cuts = [&](char delimiter) {
    std::ptrdiff_t count = 0;
    for (const std::string& field : table.header) count += std::count(field.begin(), field.end(), delimiter);
    return count;
  };
  for (const auto& [delimiter, name] : others)
    if (delimiter != format.delimiter && cuts(delimiter) > static_cast<std::ptrdiff_t>(table.header.size()))
      return std::string("; csv.delimiter = \"") + name + "\" would read more columns there";
  return "";
}

}  // namespace plumbline::diagnose
