#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <sstream>

#include "diagnose/api/report.hpp"
#include "diagnose/api/study_files.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/report/plan.hpp"
#include "diagnose/report/view.hpp"
#include "python/engine/engine.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/sha256.hpp"
#include "support/page/provenance.hpp"

namespace plumbline::python {
namespace {

using diagnose::Experiment, diagnose::NominalChain, diagnose::Study;
using Column = py::array_t<double, py::array::c_style | py::array::forcecast>;
constexpr const char* program = "plumbline " PLUMBLINE_VERSION " for Python";

/// By name of the column, of one run.
using Samples = std::vector<std::pair<std::string, Column>>;

void put(toml::array& list, const py::handle& value);
void put(toml::table& table, const std::string& key, const py::handle& value);

/// Hands a value of Python's to what takes one of TOML's.
template <class Put>
void as_toml(const py::handle& value, const Put& put_value) {
  if (py::isinstance<py::bool_>(value)) {
    put_value(value.cast<bool>());
  } else if (py::isinstance<py::int_>(value)) {
    put_value(value.cast<std::int64_t>());
  } else if (py::isinstance<py::float_>(value)) {
    put_value(value.cast<double>());
  } else if (py::isinstance<py::dict>(value)) {
    toml::table table;
    for (const auto& [key, entry] : py::reinterpret_borrow<py::dict>(value)) put(table, py::str(key), entry);
    put_value(std::move(table));
  } else if (py::isinstance<py::list>(value)) {
    toml::array list;
    for (const py::handle entry : py::reinterpret_borrow<py::list>(value)) put(list, entry);
    put_value(std::move(list));
  } else {
    put_value(std::string(py::str(value)));
  }
}

void put(toml::array& list, const py::handle& value) {
  as_toml(value, [&](auto&& one) { list.push_back(std::forward<decltype(one)>(one)); });
}

void put(toml::table& table, const std::string& key, const py::handle& value) {
  as_toml(value, [&](auto&& one) { table.insert_or_assign(key, std::forward<decltype(one)>(one)); });
}

toml::table as_toml(const py::dict& settings) {
  toml::table table;
  for (const auto& [key, value] : settings) put(table, py::str(key), value);
  return table;
}

/// Columns of numbers as the fields of a sample file, each as the shortest decimal that is read as itself.
diagnose::SampleTable table_of_columns(const Samples& columns) {
  diagnose::SampleTable table;
  table.header_line = 0;
  for (const auto& [name, values] : columns) table.header.push_back(name);
  const auto rows = columns.empty() ? 0 : static_cast<std::size_t>(columns.front().second.size());
  for (std::size_t row = 0; row < rows; ++row) {
    files::CsvRow& fields = table.rows.emplace_back(files::CsvRow{row + 1, {}});
    for (const auto& [name, values] : columns) {
      const double value = values.data()[row];
      fields.fields.push_back(std::isnan(value) ? "" : fmt::format("{}", value));
    }
  }
  return table;
}

std::optional<NominalChain> model_of(const std::string& file) {
  if (file.empty()) return std::nullopt;
  return exchange::read_model(file).chain;
}

/// The file of the nominal model: the one that is given, or that an experiment names for its arm; empty
/// without one.
std::filesystem::path source_of(const toml::table& settings, const std::string& model) {
  const auto named = settings["arm"]["model"].value<std::string>();
  return model.empty() && named ? *named : model;
}

/// \param read_with  one of the readers of experiments in memory
template <class Read>
Experiment experiment_of(const py::dict& settings, const std::vector<Samples>& samples,
                         const std::string& model, const Read& read_with) {
  const std::optional<NominalChain> nominal = model_of(model);
  const toml::table table = as_toml(settings);
  std::size_t run = 0;
  const diagnose::ReadParts read = [&](const diagnose::Section& section,
                                       const diagnose::SampleFormat& format) {
    const std::string source = "samples of run \"" + section.text("id", "a name") + "\"";
    return std::vector<diagnose::SamplePart>{{source, table_of_columns(samples.at(run++)), format}};
  };
  return read_with(table, "experiment", read, nominal ? &*nominal : nullptr);
}

/// How the diagnosis is to be made.
struct Wish {
  std::string effects;  ///< a file; or empty
  bool next, as_is;
  py::object progress;  ///< called with the share that is done; or none
};

/// Hands the share that is done to Python, whose interrupts end the work.
auto reporting(const py::object& progress) {
  return [&progress](double share) {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none()) progress(share);
  };
}

/// Poses of an arm are no path: each stands by the number that it was taken as, from 0.
diagnose::Command by_reading(const diagnose::Run& run) {
  diagnose::Command command{{}, "reading", 0};
  for (std::size_t r = 0; r < run.readings.size(); ++r)
    command.along.push_back(static_cast<double>(run.first_taken(r)));
  return command;
}

/// A joint that slides has a place and a force for its angle and its torque.
std::string unit_of(const diagnose::Channel& channel, const Experiment& experiment) {
  using Name = diagnose::Channel::Name;
  if (channel.name == Name::q) return experiment.joint_unit(channel.joint);
  return channel.name == Name::drive ? experiment.torque_unit(channel.joint) : std::string(channel.unit());
}

/// A measured series beside what the nominal and the corrected model say.
py::dict curve_of(const diagnose::Series& series, const diagnose::Explained& seen) {
  const diagnose::Run& run = seen.experiment.runs[series.run];
  const diagnose::Command command = seen.experiment.visits_poses() ? by_reading(run) : command_of(run);
  const Eigen::Index column = series.channel.column;
  std::vector<double> along, measured, nominal, corrected;
  for (const std::size_t r : series.readings) {
    const auto row = static_cast<Eigen::Index>(r);
    along.push_back(command.along[r]);
    measured.push_back(series.channel.of(run.readings[r]));
    nominal.push_back(seen.nominal.runs[series.run](row, column));
    corrected.push_back(seen.corrected.runs[series.run](row, column));
  }
  py::dict one;
  one["run"] = run.id, one["channel"] = series.channel.label();
  one["unit"] = unit_of(series.channel, seen.experiment), one["command"] = command.label;
  one["along"] = array_of(along), one["measured"] = array_of(measured);
  one["nominal"] = array_of(nominal), one["corrected"] = array_of(corrected), one["model"] = seen.model;
  return one;
}

/// A diagnosis and what it is about.
class Diagnosed {
 public:
  /// \param model  the file that the nominal chain was read from; or empty
  Diagnosed(Experiment experiment, const Wish& wish, page::Provenance from, std::filesystem::path model)
      : from_(std::move(from)), model_(std::move(model)), report_(unlocked([&] {
          return diagnose::Report(diagnose::study_of(std::move(experiment), wish.effects),
                                  {wish.as_is, wish.next, reporting(wish.progress)});
        })) {}

  [[nodiscard]] std::string json() const { return page::json_text(report_.json(), from_); }
  [[nodiscard]] std::string text() const { return report_.text(); }
  [[nodiscard]] std::string html() const {
    return unlocked([&] { return page::on_page(report_.html(), from_); });
  }
  /// The corrected models, one a candidate: the cause where there are several, the text, and what became of
  /// each effect. \param ending  ".xml", of the format that is wanted
  [[nodiscard]] py::list corrected(const std::string& ending) const {
    py::list all;
    for (const exchange::Corrected& one : report_.corrected(model_)) {
      const exchange::Written file =
          unlocked([&] { return exchange::written(one.model, exchange::format_of("model" + ending)); });
      py::list effects;
      for (const exchange::Carried& effect : file.effects)
        effects.append(py::make_tuple(effect.effect, effect.carried, effect.how));
      all.append(py::make_tuple(one.cause, file.text, effects, file.note));
    }
    return all;
  }
  /// Every measured series beside what the nominal and the corrected model say.
  [[nodiscard]] py::list curves() const {
    const diagnose::Explained seen(report_.study(), report_.diagnosis());
    py::list all;
    for (const diagnose::Series& series : seen.measurements.series()) all.append(curve_of(series, seen));
    return all;
  }

 private:
  page::Provenance from_;
  std::filesystem::path model_;
  diagnose::Report report_;
};

/// Of arrays the digest is that of their decimals.
page::Provenance provenance(const char* function, const py::dict& settings,
                            const std::vector<Samples>& samples, const std::filesystem::path& model,
                            const std::string& effects) {
  std::ostringstream text;
  text << as_toml(settings);
  for (const Samples& run : samples)
    for (const auto& [name, values] : run) {
      text << "\n" << name;
      for (py::ssize_t row = 0; row < values.size(); ++row)
        text << "," << fmt::format("{}", values.data()[row]);
    }
  for (const std::filesystem::path& file : {model, std::filesystem::path(effects)})
    if (!file.empty()) text << "\n" << files::sha256(std::vector<std::filesystem::path>{file});
  return {program, fmt::format("plumbline.{}(…)", function), files::sha256(text.str())};
}

page::Provenance provenance(const std::string& folder, const std::string& model, const std::string& effects) {
  std::vector<std::filesystem::path> files = files::files_read(folder);
  for (const std::string& file : {model, effects})
    if (!file.empty()) files.emplace_back(file);
  return {program, fmt::format("plumbline.diagnose_folder('{}')", folder), files::sha256(files)};
}

/// \param samples  of those runs alone whose settings have the key `samples`
std::string plan(const py::dict& settings, const std::vector<Samples>& samples, const std::string& model,
                 const std::string& effects, const py::object& progress) {
  const page::Provenance from = provenance("plan", settings, samples, model, effects);
  Experiment bench = experiment_of(settings, samples, model,
                                   [](const auto&... given) { return diagnose::read_plan(given...); });
  return unlocked([&] {
    const Experiment studied = diagnose::study_of(bench, effects).experiment();
    return page::json_text(as_json(diagnose::plan(studied, reporting(progress))), from);
  });
}

}  // namespace

void add_diagnosis(py::module_& module) {
  using namespace py::literals;
  py::class_<Diagnosed>(module, "Diagnosed")
      .def("json", &Diagnosed::json)
      .def("text", &Diagnosed::text)
      .def("html", &Diagnosed::html)
      .def("corrected", &Diagnosed::corrected)
      .def("curves", &Diagnosed::curves);
  module.def(
      "diagnose",
      [](const py::dict& settings, const std::vector<Samples>& samples, const std::string& model,
         std::string effects, bool next, bool as_is, py::object progress) {
        const std::filesystem::path source = source_of(as_toml(settings), model);
        const char* const function = settings.contains("arm") ? "diagnose_arm" : "diagnose";
        page::Provenance from = provenance(function, settings, samples, source, effects);
        Experiment experiment = experiment_of(settings, samples, model, [](const auto&... given) {
          exchange::ArmReader arms;
          return arms.with_effects(diagnose::read_experiment(given..., arms.read()));
        });
        return std::make_unique<Diagnosed>(std::move(experiment),
                                           Wish{std::move(effects), next, as_is, std::move(progress)},
                                           std::move(from), source);
      },
      "settings"_a, "samples"_a, py::kw_only(), "model"_a, "effects"_a, "next"_a, "as_is"_a, "progress"_a);
  module.def("plan", &plan, "settings"_a, "samples"_a, py::kw_only(), "model"_a, "effects"_a, "progress"_a);
  module.def(
      "diagnose_folder",
      [](const std::string& folder, const std::string& model, std::string effects, bool next, bool as_is,
         py::object progress) {
        page::Provenance from = provenance(folder, model, effects);
        const diagnose::StudyFiles files{folder, model, effects};
        Experiment experiment = experiment_of(files);
        return std::make_unique<Diagnosed>(std::move(experiment),
                                           Wish{std::move(effects), next, as_is, std::move(progress)},
                                           std::move(from), files.nominal_model());
      },
      "folder"_a, py::kw_only(), "model"_a, "effects"_a, "next"_a, "as_is"_a, "progress"_a);
}

}  // namespace plumbline::python
