#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/drafted_folder.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "support/files/output_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::string folder, model, joints;
  std::vector<std::string> tables;
  bool yes = false;
};

std::string line(const diagnose::Guess& guess) {
  return fmt::format("{} {}: {}  ({})", guess.doubtful ? "?" : " ", guess.what, guess.value, guess.reason);
}

/// Asks a person who can answer.
diagnose::Ask ask_on_terminal(const NewOptions& options) {
  if (options.yes || terminal_columns(0) == 0 || terminal_columns(1) == 0) return {};
  return [](const diagnose::Guess& guess) -> std::optional<std::string> {
    fmt::print("{}\n  Enter takes it; or write another: ", line(guess));
    std::cout.flush();
    std::string answer;
    if (!std::getline(std::cin, answer) || answer.find_first_not_of(" \t") == std::string::npos) return {};
    return answer;
  };
}

/// Whoever has files there already keeps them.
void require_new(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !(fs::is_directory(folder, ignored) && fs::is_empty(folder, ignored)))
    throw Error(folder.string(), "something there already", "a new folder, or an empty one");
}

void run(const NewOptions& options) {
  const fs::path folder = options.folder;
  require_new(folder);
  std::vector<diagnose::DraftFile> tables;
  for (const std::string& table : options.tables)
    tables.push_back({fs::path(table).filename().string(), files::read_text(table)});
  const ReadForDraft read = read_for_draft(options.model, names_in(options.joints));
  const fs::path name = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  const diagnose::Draft draft = diagnose::draft_experiment(files::printable(name.string()), read.model,
                                                           tables, ask_on_terminal(options));
  write_draft(draft, folder);
  for (const std::string& note : read.notes) fmt::print("  {}\n", note);
  for (const diagnose::Guess& guess : draft.guesses) fmt::print("{}\n", line(guess));
  fmt::print("\nWritten: {}\n", (folder / "experiment.toml").string());
  if (!draft.question.empty()) {
    fmt::print("Still asked\n  {}\n", draft.question);
    throw CLI::RuntimeError(1);
  }
  fmt::print("Next: plumbline diagnose {}{}\n", folder.string(),
             options.joints.empty() ? " --model " + options.model + " --corrected corrected" +
                                          fs::path(options.model).extension().string()
                                    : "");
}

}  // namespace

void add_new(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "new",
      "An experiment's folder out of a model and tables of readings; every guess is said, with its reason");
  const auto options = std::make_shared<NewOptions>();
  verb->add_option("folder", options->folder, "The folder to make")->type_name("FOLDER")->required();
  verb->add_option("tables", options->tables,
                   "Tables of readings, as the lab has them: CSV, or any text in columns; a run each")
      ->type_name("FILE")
      ->required();
  verb->add_option("--model", options->model, "The nominal model: .xml (MJCF), .urdf, .sdf or .toml")
      ->type_name("FILE")
      ->required();
  verb->add_option(
          "--joints", options->joints,
          "The joints of the model that make the chain, with commas between them; the others are held")
      ->type_name("NAMES");
  verb->add_flag("--yes", options->yes, "Ask nothing, also on a terminal");
  verb->footer("Exit status 1 where something is left that a person has to say: it is written at the end.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
