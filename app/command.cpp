#include "app/command.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <new>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/commit.hpp"
#include "app/complaints.hpp"
#include "support/files/nearest.hpp"
#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

/// A file that is opened must not take the place of a standard stream that was closed.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (fcntl(stream, F_GETFD) < 0)
      static_cast<void>(open("/dev/null", O_RDONLY));  // refuses what is written
}

/// Words go into reports, which are text.
void require_text(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (files::first_bad_byte(argv[i]) != std::string::npos)
      throw Error("argument " + std::to_string(i), files::shown(argv[i]), "text in UTF-8");
}

/// A word in the place of a verb that is none.
void require_verb(const CLI::App& command, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : command.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), argv[1]) == verbs.end())
    throw Error("command line", files::shown(argv[1]), files::expected_word(argv[1], verbs));
}

/// The option of the verb that is nearest to one that it does not have; or empty.
std::string nearest_option(const CLI::ExtrasError& error, const CLI::App& command) {
  const std::string said = error.what();
  const std::size_t at = said.find("--");
  if (at == std::string::npos) return "";
  std::vector<std::string> options;
  for (const CLI::App* verb : command.get_subcommands())
    for (const CLI::Option* option : verb->get_options())
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  return files::nearest(said.substr(at, said.find_first_of(" =", at) - at), options);
}

/// The exception in flight, as one line that names the place, what was found and what was expected.
std::string what_went_wrong(const CLI::App& command) {
  try {
    throw;
  } catch (const CLI::ExtrasError& error) {
    const std::string near = nearest_option(error, command);
    return in_our_words(error) + (near.empty() ? "" : "; the nearest option is " + near);
  } catch (const CLI::ParseError& error) {
    return in_our_words(error);
  } catch (const std::filesystem::filesystem_error& error) {
    return error.path1().string() + ": found " + error.code().message() +
           ", expected a file that can be used";
  } catch (const std::bad_alloc&) {
    return "memory: found no more, expected a smaller task or a larger machine";
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception&) {  // whose words are a library's
    return "plumbline: found a computation that failed, expected a result: please report the command and its "
           "input";
  }
}

}  // namespace

std::string program_name() {
  const std::string built = *commit == '\0' ? "" : " (" + std::string(commit) + ")";
  return "plumbline " PLUMBLINE_VERSION + built;
}

std::unique_ptr<CLI::App> bare_command() {
  auto command = std::make_unique<CLI::App>(
      "Why a real elastic chain differs from its model; buckling loads with proof; a paper, checked claim by "
      "claim.",
      "plumbline");
  command->require_subcommand(0, 1);
  command->set_version_flag("--version", program_name());
  command->footer("Exit status: 0 done, 1 a claim or a check failed, 2 bad input.");
  return command;
}

int run(CLI::App& command, int argc, char** argv) {
  constexpr int bad_input = 2;
  hold_standard_streams();
  try {
    require_text(argc, argv);
    require_verb(command, argc, argv);
    command.parse(argc, argv);
    if (command.get_subcommands().empty()) std::cout << command.help();
    if (!std::cout.flush()) throw Error("standard output", "a failure while writing", "all written");
    return 0;
  } catch (const CLI::Success& help) {
    return command.exit(help);
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (...) {
    complain(what_went_wrong(command));
    return bad_input;
  }
}

}  // namespace plumbline::app
