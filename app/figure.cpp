#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <plumbline/error.hpp>

#include "app/figures.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "files/text_file.hpp"

namespace plumbline {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {2, "two links, straight: force and energy over deflection",
       "The paper shows no deflection up to F_c = 2 k/L and a rising force after it. Agrees; beyond F_c the "
       "straight "
       "shape is unstable (dashed).",
       2, draw_figure_2},
      {3, "two links, bent at rest by pi/6: force and energy over deflection",
       "The paper shows a rising force through the origin and one minimum in every energy curve. Agrees.", 2,
       draw_figure_3},
      {5, "three links, straight and nearly straight: force over deflection",
       "The paper shows four equilibria, U+ and U- stable, Z+ and Z- unstable. Agrees; U+ and U- have one "
       "curve, Z+ and Z- another, and of the quasi-straight chain's two U shapes both are stable.",
       2, draw_figure_5},
      {6, "three links, straight: shapes after buckling",
       "The paper shows U and Z shapes. Agrees: U stable, Z unstable.", 2, draw_figure_6},
      {7, "three links, U-shaped at rest: force over deflection",
       "The paper shows four curves, one of them feasible, without a jump. Agrees for small deflections; "
       "from 0.3 L on, shapes with a joint more than half a turn from rest come in as well, in tension.",
       2, draw_figure_7},
      {8, "three links, Z-shaped at rest: force over deflection",
       "The paper shows a kink and speaks of a sudden jump. The kink is a pitchfork bifurcation at 0.0407 L: "
       "the shape "
       "leaves the zigzag continuously, to either side, and no jump occurs.",
       2, draw_figure_8},
      {9, "three links, Z-shaped at rest: energy over the first angle",
       "The paper shows the first angle at zero at the critical force. It is -0.156 there. Both later minima "
       "have the same energy: neither is only local.",
       3, draw_figure_9},
      {11, "four links, U-shaped at rest: energy surface at 0.4 L",
       "The paper shows one maximum, one minimum and one saddle for q_4 > 0. Agrees; the other sheet has as "
       "many again.",
       2, draw_figure_11},
      {12, "four links, U-shaped at rest: forces over deflection",
       "The paper shows smooth curves and a stiffness that falls all the way. Agrees up to 1.5 L.", 2,
       draw_figure_12},
      {13, "four links, Z-shaped at rest: energy surface at 0.4 L",
       "The paper shows one maximum and one minimum for q_4 > 0. There are two minima and a saddle; the "
       "maximum has q_4 < 0.",
       2, draw_figure_13},
      {14, "four links, Z-shaped at rest: forces over deflection",
       "The paper shows a steep rise, then a plateau of low stiffness. Agrees; the stiffness is least at "
       "0.5855 L.",
       2, draw_figure_14},
      {15, "four links, straight: shapes after buckling",
       "The paper shows U-, Z- and ZU-shapes. Agrees: only U is stable.", 2, draw_figure_15},
      {16, "four links, straight: energy surface at 0.5 L",
       "The paper shows two minima, two maxima and two saddles. Agrees.", 2, draw_figure_16},
  };
  return all;
}

namespace {

struct Options {
  std::string which = "all", out = ".";
};

void write(const Figure& figure, const std::filesystem::path& path) {
  const std::string svg = as_svg(figure.draw(), figure.columns);
  OutputFile file(path);
  file.write(svg);
  file.commit();
}

void run(const Options& options) {
  namespace fs = std::filesystem;
  std::vector<const Figure*> chosen;
  std::string numbers;
  for (const Figure& figure : figures()) {
    if (options.which == "all" || options.which == std::to_string(figure.number)) chosen.push_back(&figure);
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(figure.number);
  }
  if (chosen.empty()) throw Error("figure", options.which, "all or one of " + numbers);
  if (!fs::is_directory(options.out)) throw Error("--out", options.out + ", which is no folder", "a folder");
  Progress progress("figures", chosen.size());
  for (const Figure* figure : chosen) {
    const fs::path path = fs::path(options.out) / fmt::format("figure-{:02}.svg", figure->number);
    write(*figure, path);
    progress.advance();
    fmt::print("{}: {}\n  {}\n", path.string(), figure->title, figure->sentence);
  }
}

}  // namespace

void add_figure(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("figure", "Redraw a figure of the paper from computation, as SVG");
  const auto options = std::make_shared<Options>();
  verb->add_option("number", options->which, "2, 3, 5, ... 16, or all")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--out", options->out, "Folder for figure-NN.svg")
      ->type_name("DIR")
      ->capture_default_str();
  verb->footer("Stable equilibria are drawn solid, unstable ones dashed. Needs gnuplot.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline
