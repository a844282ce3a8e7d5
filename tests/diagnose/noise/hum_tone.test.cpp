#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/hum.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A tone of so many rounds in a series, by cosine and sine at its first reading.
struct Rounds {
  double rounds, cosine, sine;
};

/// Adds tones to one series of a residual.
void sound(const Measurements& measurements, std::size_t series, const std::vector<Rounds>& tones,
           std::vector<double>& residual) {
  const Series& one = measurements.series()[series];
  const std::size_t count = one.readings.size();
  for (const Rounds& tone : tones)
    for (std::size_t i = 0; i < count; ++i) {
      const double angle =
          2 * std::numbers::pi * tone.rounds * static_cast<double>(i) / static_cast<double>(count);
      residual[one.first + i] += tone.cosine * std::cos(angle) + tone.sine * std::sin(angle);
    }
}

/// What a search finds in a single series of so many readings that has these tones.
std::vector<Hum> heard_in(std::size_t count, const std::vector<Rounds>& tones) {
  const Measurements measurements(blank_experiment({count}));
  std::vector<double> residual(measurements.size(), 0.0);
  sound(measurements, 0, tones, residual);
  return find_hum(measurements, residual);
}

/// Two runs of Fx and Fy whose clocks tick so fast; a tone in Fx of the first, another in Fx of the second.
std::vector<Hum> known_in_second(double in_first, double in_second, double period, double interval = 1,
                                 std::size_t readings = 60, double shift = 0) {
  Experiment experiment = blank_experiment({64, readings});
  for (Reading& reading : experiment.runs[1].readings) reading.t *= interval;
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size(), 0.0);
  sound(measurements, 0, {{64 / period, in_first, 0}}, residual);
  const double rounds = static_cast<double>(readings) * interval / period;
  sound(measurements, 2, {{rounds, 0, in_second}}, residual);
  const Series& second = measurements.series()[2];
  for (std::size_t i = 0; i < readings; ++i) residual[second.first + i] += shift;
  return find_hum(measurements, residual);
}

}  // namespace

TEST_CASE("a pure tone is heard with its period and its amplitudes") {
  for (const double rounds : {4.0, 4.25, 8.0, 16.0, 25.0}) {
    CAPTURE(rounds);
    const Rounds tone{rounds, 1.5, -0.5};
    const std::vector<Hum> heard = heard_in(64, {tone});
    REQUIRE(heard.size() >= 1);
    CHECK(heard[0].series == 0);
    CHECK(heard[0].period == close_to(64 / rounds).epsilon(1e-9));
    CHECK(heard[0].cosine == close_to(tone.cosine).epsilon(1e-9));
    CHECK(heard[0].sine == close_to(tone.sine).epsilon(1e-9));
  }
  CHECK(Hum{0, 4, 3, -4}.rms() == close_to(5 / std::numbers::sqrt2));
}

TEST_CASE("two tones of a series are heard, the louder first, and no third") {
  const std::vector<Hum> heard = heard_in(64, {{16, 3, 0}, {25, 0, 1}, {9, 0.3, 0}});
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].period == close_to(4).epsilon(1e-9));
  CHECK(heard[1].period == close_to(64.0 / 25).epsilon(1e-9));
  CHECK(heard[0].rms() == close_to(3 / std::numbers::sqrt2).epsilon(0.01));
  CHECK(heard[1].rms() == close_to(1 / std::numbers::sqrt2).epsilon(0.03));  // what is left of the first
}

TEST_CASE("sixteen readings have a spectrum, fifteen have none; a tone of five sigmas and more is a ripple") {
  CHECK(heard_in(15, {{6, 1, 0}}).empty());
  CHECK_FALSE(heard_in(16, {{6, 1, 0}}).empty());
  const double largest = beliefs::largest_hum * std::numbers::sqrt2;
  CHECK_FALSE(heard_in(64, {{16, 0.98 * largest, 0}}).empty());
  CHECK(heard_in(64, {{16, 1.02 * largest, 0}}).empty());
}

TEST_CASE(
    "what goes round less than three times in a run is slow, and a tone between three and four is heard") {
  // The slowest tone of the spectrum goes round half as often as there are slow waves, and once more: four
  // times. Looks are a quarter of a round apart.
  for (const double rounds : {3.5, 3.75}) {
    CAPTURE(rounds);
    const std::vector<Hum> heard = heard_in(64, {{rounds, 1, 1}});
    REQUIRE_FALSE(heard.empty());
    CHECK(heard[0].period == close_to(64 / rounds).epsilon(1e-9));
    CHECK(heard[0].rms() == close_to(1).epsilon(1e-9));
  }
  for (const double rounds : {1.0, 2.0, 2.9})
    for (const Hum& one : heard_in(64, {{rounds, 1, 1}})) CHECK(one.period < 64 / 3.0);
  CHECK(heard_in(64, {}).empty());  // silence
}

TEST_CASE(
    "a tone is known in another run of its channel from half a round on, as loud within two, and slow") {
  // period 16: four rounds of the first run, three of the second
  const auto in_second = [](const std::vector<Hum>& heard) {
    std::vector<Hum> there;
    for (const Hum& one : heard)
      if (one.series == 2) there.push_back(one);
    return there;
  };
  const std::vector<Hum> known = in_second(known_in_second(1, 1, 16, 0.8));
  REQUIRE(known.size() == 1);
  CHECK(known[0].period == close_to(20).epsilon(0.02));  // of the middle of the places that are looked at
  CHECK(known[0].rms() == close_to(1 / std::numbers::sqrt2).epsilon(0.05));
  // beside a constant, which is no tone
  CHECK(in_second(known_in_second(1, 1, 16, 0.8, 60, 2)).size() == 1);
  CHECK(in_second(known_in_second(1, 1.8, 16, 0.8)).size() == 1);
  CHECK(in_second(known_in_second(1, 2.2, 16, 0.8)).empty());
  CHECK(in_second(known_in_second(1, 0.56, 16, 0.8)).size() == 1);
  CHECK(in_second(known_in_second(1, 0.45, 16, 0.8)).empty());
  // 60 readings of 0.32 s are 19.2 s, more than a round
  CHECK(in_second(known_in_second(1, 1, 16, 0.32)).size() == 1);
  // three quarters of one, from which a constant could not be told: it is a part of the tone
  const std::vector<Hum> part = in_second(known_in_second(1, 1, 16, 0.2));
  REQUIRE(part.size() == 1);
  CHECK(part[0].rms() == close_to(1 / std::numbers::sqrt2).epsilon(0.05));
  CHECK(in_second(known_in_second(1, 1, 16, 0.1)).empty());  // less than half of one
  CHECK(in_second(known_in_second(1, 1, 16, 0.8, 15)).empty());
  CHECK(in_second(known_in_second(1, 1, 16, 0)).empty());  // no clock
  // heard in Fx it says nothing of Fy
  for (const Hum& one : known_in_second(1, 1, 16, 0.8)) CHECK(one.series % 2 == 0);
}

TEST_CASE("a tone is known in another run where its readings show it slower than it is") {
  // 2.1 s, and read every 2 s in the second run: 40 s there, 57 rounds of which the readings show three
  const std::vector<Hum> heard = known_in_second(1, 1, 2.1, 2);
  const auto known = std::find_if(heard.begin(), heard.end(), [](const Hum& one) { return one.series == 2; });
  REQUIRE(known != heard.end());
  CHECK(known->rms() == close_to(1 / std::numbers::sqrt2).epsilon(0.05));
  const double rounds = 60 / known->period, shown = std::abs(rounds - std::round(rounds / 60) * 60);
  CHECK(shown == close_to(60 * (1 - 2 / 2.1)).epsilon(0.1));
}

TEST_CASE("a tone that changes little while a place is read again and again is no matter of the place") {
  // A tone of 16 s, read every second in the first run and every 0.4 s in the second: there 40 readings, of
  // which a quarter are ten. Eight at a time are of the same place but for some hundredths, and in their
  // order of place three or five apart.
  Experiment experiment = blank_experiment({64, 64});
  for (std::size_t i = 0; i < 64; ++i) {
    Reading& reading = experiment.runs[1].readings[i];
    reading.t *= 0.4;
    reading.x += 0.01 * static_cast<double>(i / 8) + 1e-4 * static_cast<double>(5 * i % 8);
  }
  const Measurements measurements(experiment);
  REQUIRE(measurements.series()[2].between.size() > 30);
  std::vector<double> residual(measurements.size(), 0.0);
  sound(measurements, 0, {{4, 1, 0}}, residual);
  sound(measurements, 2, {{1.6, 0, 1}}, residual);
  const std::vector<Hum> heard = find_hum(measurements, residual);
  CHECK(std::any_of(heard.begin(), heard.end(), [](const Hum& one) { return one.series == 2; }));
}

TEST_CASE("what is the same there and back may be of the path, unless another run has it otherwise") {
  // 64 readings there and back, and a tone of 4.5 rounds that is at its crest where the run turns back.
  Experiment experiment = blank_experiment({65, 65});
  for (Run& run : experiment.runs)
    for (std::size_t i = 0; i < 65; ++i) run.readings[i].x += 0.01 * std::abs(static_cast<double>(i) - 32);
  const Measurements measurements(experiment);
  REQUIRE(measurements.series()[0].between.size() > 30);
  // 4.5 rounds of 64 readings are so many of 65
  constexpr double rounds = 4.5 * 65 / 64;
  const auto heard_in_first = [&](const std::vector<Hum>& all) {
    return std::any_of(all.begin(), all.end(), [](const Hum& one) { return one.series == 0; });
  };
  const double crest = 2 * std::numbers::pi * 4.5 * 32 / 64;
  const Rounds turned_back{rounds, std::cos(crest), std::sin(crest)},
      crossed{rounds, -std::sin(crest), std::cos(crest)};
  std::vector<double> residual(measurements.size(), 0.0);
  sound(measurements, 0, {turned_back}, residual);
  CHECK_FALSE(heard_in_first(find_hum(measurements, residual)));
  std::vector<double> of_both = residual;
  sound(measurements, 2, {turned_back}, of_both);
  CHECK_FALSE(heard_in_first(find_hum(measurements, of_both)));
  sound(measurements, 2, {crossed}, residual);
  CHECK(heard_in_first(find_hum(measurements, residual)));
}

TEST_CASE("a tone is said to be in the series that has it") {
  const Measurements measurements(blank_experiment({10, 64, 64}));
  REQUIRE(measurements.series().size() == 6);
  for (const std::size_t series : {2U, 3U, 5U}) {
    std::vector<double> residual(measurements.size(), 0.0);
    sound(measurements, series, {{16, 1, 0}}, residual);
    const std::vector<Hum> heard = find_hum(measurements, residual);
    REQUIRE_FALSE(heard.empty());
    for (const Hum& one : heard) CHECK(one.series == series);
    for (const double left : without_hum(measurements, residual, {{series, 4, 1, 0}}))
      CHECK(std::abs(left) < 1e-12);
  }
}
