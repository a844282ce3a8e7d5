#include "diagnose/motion/read_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/section.hpp"
#include "diagnose/motion/bam_log.hpp"
#include "diagnose/motion/course.hpp"
#include "diagnose/motion/log_look.hpp"
#include "diagnose/motion/log_table.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::motion {
namespace {

using diagnose::Section;

constexpr double gravity = 9.81;  // m/s^2

double positive(const Section& section, const std::string& key, const std::string& of) {
  const double number = section.number(key, "a positive number, " + of);
  if (!(number > 0)) section.refuse(key, "a positive number, " + of);
  return number;
}

/// A row of the index: of a log, the entries by column.
struct IndexRow {
  std::string file, place;
  const LogTable* table = nullptr;  ///< null where there is no index
  std::size_t row = 0;
  std::shared_ptr<const BamLog> bam = {};  ///< a log that tells its rig itself

  [[nodiscard]] std::string entry(const std::string& column, const std::string& key) const {
    if (bam && bam->rig.contains(column)) return bam->rig[column].dump();
    if (table == nullptr)
      throw Error(key, "the name of a column, '" + column + "', without logs.index", "a number");
    return table->entry(row, table->column(column, key));
  }
};

/// A number, or the column of the index that has it for each log.
double value_of(const Section& section, const std::string& key, const IndexRow& row, double otherwise) {
  if (!section.has(key)) return otherwise;
  if (!section.node(key).is_string()) return section.number(key, "a number, or a column of the index");
  const std::string column = section.text(key, "a number, or a column of the index");
  return number_in(row.entry(column, section.place(key)), row.place + ", column " + column);
}

/// Whether a log has one of the entries that the table `key` lists for each of its columns.
bool is_chosen(const Section& logs, const std::string& key, const IndexRow& row) {
  const Section wanted = logs.table(key);
  const std::vector<std::string> columns = wanted.keys();
  return std::all_of(columns.begin(), columns.end(), [&](const std::string& column) {
    const std::string entry = row.entry(column, wanted.place(column));
    if (wanted.node(column).is_array() && wanted.node(column).as_array()->is_homogeneous<std::string>()) {
      const std::vector<std::string> words = wanted.texts(column, "texts, or numbers");
      return std::find(words.begin(), words.end(), entry) != words.end();
    }
    const std::vector<double> numbers = wanted.numbers(column, 0);
    return std::find(numbers.begin(), numbers.end(), number_in(entry, row.place + ", column " + column)) !=
           numbers.end();
  });
}

void read_load(const Section& load, const IndexRow& row, MotionLog& log) {
  const double mass = value_of(load, "mass", row, 0), length = value_of(load, "length", row, 0),
               rod = value_of(load, "rod_mass", row, 0);
  log.inertia = value_of(load, "inertia", row, 0) + (mass + rod / 3) * length * length;
  log.gravity = value_of(load, "gravity_moment", row, 0) + gravity * (mass + rod / 2) * length;
  if (!(log.inertia > 0))
    throw Error(load.where() + ": load", fmt::format("an inertia of {:g} kg m^2", log.inertia),
                "mass and length, or inertia, so that it is positive");
}

/// Columns of a log by what they hold.
struct Columns {
  std::string t, command, position, supply, powered, current, temperature, base_acceleration;
  std::array<std::string, channel_count> beside;

  explicit Columns(const Section& section) {
    section.allow_only({"t", "command", "position", "supply", "powered", "velocity", "duty", "torque",
                        "current", "temperature", "base_acceleration"});
    const auto named = [&](const char* key) {
      return section.has(key) ? section.text(key, "the name of a column") : std::string(key);
    };
    t = named("t"), command = named("command"), position = named("position");
    if (section.has("supply")) supply = named("supply");
    if (section.has("powered")) powered = named("powered");
    if (section.has("current")) current = named("current");
    if (section.has("temperature")) temperature = named("temperature");
    if (section.has("base_acceleration")) base_acceleration = named("base_acceleration");
    for (std::size_t c = 0; c < channel_count; ++c)
      if (const std::string key(channel_kinds[c].name); section.has(key)) beside[c] = named(key.c_str());
    if (!current.empty() && !beside[static_cast<std::size_t>(Channel::torque)].empty())
      section.refuse("current", "either torque or current");
  }
};

/// What the log holds beside position. A current is a torque by the torque constant, N m/A.
void read_channels(const LogTable& table, const Columns& columns, double torque_constant, MotionLog& log) {
  for (std::size_t c = 0; c < channel_count; ++c)
    if (!columns.beside[c].empty())
      log.beside.push_back({static_cast<Channel>(c), table.numbers(columns.beside[c])});
  if (columns.current.empty()) return;
  log.beside.push_back({Channel::torque, table.numbers(columns.current)});
  for (double& x : log.beside.back().value) x *= torque_constant;
}

/// Standard deviations of the channels that are read, in the units of the channels.
std::array<double, channel_count> noise_beside(const Section& noise, const Columns& columns,
                                               double torque_constant) {
  std::array<double, channel_count> sigma{};
  const auto of = [&](const std::string& key) {
    return positive(noise, key, "the standard deviation of a reading of " + key);
  };
  for (std::size_t c = 0; c < channel_count; ++c)
    if (!columns.beside[c].empty()) sigma[c] = of(std::string(channel_kinds[c].name));
  if (!columns.current.empty())
    sigma[static_cast<std::size_t>(Channel::torque)] = torque_constant * of("current");
  return sigma;
}

/// Temperatures as departures from the mean of the logs that are fitted, for which the stated numbers hold.
void center_temperatures(Bench& bench) {
  double sum = 0, count = 0;
  for (const MotionLog& log : bench.logs)
    for (const double x : log.warmer) sum += x, ++count;
  for (std::vector<MotionLog>* logs : {&bench.logs, &bench.held_out})
    for (MotionLog& log : *logs)
      for (double& x : log.warmer) x -= sum / count;
}

/// Leaves out channels that are no readings.
void look_beside(Bench& bench) {
  bench.channels = look_beside(bench.logs);
  for (const ChannelLook& look : bench.channels) {
    if (look.left_out.empty()) continue;
    for (std::vector<MotionLog>* logs : {&bench.logs, &bench.held_out})
      for (MotionLog& log : *logs)
        std::erase_if(log.beside, [&](const ChannelReadings& one) { return one.channel == look.channel; });
  }
}

MotionLog read_log(const std::filesystem::path& folder, const IndexRow& row, const Columns& columns,
                   double supply, double torque_constant) {
  const std::filesystem::path file = folder / row.file;
  const LogTable table = row.bam ? row.bam->entries : LogTable(files::read_text(file), file.string());
  MotionLog log;
  log.name = row.file;
  log.time = table.numbers(columns.t);
  log.command = table.numbers(columns.command);
  log.position = table.numbers(columns.position);
  log.supply =
      columns.supply.empty() ? std::vector<double>(log.time.size(), supply) : table.numbers(columns.supply);
  log.powered.assign(log.time.size(), true);
  if (!columns.powered.empty()) {
    const std::vector<double> on = table.numbers(columns.powered);
    for (std::size_t k = 0; k < on.size(); ++k) log.powered[k] = on[k] != 0;
  }
  if (!columns.temperature.empty()) log.warmer = table.numbers(columns.temperature);
  if (!columns.base_acceleration.empty()) log.base_acceleration = table.numbers(columns.base_acceleration);
  read_channels(table, columns, torque_constant, log);
  return log;
}

void require_inside(const std::filesystem::path& file, const std::string& place) {
  const std::filesystem::path plain = file.lexically_normal();
  if (plain.empty() || plain.is_absolute() || *plain.begin() == "..")
    throw Error(place, file.string(), "a file in the folder of the experiment");
}

std::vector<IndexRow> rows_of(const std::filesystem::path& folder, const Section& logs,
                              std::optional<LogTable>& index) {
  std::vector<IndexRow> rows;
  if (!logs.has("index")) {
    for (const std::string& file : logs.texts("files", "files of logs, or an index")) {
      rows.push_back({file, logs.place("files")});
      require_inside(file, logs.place("files"));
      if (const std::filesystem::path path = folder / file; path.extension() == ".json")
        rows.back().bam = std::make_shared<const BamLog>(bam_log(files::read_text(path), path.string()));
    }
    return rows;
  }
  const std::filesystem::path file = folder / logs.text("index", "the file of a table, one row a log");
  index.emplace(files::read_text(file), file.string());
  const std::string name = logs.has("file") ? logs.text("file", "a column of the index") : "file";
  const std::size_t column = index->column(name, logs.place("file"));
  for (std::size_t i = 0; i < index->rows(); ++i)
    rows.push_back({index->entry(i, column), index->place(i), &*index, i});
  return rows;
}

/// The stated numbers of the drive, and those that are unknown.
void read_drive(const Section& drive, Bench& bench) {
  const std::vector<Stated> numbers = stated_numbers(Sizes(bench.logs));
  std::set<std::string> known{"periods_per_turn"};
  for (const Stated& one : numbers) known.insert(std::string(one.id));
  drive.allow_only(known);
  for (const Stated& one : numbers) {
    const std::string key(one.id), expected = "a number in " + std::string(one.unit) + ", or \"unknown\"";
    if (!drive.has(key)) continue;
    if (drive.node(key).is_string()) {
      static_cast<void>(drive.one_of(key, {"unknown"}));
      bench.unknown.push_back(one.term);
      continue;
    }
    bench.nominal[one.term] = drive.number(key, expected);
    if (!one.signed_ && bench.nominal[one.term] < 0) drive.refuse(key, expected + ", not negative");
  }
  if (drive.has("periods_per_turn")) bench.periods = drive.numbers("periods_per_turn", 0);
  for (const double n : bench.periods)
    if (!(n > 0)) drive.refuse("periods_per_turn", "positive numbers");
  if (!drive.has("stall_torque"))
    throw Error(drive.place("stall_torque"), "none",
                "the torque at full duty over the supply, N m/V, or \"unknown\"");
}

ModelFile read_model(const std::filesystem::path& folder, const Section& model, const Section& servo) {
  model.allow_only({"file", "joint", "gain", "actuator"});
  ModelFile read;
  const auto text = [&](const char* key) {
    return model.has(key) ? model.text(key, "a text") : std::string();
  };
  if (model.has("file")) {
    require_inside(text("file"), model.place("file"));
    read.file = folder / text("file");
  }
  read.joint = text("joint"), read.actuator = text("actuator");
  if (model.has("gain"))
    read.gain =
        model.number("gain", "a number in the unit of servo.gain") * value_of(servo, "duty_per_error", {}, 1);
  return read;
}

Section settings_of(const toml::table& table, const std::filesystem::path& file) {
  const Section all(table, file.string());
  all.allow_only({"format", "name", "logs", "motion", "columns", "servo", "load", "drive", "noise", "model"});
  return all;
}

/// What all logs of an experiment share.
struct Setup {
  Section servo, load;
  Columns columns;
  EncoderSide encoder;
  double torque_constant;

  /// \param bench  gets its name, and what its readings scatter
  Setup(const Section& all, Bench& bench)
      : servo(all.table("servo")),
        load(all.table("load")),
        columns(all.table_or_empty("columns")),
        encoder(EncoderSide::joint),
        torque_constant(1) {
    servo.allow_only({"gain", "duty_per_error", "supply", "encoder", "torque_constant"});
    load.allow_only({"mass", "length", "rod_mass", "inertia", "gravity_moment"});
    const Section noise = all.table("noise");
    noise.allow_only({"position", "velocity", "duty", "torque", "current"});
    if (servo.has("encoder") && servo.one_of("encoder", {"joint", "motor"}) == "motor")
      encoder = EncoderSide::motor;
    if (!columns.current.empty())
      torque_constant = positive(servo, "torque_constant", "torque at the joint over current, N m/A");
    bench.name = all.name("name", "a name");
    bench.sigma = positive(noise, "position", "the standard deviation of a reading of position, rad");
    bench.sigma_beside = noise_beside(noise, columns, torque_constant);
  }

  /// Encoder, load, and the gain as duty per rad.
  void complete(const IndexRow& row, MotionLog& log) const {
    log.encoder = encoder;
    log.gain *= value_of(servo, "duty_per_error", row, 1);
    if (!(log.gain > 0))
      throw Error(row.place, fmt::format("a gain of {:g}", log.gain), "a positive one, duty per rad");
    read_load(load, row, log);
  }
};

MotionLog planned_motion(const Section& one, double supply) {
  one.allow_only({"kind", "size", "frequency", "duration", "rate", "gain"});
  const double size = positive(one, "size", "rad"),
               duration = one.has("duration") ? positive(one, "duration", "s") : 10,
               rate = one.has("rate") ? positive(one, "rate", "1/s") : 100;
  constexpr double fewest = 40, most = 1e5;  // readings
  if (const double readings = duration * rate; readings < fewest || readings > most)
    throw Error(one.where(), fmt::format("{:g} readings", readings), "between 40 and 100000");
  const std::string kind = one.one_of("kind", {"sine", "step", "sweep", "ramp"});
  if (kind == "step") return commanded(step(size), duration, rate, supply);
  if (kind == "ramp") return commanded(ramp(size, duration), duration, rate, supply);
  const double hertz = positive(one, "frequency", "Hz");
  return commanded(kind == "sine" ? sine(size, hertz) : sweep(size, hertz, duration), duration, rate, supply);
}

}  // namespace

bool is_motion(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  const toml::table table = files::parse_toml(files::read_text(file), file.string());
  return table["format"].value<std::string>() == "motion/1";
}

Bench read_bench(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  const toml::table table = files::parse_toml(files::read_text(file), file.string());
  const Section all = settings_of(table, file);
  const Section logs = all.table("logs");
  logs.allow_only({"files", "index", "file", "fit", "held_out"});
  Bench bench;
  const Setup setup(all, bench);
  std::optional<LogTable> index;
  for (const IndexRow& row : rows_of(folder, logs, index)) {
    const bool held_out = logs.has("held_out") && is_chosen(logs, "held_out", row);
    if (!held_out && logs.has("fit") && !is_chosen(logs, "fit", row)) continue;
    require_inside(row.file, row.place);
    MotionLog log =
        read_log(folder, row, setup.columns, value_of(setup.servo, "supply", row, 1), setup.torque_constant);
    log.gain = value_of(setup.servo, "gain", row, 1);
    setup.complete(row, log);
    require_judgeable(log);
    mend_spikes(log, bench.sigma);
    (held_out ? bench.held_out : bench.logs).push_back(std::move(log));
  }
  if (bench.logs.empty()) throw Error(logs.where() + ": logs", "no log to fit to", "one at least");
  center_temperatures(bench);
  look_beside(bench);
  read_drive(all.table("drive"), bench);
  bench.model = read_model(folder, all.table_or_empty("model"), setup.servo);
  return bench;
}

Bench read_planned_bench(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "experiment.toml";
  const toml::table table = files::parse_toml(files::read_text(file), file.string());
  const Section all = settings_of(table, file);
  Bench bench;
  const Setup setup(all, bench);
  for (const Section& one : all.tables("motion")) {
    MotionLog log = planned_motion(one, value_of(setup.servo, "supply", {}, 1));
    if (one.has("gain")) {
      log.gain = positive(one, "gain", "in the unit of servo.gain");
      log.name += fmt::format(", gain {:g}", log.gain);
    } else {
      log.gain = value_of(setup.servo, "gain", {}, 1);
    }
    setup.complete({log.name, one.where()}, log);
    log.position = log.command;  // of a servo that follows, until the model predicts it
    bench.logs.push_back(std::move(log));
  }
  if (bench.logs.empty())
    throw Error(all.place("motion"), "none", "[[motion]], one for each that is planned");
  read_drive(all.table("drive"), bench);
  return bench;
}

}  // namespace plumbline::motion
