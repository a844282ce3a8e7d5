#include "support/files/csv_file.hpp"

#include <csv.h>

#include <memory>
#include <plumbline/base/error.hpp>

namespace plumbline::files {
namespace {

struct Rows {
  std::vector<CsvRow> rows;
  std::vector<std::string> fields;
  std::size_t start = 1;
};

void end_of_field(void* text, std::size_t size, void* data) {
  static_cast<Rows*>(data)->fields.emplace_back(static_cast<const char*>(text), size);
}

void end_of_row(int /*terminator*/, void* data) {
  auto& rows = *static_cast<Rows*>(data);
  rows.rows.push_back({rows.start, std::move(rows.fields)});
  rows.fields.clear();
}

}  // namespace

std::vector<CsvRow> parse_csv(const std::string& text, const std::string& source, char delimiter) {
  csv_parser parser;
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  const std::unique_ptr<csv_parser, decltype(&csv_free)> guard(&parser, &csv_free);
  csv_set_delim(&parser, static_cast<unsigned char>(delimiter));
  Rows result;
  const auto fail = [&](std::size_t line) {
    throw Error(source + ":" + std::to_string(line), "a quote inside a field, or one without its partner",
                "separated fields, quoted where they hold a quote, and that doubled");
  };
  std::size_t line = 1;
  const std::size_t mark = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // the byte order mark of spreadsheets
  for (std::size_t at = mark; at < text.size(); ++line) {  // line by line, so that a row knows its own
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::size_t rows = result.rows.size();
    if (csv_parse(&parser, text.data() + at, end - at, end_of_field, end_of_row, &result) != end - at)
      fail(line);
    const bool inside = !result.fields.empty() || parser.quoted != 0;  // a row goes on, or a quoted field
    if (result.rows.size() > rows || !inside) result.start = line + 1;
    at = end;
  }
  if (csv_fini(&parser, end_of_field, end_of_row, &result) != 0) fail(line - 1);
  if (result.rows.empty()) throw Error(source, "blank lines alone", "a header line and rows");
  return std::move(result.rows);
}

std::string csv_field(const std::string& value) {
  if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
  std::string quoted(csv_write(nullptr, 0, value.data(), value.size()), '\0');
  csv_write(quoted.data(), quoted.size(), value.data(), value.size());
  return quoted;
}

}  // namespace plumbline::files
