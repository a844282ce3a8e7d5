#include "app/command.hpp"

#include <iostream>
#include <plumbline/base/error.hpp>

namespace plumbline::app {

std::unique_ptr<CLI::App> bare_command() {
  auto command = std::make_unique<CLI::App>("What is true of elastic serial chains under load.", "plumbline");
  command->require_subcommand(0, 1);
  command->footer("Exit status: 0 done, 1 a claim or a check failed, 2 bad input.");
  return command;
}

int run(CLI::App& command, int argc, char** argv) {
  constexpr int bad_input = 2;
  try {
    command.parse(argc, argv);
    if (command.get_subcommands().empty()) std::cout << command.help();
    if (!std::cout.flush()) throw Error("standard output", "a failure while writing", "all written");
    return 0;
  } catch (const CLI::Success& help) {
    return command.exit(help);
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (const std::exception& error) {
    std::cerr << "plumbline: " << error.what() << '\n';
    return bad_input;
  }
}

}  // namespace plumbline::app
