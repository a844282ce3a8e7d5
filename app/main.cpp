#include "app/command.hpp"

int main(int argc, char** argv) {
  return plumbline::app::run(*plumbline::app::whole_command(), argc, argv);
}
