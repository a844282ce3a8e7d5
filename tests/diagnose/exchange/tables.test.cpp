/// \file
/// The tables of benchmarks/RESULTS-exchange.md. Measured anew by
///   build/tests/test-exchange --no-skip --minimal -tc="the tables measured anew"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <fstream>
#include <sstream>

#include "diagnose/exchange/ways.hpp"
#include "tests/diagnose/exchange/lab.hpp"

namespace {

using namespace plumbline::exchange;
using plumbline::diagnose::EffectAt, plumbline::diagnose::Study;

std::string cell(const Study& study, Format format, const EffectAt& at) {
  const Way way = test::way_of(study, format, at);
  return fmt::format("{}{}", way.carried ? "" : "no: ", way.how);
}

std::string verdict(const plumbline::diagnose::Diagnosis& diagnosis) {
  std::string words = verdict_word(diagnosis.cause.verdict);
  if (!diagnosis.cause.ranking.empty() &&
      diagnosis.cause.verdict != plumbline::diagnose::CauseVerdict::unknown)
    words += ": `" + diagnosis.cause.ranking.front().cause.label() + "`";
  return words;
}

/// What each format carries, and as what, an effect a line.
std::string ways() {
  const Study study(plumbline::diagnose::test::full_bench());
  std::string table = "| effect | MJCF | SDF | URDF |\n|---|---|---|---|\n";
  for (const EffectAt& at : test::rows(study)) {
    const std::string mjcf = cell(study, Format::mjcf, at), sdf = cell(study, Format::sdf, at),
                      urdf = cell(study, Format::urdf, at);
    table += fmt::format("| `{}` | {} | {} | {} |\n", at.name(), mjcf, sdf == mjcf ? "the same" : sdf,
                         urdf == sdf ? "the same" : urdf);
  }
  return table;
}

}  // namespace

TEST_CASE("the document says what each format carries") {
  std::ostringstream text;
  text << std::ifstream(PLUMBLINE_SOURCE_DIR "/benchmarks/RESULTS-exchange.md").rdbuf();
  CHECK(text.str().find(ways()) != std::string::npos);
}

TEST_CASE("the tables measured anew" * doctest::skip()) {
  fmt::print("{}\n", ways());
  fmt::print(
      "| effect | nominal | found | in MuJoCo | diagnosed from MuJoCo's readings | before | after | report | "
      "in "
      "MuJoCo |\n|---|---|---|---|---|---|---|---|---|\n");
  const test::Lab lab, fine(40);
  const Study of_lab(lab.experiment);
  for (const EffectAt& at : test::rows(of_lab)) {
    if (!test::way_of(of_lab, Format::mjcf, at).carried) continue;
    const test::Residuals left = test::residuals(at);
    const test::Lab& own = at.effect->id == "sensor_lag" ? fine : lab;
    const Study bare(test::bench_in(own, at));
    const Written truth = written(
        corrected_models(bare, test::found(bare, at, test::amount_of(bare, at)), own.folder / "robot.xml")
            .front()
            .model,
        Format::mjcf);
    fmt::print("| `{}` | {:.3g} | {:.3g} | {:.3g} ", at.label(), left.nominal, left.found, left.mujoco);
    if (truth.effects.front().carried) {
      const test::RoundTrip trip =
          test::round_trip(own, bare.experiment(), truth.text, test::pace_of(at.effect->id), 7);
      fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} |\n", verdict(trip.diagnosis), trip.before,
                 trip.after, trip.reported, trip.mujoco);
    } else {
      fmt::print("| not carried by this robot: {} | | | | |\n", truth.effects.front().how);
    }
    std::fflush(stdout);
  }
}
