/// \file
/// What is written is read: a corrected file, taken for the nominal model of the bench that gave it, predicts
/// what was found.
#include <doctest/doctest.h>

#include "diagnose/exchange/corrected.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/lab.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

struct Format_ {
  Format format;
  const char* file;
};
constexpr Format_ formats[]{{Format::mjcf, "corrected.xml"},
                            {Format::sdf, "corrected.sdf"},
                            {Format::urdf, "corrected.urdf"},
                            {Format::toml, "corrected.toml"}};

/// Models have fifteen digits, chains out of them twelve. The speck of 1e-5 kg that simulators demand of a
/// body without a mass hangs at the end point, where the force run has a compliance of 0.27 m/N along gravity
/// and 0.09 m/N across, by its levers of 0.56, 0.37, 0.15 m over springs of 2, 1.5, 1 N m/rad: 0.26 and 0.09
/// of the noise of a place in 16 readings, that is 0.06 of 365 values. Its load straightens the chain.
constexpr double as_good_as_same = 0.05;

/// How far the corrected file is from what was found, in standard deviations of the noise.
double left(const Study& study, const Model& model, const Written& file, const char* name,
            const Prediction& wanted) {
  const Folder folder;
  folder.write(name, file.text);
  Experiment again = study.experiment();
  static_cast<diagnose::NominalChain&>(again) = read_model(folder / name).chain;
  again.stated = model.experiment.stated;
  return test::apart(study, Study(again).nominal(), wanted);
}

void check_every_row(const Experiment& bench, const std::filesystem::path& source, const Format_& one) {
  const Study study(bench);
  for (const EffectAt& at : possible_effects(study)) {
    CAPTURE(one.file);
    CAPTURE(at.name());
    const std::vector<double> amount = test::sizeable(study, at);
    const auto models = corrected_models(study, test::found(study, at, amount), source);
    const Written file = written(models.front().model, one.format);
    REQUIRE(file.effects.size() == 1);
    if (!file.effects.front().carried) {
      CHECK_FALSE(file.effects.front().how.empty());
      continue;
    }
    const Prediction wanted = predict(study, {{at}}, amount);
    if (wanted.reached) CHECK(left(study, models.front().model, file, one.file, wanted) < as_good_as_same);
  }
}

}  // namespace

TEST_CASE("a chain of its own in any format is read again as it was written: every row that it carries") {
  for (const Format_& one : formats) check_every_row(diagnose::test::full_bench(), {}, one);
}

TEST_CASE("a robot's own MJCF with a correction in it is read again as it was written: every row") {
  const test::Lab lab;
  check_every_row(lab.experiment, lab.folder / "robot.xml", formats[0]);
}

TEST_CASE("centres of mass off the middle of their links are read, written and read again in each format") {
  Experiment bench = diagnose::test::full_bench();
  bench.link_mass = {0.2, 0.1, 0.3};
  bench.gravity = {0, -9.81};
  bench.effects = {{"link_centre", 1, {{"d_x", 0.03}, {"d_y", -0.01}}},
                   {"link_centre", 3, {{"d_x", -0.05}, {"d_y", 0.02}}}};
  const Folder folder;
  for (const Format_& one : formats) {
    CAPTURE(one.file);
    const Written first = written({"own", bench, bench.runs.front().rest}, one.format);
    for (const Carried& effect : first.effects) CHECK(effect.carried);
    folder.write(one.file, first.text);
    Experiment read = bench;
    static_cast<diagnose::NominalChain&>(read) = read_model(folder / one.file).chain;
    REQUIRE(read.effects.size() == 2);
    for (std::size_t e = 0; e < 2; ++e) {
      CHECK(read.effects[e].label() == bench.effects[e].label());
      // the speck that a format demands of its end point hangs from the last link, a link from its middle at
      // most
      const std::size_t link = bench.effects[e].joint - 1;
      const double slack = 1e-5 / bench.link_mass[link] * bench.link_length[link];
      for (const auto& [name, value] : bench.effects[e].parameters)
        CHECK(std::abs(read.effects[e].parameters.at(name) - value) < slack);
    }
  }
}

}  // namespace plumbline::exchange
