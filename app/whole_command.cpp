#include "app/arguments.hpp"
#include "app/command.hpp"
#include "app/verbs.hpp"

namespace plumbline::app {

std::unique_ptr<CLI::App> whole_command() {
  auto command = bare_command();
  add_verify(*command);
  add_critical(*command);
  add_path(*command);
  add_equilibria(*command);
  add_figure(*command);
  add_reference(*command);
  add_check(*command);
  add_new(*command);
  add_check_experiment(*command);
  add_diagnose(*command);
  add_serve(*command);
  add_chain(*command);
  add_arm(*command);
  add_trial(*command);
  for (CLI::App* verb : command->get_subcommands({}))
    for (CLI::Option* option : verb->get_options())
      if (option->get_items_expected_max() > 0) option->check(something());
  return command;
}

}  // namespace plumbline::app
