#include "diagnose/motion/bam_log.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

namespace plumbline::motion {
namespace {

std::string field_of(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

BamLog bam_log(const std::string& text, const std::string& source) {
  nlohmann::json all = nlohmann::json::parse(text, nullptr, false);
  if (!all.is_object() || !all.contains("entries") || !all["entries"].is_array() || all["entries"].empty())
    throw Error(source, all.is_discarded() ? "text that is not JSON" : "no list 'entries'",
                "a log as BAM records it, with entries");
  std::vector<files::CsvRow> rows{{0, {}}};
  for (const auto& [key, value] : all["entries"].front().items()) rows.front().fields.push_back(key);
  for (const nlohmann::json& entry : all["entries"]) {
    files::CsvRow row{rows.size(), {}};
    for (const std::string& key : rows.front().fields) {
      if (!entry.is_object() || !entry.contains(key))
        throw Error(fmt::format("{}, entry {}", source, rows.size()), "no '" + key + "'",
                    "the keys of the first entry");
      row.fields.push_back(field_of(entry[key]));
    }
    rows.push_back(std::move(row));
  }
  all.erase("entries");
  return {std::move(all), LogTable(std::move(rows), source)};
}

}  // namespace plumbline::motion
