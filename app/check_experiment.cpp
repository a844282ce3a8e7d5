#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <plumbline/base/error.hpp>

#include "app/complaints.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/api/study_files.hpp"
#include "diagnose/screening/anomalies.hpp"
#include "diagnose/screening/conventions.hpp"

namespace plumbline::app {
namespace {

using diagnose::Channel;
using diagnose::Experiment;
using diagnose::Origin;
using diagnose::Run;

constexpr std::string_view command = "q_command";

/// NaN for a load on an arm.
double value_of(const diagnose::Reading& reading, const Origin& origin) {
  if (origin.channel) return origin.channel->of(reading);
  if (origin.what == "t") return reading.t;
  if (!origin.what.starts_with(command)) return NAN;
  return reading.rest.at(std::stoul(origin.what.substr(command.size())) - 1);
}

/// Whether there is something to say of a column: it is in the file, or counted, or would answer.
bool is_told(const Run& run, const Origin& origin) {
  if (!origin.source.empty() || origin.what == "t") return true;
  const std::vector<Channel> answering = run.answering();
  return origin.channel && std::ranges::find(answering, *origin.channel) != answering.end();
}

/// "Fx  Kraft, kgf  -3.64 to 0 N, 9 readings, noise 0.0196 N".
std::string column_line(const Experiment& experiment, const Run& run, std::size_t column) {
  const Origin& origin = run.origins[column];
  const std::string name = fmt::format("    {:<3} ", origin.what);
  const std::optional<Channel>& channel = origin.channel;
  std::size_t count = 0;
  double least = INFINITY, most = -INFINITY;
  for (const diagnose::Reading& reading : run.readings) {
    const double value = value_of(reading, origin);
    if (std::isnan(value)) continue;
    ++count;
    least = std::min(least, value + 0.0), most = std::max(most, value + 0.0);  // no "-0"
  }
  if (count == 0 && !channel) return name + origin.source + ", " + origin.unit + ", a load\n";
  if (count == 0) return name + "not measured\n";
  const bool counted = origin.source.empty();
  std::string line =
      name + fmt::format("{:<22} ", counted ? "the readings, counted" : origin.source + ", " + origin.unit);
  line += least == most ? fmt::format("{:.4g}", least) : fmt::format("{:.4g} to {:.4g}", least, most);
  line += fmt::format(" {}", origin.si);
  const auto imposed = run.imposed();
  if (origin.what == "t") return line + "\n";
  if (!channel || std::find(imposed.begin(), imposed.end(), *channel) != imposed.end())
    return line + ", imposed\n";
  if (count < run.readings.size()) line += fmt::format(", {} of {} readings", count, run.readings.size());
  return line + fmt::format(", noise {:.3g} {}\n", channel->sigma(experiment.noise), origin.si);
}

/// "temperature  T  20.1 to 24.3, 55 of 60 readings interpolated", "tension  F, mN  0 to 12 N, a load".
std::string covariate_line(const Run& run, std::size_t covariate, const Origin& origin) {
  double least = INFINITY, most = -INFINITY;
  for (const diagnose::Reading& reading : run.readings) {
    least = std::min(least, reading.covariates[covariate]);
    most = std::max(most, reading.covariates[covariate]);
  }
  const auto load = std::find_if(run.loads.begin(), run.loads.end(), [&](const diagnose::LoadChannel& one) {
    return one.covariate == covariate;
  });
  const bool loads = load != run.loads.end();
  std::string line = fmt::format("    {} {:<22} {:.4g} to {:.4g}", origin.what,
                                 loads ? origin.source + ", " + origin.unit : origin.source, least, most);
  if (loads) line += fmt::format(" {}, a load", load->unit);
  if (const std::size_t count = run.interpolated[covariate]; count > 0)
    line += fmt::format(", {} of {} readings interpolated in time", count, run.readings.size());
  return line + "\n";
}

std::string nominal_lines(const Experiment& experiment) {
  const auto unit = [&](const std::string& key) {
    const auto one = std::find_if(experiment.origins.begin(), experiment.origins.end(),
                                  [&](const Origin& origin) { return origin.what == key; });
    return one == experiment.origins.end() || one->in_si == 1 ? std::string() : ", written in " + one->unit;
  };
  std::string text = experiment.has_links()
                         ? fmt::format("  link_length      {:.6g} m{}\n",
                                       fmt::join(experiment.link_length, ", "), unit("link_length"))
                         : std::string("  a joint alone\n");
  text += fmt::format("  joint_stiffness  {:.6g} {}{}\n", fmt::join(experiment.joint_stiffness, ", "),
                      experiment.slides(0) ? "N/m" : "N m/rad", unit("joint_stiffness"));
  if (std::any_of(experiment.link_mass.begin(), experiment.link_mass.end(), [](double m) { return m > 0; }))
    text += fmt::format("  link_mass        {:.6g} kg{}\n", fmt::join(experiment.link_mass, ", "),
                        unit("link_mass"));
  return text;
}

std::string what_was_read(const Experiment& experiment) {
  std::string text = experiment.name + "\n\nThe nominal chain\n" + nominal_lines(experiment) + "\nThe runs\n";
  for (const Run& run : experiment.runs) {
    text += fmt::format("  {}: {} imposed, {} readings{}\n", run.id,
                        run.commands_joints()       ? "the joints' commands are"
                        : run.imposed().size() == 1 ? "the " + run.imposed().front().label() + " is"
                        : run.holds_end_point()     ? "the end point is"
                        : run.weights_inferred      ? "the force, assumed to be that of weights, is"
                                                    : "the force is",
                        run.readings.size(), run.turns_back() ? ", there and back" : "");
    if (!run.commands_joints())
      text += fmt::format("    rest {:.4g} {}\n", fmt::join(run.rest, ", "), experiment.joint_unit(0));
    if (!run.continued_by.empty())
      text += fmt::format("    {} goes on where it ends, in time and command: read as one run\n",
                          fmt::join(run.continued_by, ", "));
    const std::size_t channels = run.origins.size() - experiment.covariates.size();
    for (std::size_t c = 0; c < channels; ++c)
      if (is_told(run, run.origins[c])) text += column_line(experiment, run, c);
    for (std::size_t c = channels; c < run.origins.size(); ++c)
      text += covariate_line(run, c - channels, run.origins[c]);
  }
  return text;
}

struct Seen {
  Experiment experiment;
  std::vector<std::string> odd;
  std::string question;  ///< empty where nothing is to be asked
};

Seen looked_at(const diagnose::StudyFiles& input) {
  const Progress progress("experiment", 0);
  Seen seen{experiment_of(input), {}, ""};
  seen.odd = diagnose::anomalies(seen.experiment);
  const diagnose::Study study = study_of(seen.experiment, input.effects);
  try {
    diagnose::require_conventions(study);
  } catch (const Error& question) {
    seen.question = question.what();
  }
  return seen;
}

void run(const diagnose::StudyFiles& input) {
  const Seen seen = looked_at(input);
  fmt::print("{}\n", what_was_read(seen.experiment));
  if (!seen.odd.empty()) fmt::print("Odd\n  {}\n\n", fmt::join(seen.odd, "\n  "));
  if (!seen.question.empty()) {
    fmt::print("Asked\n  {}\n", seen.question);
    throw CLI::RuntimeError(1);
  }
  fmt::print("Nothing looks like another unit, sign, axis or order.\n");
}

}  // namespace

void add_check_experiment(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "check-experiment",
      "What is read from an experiment, in which units, with anomalies; nothing is fitted");
  const auto input = std::make_shared<diagnose::StudyFiles>();
  verb->add_option("experiment", input->folder, "A folder with experiment.toml and its sample files")
      ->type_name("FOLDER")
      ->required();
  verb->add_option("--model", input->model, "The nominal model, as for diagnose")->type_name("FILE");
  verb->add_option("--effects", input->effects, "Your own effects in this model, as for diagnose")
      ->type_name("FILE");
  verb->footer("Exit status 1 where numbers look like another unit, sign, axis or order.");
  verb->callback([input] { run(*input); });
}

}  // namespace plumbline::app
