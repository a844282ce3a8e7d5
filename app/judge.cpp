// The verb `verify` alone: what the first verdict needs, without the rest of the program.
#include "app/command.hpp"
#include "app/verbs.hpp"

int main(int argc, char** argv) {
  const auto command = plumbline::app::bare_command();
  plumbline::app::add_verify(*command);
  return plumbline::app::run(*command, argc, argv);
}
