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
#include "diagnose/draft/read_draft_model.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "support/files/output_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/read_bytes.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::string folder, model, joints, columns;
  exchange::ArmEnds ends;
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

/// In a script nobody sees a question mark: what is asked or in doubt ends it, with the line that says it.
void require_answers(const diagnose::Draft& draft, const NewOptions& options) {
  std::vector<std::string> open;
  if (!draft.question.empty()) open.push_back(draft.question);
  for (const diagnose::Guess& guess : draft.guesses)
    if (guess.doubtful && !options.yes && !guess.line.empty())
      open.push_back(fmt::format("{}: {} ({}); write {}", guess.what, guess.value, guess.reason, guess.line));
  if (open.empty()) return;
  fmt::print("Still asked{}\n  {}\n", draft.question.empty() ? ", or pass --yes" : "",
             fmt::join(open, "\n  "));
  throw CLI::RuntimeError(1);
}

/// What `diagnose` is to be told.
std::string ways_on(const diagnose::Draft& draft, const NewOptions& options) {
  const std::string corrected = " --corrected corrected" + fs::path(options.model).extension().string();
  if (draft.bench == diagnose::BenchKind::arm) return corrected;
  return options.joints.empty() ? " --model " + options.model + corrected : "";
}

void run(const NewOptions& options) {
  const fs::path folder = options.folder;
  require_new(folder);
  std::vector<diagnose::DraftFile> tables;
  for (const std::string& table : options.tables)
    tables.push_back({fs::path(table).filename().string(), files::read_bytes(table)});
  const diagnose::ReadDraftModel read =
      diagnose::read_draft_model(options.model, names_in(options.joints), options.ends);
  const fs::path name = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  const diagnose::Draft draft =
      diagnose::draft_experiment(files::printable(name.string()), read.model, tables,
                                 ask_on_terminal(options), diagnose::told_columns(options.columns));
  write_draft(draft, folder);
  for (const std::string& note : read.notes(draft.bench)) fmt::print("  {}\n", note);
  for (const diagnose::Guess& guess : draft.guesses) fmt::print("{}\n", line(guess));
  fmt::print("\nWritten: {}\n", (folder / "experiment.toml").string());
  require_answers(draft, options);
  fmt::print("Next: plumbline diagnose {}{}\n", folder.string(), ways_on(draft, options));
}

}  // namespace

void add_new(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "new",
      "An experiment's folder out of a model and tables of readings; every guess is said, with its reason");
  const auto options = std::make_shared<NewOptions>();
  verb->add_option("folder", options->folder, "The folder to make")->type_name("FOLDER")->required();
  verb->add_option("tables", options->tables,
                   "Tables of readings, as the lab has them: text in columns, in any encoding, JSON Lines or "
                   ".xlsx; a run each")
      ->type_name("FILE")
      ->required();
  verb->add_option("--model", options->model, "The nominal model: .xml (MJCF), .urdf, .sdf or .toml")
      ->type_name("FILE")
      ->required();
  verb->add_option(
          "--joints", options->joints,
          "The joints of the model that make the chain, with commas between them; the others are held")
      ->type_name("NAMES");
  verb->add_option("--base", options->ends.base, "Of an arm in space: the body at its base")
      ->type_name("NAME");
  verb->add_option("--tip", options->ends.tip, "Of an arm in space: the body or frame at its tip")
      ->type_name("NAME");
  verb->add_option("--columns", options->columns,
                   "What columns hold, by title or number: x=Traverse:mm,Fx=-3:kgf,ignore=humidity")
      ->type_name("CHANNEL=COLUMN:UNIT,...");
  verb->add_flag("--yes", options->yes, "Take every guess, also those in doubt");
  verb->footer(
      "Exit status 1 where something is left that a person has to say: it is written at the end, with the "
      "line to write.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
