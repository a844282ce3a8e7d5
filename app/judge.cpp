// The verb `verify` alone: the part of the program that the first verdict needs.
#include "app/command.hpp"
#include "app/verbs.hpp"

int main(int argc, char** argv) {
  const auto command = plumbline::app::bare_command();
  plumbline::app::add_verify(*command);
  return plumbline::app::run(*command, argc, argv);
}
