#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/command.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "support/files/output_file.hpp"
#include "support/page/provenance.hpp"
#include "verify/claims/claims.hpp"
#include "verify/figures/figures.hpp"

namespace plumbline::app {

namespace {

struct FigureOptions {
  std::string which = "all", out = ".";
};

void run(const FigureOptions& options, const CLI::App& verb) {
  namespace fs = std::filesystem;
  std::vector<const verify::Figure*> chosen;
  std::string numbers;
  for (const verify::Figure& figure : verify::figures()) {
    if (options.which == "all" || options.which == std::to_string(figure.number)) chosen.push_back(&figure);
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(figure.number);
  }
  if (chosen.empty()) throw Error("figure", options.which, "all or one of " + numbers);
  files::require_folder(options.out);
  const page::Provenance from{program_name(), asked(verb, {}), ""};
  Progress progress("figures", chosen.size());
  for (const verify::Figure* figure : chosen) {
    const fs::path path = fs::path(options.out) / fmt::format("figure-{:02}.svg", figure->number);
    const std::string drawing = page::as_svg(figure->draw(), figure->columns);
    files::make_folder(options.out);
    files::write_text(path, page::in_drawing(drawing, from));
    progress.advance();
    fmt::print("{}: {}\n  {}\n", path.string(), figure->title,
               verify::in_words(verdicts_about(*figure, verify::judge(claims_about(*figure), 10))));
  }
}

}  // namespace

void add_figure(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("figure", "Redraw a figure of the paper from computation, as SVG");
  const auto options = std::make_shared<FigureOptions>();
  verb->add_option("number", options->which, "2, 3, ... 16, or all")->type_name("N")->capture_default_str();
  add_output(*verb, "--out", options->out, "Folder for figure-NN.svg, made if it is not there", "DIR")
      ->capture_default_str();
  verb->footer("Stable equilibria are drawn solid, unstable ones dashed. Needs gnuplot.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
