#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <new>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/complaints.hpp"
#include "app/verbs.hpp"

namespace {

constexpr int bad_input = 2;

/// A file that is opened must not take the place of a standard stream that was closed.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (fcntl(stream, F_GETFD) < 0)
      static_cast<void>(open("/dev/null", O_RDONLY));  // refuses what is written
}

/// The exception in flight, as one line that names the place, what was found and what was expected.
std::string what_went_wrong() {
  try {
    throw;
  } catch (const CLI::ParseError& error) {
    return plumbline::app::in_our_words(error);
  } catch (const std::filesystem::filesystem_error& error) {
    return error.path1().string() + ": found " + error.code().message() +
           ", expected a file that can be used";
  } catch (const std::bad_alloc&) {
    return "memory: found no more, expected a smaller task or a larger machine";
  } catch (const std::exception& error) {
    return error.what();
  }
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) std::cout << app.help();
    if (!std::cout.flush())
      throw plumbline::Error("standard output", "a failure while writing", "all written");
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (...) {
    plumbline::app::complain(what_went_wrong());
    return bad_input;
  }
}

}  // namespace

int main(int argc, char** argv) {
  hold_standard_streams();
  CLI::App app("What is true of elastic serial chains under load.", "plumbline");
  app.require_subcommand(0, 1);
  app.footer("Exit status: 0 done, 1 a claim or a check failed, 2 bad input.");
  plumbline::app::add_verify(app);
  plumbline::app::add_critical(app);
  plumbline::app::add_path(app);
  plumbline::app::add_equilibria(app);
  plumbline::app::add_figure(app);
  plumbline::app::add_reference(app);
  plumbline::app::add_check(app);
  plumbline::app::add_diagnose(app);
  plumbline::app::add_trial(app);
  return run(app, argc, argv);
}
