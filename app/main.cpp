#include <iostream>
#include <plumbline/base/error.hpp>

#include "app/verbs.hpp"

namespace {

constexpr int bad_input = 2;

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
  } catch (const std::exception& error) {
    std::cerr << "plumbline: " << error.what() << '\n';
    return bad_input;
  }
}

}  // namespace

int main(int argc, char** argv) {
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
