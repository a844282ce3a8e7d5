#include "diagnose/motion/balance/torque_log.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

#include "diagnose/bench/section.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/motion/log_table.hpp"
#include "support/files/text_file.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::motion {
namespace {

using diagnose::Section;

constexpr const char* torque_format = "torque/1";

Eigen::MatrixXd columns_of(const LogTable& table, const std::vector<std::string>& names) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(table.rows()), static_cast<Eigen::Index>(names.size()));
  for (std::size_t j = 0; j < names.size(); ++j) {
    const std::vector<double> numbers = table.numbers(names[j]);
    all.col(static_cast<Eigen::Index>(j)) =
        Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  }
  return all;
}

/// Names of columns, one a joint.
std::vector<std::string> names_of(const Section& columns, const std::string& key, std::size_t joints) {
  std::vector<std::string> names = columns.texts(key, "names of columns, one a joint");
  if (names.size() != joints)
    throw Error(columns.place(key), fmt::format("{} names", names.size()),
                fmt::format("{}, one for each joint of the model", joints));
  return names;
}

TorqueLog torque_log(const std::filesystem::path& folder, const std::string& file, const Section& columns,
                     std::size_t joints) {
  constexpr std::size_t fewest = 100;
  const LogTable table(files::read_text(folder / file), (folder / file).string());
  TorqueLog log{file, table.numbers(columns.has("t") ? columns.text("t", "the name of a column") : "t"),
                columns_of(table, names_of(columns, "position", joints)),
                columns_of(table, names_of(columns, "torque", joints))};
  if (log.time.size() < fewest)
    throw Error(file, fmt::format("{} readings", log.time.size()), fmt::format("{} at least", fewest));
  for (std::size_t k = 1; k < log.time.size(); ++k)
    if (!(log.time[k] > log.time[k - 1]))
      throw Error(fmt::format("{}, reading {}", file, k + 1),
                  fmt::format("a clock that goes from {:g} to {:g} s", log.time[k - 1], log.time[k]),
                  "time that goes forward");
  return log;
}

toml::table settings_in(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  return files::parse_toml(files::read_text(file), file.string());
}

}  // namespace

bool is_torque_bench(const std::filesystem::path& folder) {
  return settings_in(folder)["format"].value<std::string>() == torque_format;
}

TorqueBench read_torque_bench(const std::filesystem::path& folder) {
  const toml::table table = settings_in(folder);
  const Section all(table, (folder / "experiment.toml").string());
  all.allow_only({"format", "name", "model", "logs", "columns"});
  const Section model = all.table("model"), logs = all.table("logs"), columns = all.table("columns");
  model.allow_only({"file", "base", "tip"});
  logs.allow_only({"files", "held_out"});
  columns.allow_only({"t", "position", "torque"});
  const auto end = [&](const char* key) {
    return model.has(key) ? model.text(key, "the name of a link") : "";
  };
  TorqueBench bench;
  bench.name = all.name("name", "a name");
  exchange::SpatialArm arm =
      exchange::read_arm(folder / model.text("file", "a model of the arm"), {end("base"), end("tip")});
  bench.arm = std::move(arm.nominal), bench.inertia = std::move(arm.inertia);
  const auto read = [&](const std::string& key) {
    std::vector<TorqueLog> some;
    for (const std::string& file : logs.texts(key, "files of logs"))
      some.push_back(torque_log(folder, file, columns, bench.arm.arm.size()));
    return some;
  };
  bench.logs = read("files");
  if (logs.has("held_out")) bench.held_out = read("held_out");
  return bench;
}

}  // namespace plumbline::motion
