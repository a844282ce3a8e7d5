#include "diagnose/bench/read_date.hpp"

#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

std::optional<toml::date> date_in(const toml::node& node) {
  if (const auto* day = node.as_date()) return day->get();
  if (const auto* moment = node.as_date_time()) return moment->get().date;
  if (!node.is_string()) return {};
  try {
    const toml::table table = files::parse_toml("d = " + node.as_string()->get() + "\n", "date");
    return date_in(*table.get("d"));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::optional<std::chrono::sys_days> read_date(const Section& root) {
  if (!root.has("date")) return {};
  const toml::node& node = root.node("date");
  const bool nested =
      node.is_string() && node.as_string()->get().find_first_not_of("0123456789-T:.Z+ ") != std::string::npos;
  const std::optional<toml::date> day = nested ? std::nullopt : date_in(node);
  if (!day) root.refuse("date", "a day, as 2026-03-01");
  return std::chrono::sys_days(std::chrono::year(day->year) / day->month / day->day);
}

std::optional<std::chrono::sys_days> date_of(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  try {
    const toml::table table = files::parse_toml(files::read_text(file), file.string());
    return read_date(Section(table, file.string()));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace plumbline::diagnose
