#include <fmt/core.h>

#include <cstdio>
#include <memory>

#include "app/serve/server.hpp"
#include "app/verbs.hpp"

namespace plumbline::app {

void add_serve(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "serve", "A page to drop a model and tables into, in the browser of this machine; nothing leaves it");
  const auto port = std::make_shared<int>(0);
  constexpr int last = 65535;
  verb->add_option("--port", *port, "The port to listen at; without it one that is free")
      ->type_name("N")
      ->check(CLI::Range(1, last));
  verb->footer("The address has a token in it: whoever knows it works with your files. Ctrl+C ends it.");
  verb->callback([port] {
    serve(*port, [](const std::string& address) {
      fmt::print("Open {}\nCtrl+C ends it.\n", address);
      std::fflush(stdout);
    });
  });
}

}  // namespace plumbline::app
