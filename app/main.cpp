#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app("What is true of elastic serial chains under load.");
  CLI11_PARSE(app, argc, argv);
  return 0;
}
