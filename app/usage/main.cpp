// Writes the man page and the shell completions of the program into a folder, when it is built.
#include <filesystem>
#include <iostream>

#include "app/command.hpp"
#include "app/usage/usage.hpp"
#include "support/files/output_file.hpp"

int main(int argc, char** argv) {
  using namespace plumbline;
  try {
    if (argc != 2) throw std::invalid_argument("usage: plumbline-usage FOLDER");
    const std::filesystem::path folder = argv[1];
    files::make_folder(folder);
    const auto command = app::whole_command();
    files::write_text(folder / "plumbline.1", app::man_page(*command, PLUMBLINE_VERSION));
    files::write_text(folder / "plumbline", app::bash_completion(*command));
    files::write_text(folder / "_plumbline", app::zsh_completion(*command));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
