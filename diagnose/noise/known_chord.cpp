/// \file
/// A chord that is known from another run.

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <optional>

#include "diagnose/bench/median.hpp"
#include "diagnose/noise/chord.hpp"
#include "diagnose/noise/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

double rms_of(const Chord& chord) {
  double squares = 0;
  for (const Hum& one : chord) squares += one.rms() * one.rms();
  return std::sqrt(squares / static_cast<double>(chord.size()));
}

/// The interval at which most of a series was read, in mean ones: readings may be missing.
double tick(const Series& series) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < series.clock.size(); ++i)
    steps.push_back(series.clock[i] - series.clock[i - 1]);
  return median(std::move(steps));
}

/// The tones of each run, those alike in frequency together; of a series that has two the louder alone.
std::vector<Chord> chords(const Measurements& measurements, const std::vector<Hum>& all) {
  std::vector<Chord> heard;
  for (std::size_t h = 0; h < all.size(); ++h) {
    if (h > 0 && all[h - 1].series == all[h].series) continue;
    const std::size_t run = measurements.series()[all[h].series].run;
    const auto known = std::find_if(heard.begin(), heard.end(), [&](const Chord& chord) {
      return measurements.series()[chord.front().series].run == run && chord.front().period == all[h].period;
    });
    known == heard.end() ? heard.push_back({all[h]}) : known->push_back(all[h]);
  }
  return heard;
}

/// A place in the spectrum of a run where a tone of another may be.
struct SpectrumPlace {
  double frequency;  ///< rounds an interval of this run, at the times as they are
  double rounds;     ///< as often as its readings go round
};

/// Where a tone that was heard there is here, if slow: within half an ordinate of the run where it was heard,
/// and there at any of the frequencies that the same readings would show, a round or two a reading more or
/// less. Nowhere where half an ordinate there is so many rounds here that it may be anywhere.
std::vector<SpectrumPlace> slow_places(const Series& there, double period, const Series& here) {
  constexpr int most_rounds_more = 2;
  constexpr double least_rounds = 0.5, most_rounds_off = 6;
  const auto count = static_cast<double>(here.readings.size());
  const double ratio = here.interval / there.interval;
  const double off = ratio * 0.5 / static_cast<double>(there.readings.size());
  if (off * count > most_rounds_off) return {};
  const auto looks = std::max(std::lround(std::ceil(looks_an_ordinate * off * count)), 4L);
  std::vector<SpectrumPlace> places;
  for (int more = 0; more <= most_rounds_more; ++more)
    for (const int sign : {1, -1}) {
      const double middle = ratio * (more / tick(there) + sign / period);
      for (long look = -looks; look <= looks && middle > 0; ++look) {
        const double frequency = middle + off * static_cast<double>(look) / static_cast<double>(looks);
        const double shown = frequency * tick(here);
        const double rounds = std::abs(shown - std::round(shown)) / tick(here) * count;
        if (rounds > least_rounds && rounds < slowest_tone(here.readings.size()) * count)
          places.push_back({frequency, rounds});
      }
    }
  return places;
}

/// A chord that is known from another run, in series of this one where it is slow: half around at least, as
/// loud as there within a factor of two, and not by chance.
std::optional<Chord> known_chord(const Measurements& measurements, const std::vector<double>& residual,
                                 const std::vector<std::size_t>& here, const Chord& heard, double level) {
  const Series &there = measurements.series()[heard.front().series],
               &first = measurements.series()[here.front()];
  const std::vector<SpectrumPlace> places = slow_places(there, heard.front().period, first);
  double most = 0;
  Chord found;
  for (const SpectrumPlace& place : places) {
    Chord chord;
    double loud = 0;
    for (const std::size_t s : here) {
      const Series& series = measurements.series()[s];
      Slow one = slow_tone(values_of(series, residual), clock_of(series), place.frequency, place.rounds > 1);
      one.tone.series = s;
      loud += one.loud;
      chord.push_back(one.tone);
    }
    if (loud > most) most = loud, found = std::move(chord);
  }
  if (found.empty()) return std::nullopt;
  const double chance =
      static_cast<double>(places.size()) * boost::math::gamma_q(static_cast<double>(here.size()), most);
  const double louder = rms_of(found) / rms_of(heard);
  if (!(chance < level) || !(louder > 0.5 && louder < 2)) return std::nullopt;
  return found;
}

/// Series of a run that may have a chord too, and have not: long enough, read together, of the channels that
/// it was heard in or of the others, without two tones of their own or one like it.
std::vector<std::size_t> deaf_to(const Measurements& measurements, std::size_t run, const Chord& heard,
                                 const std::vector<Hum>& all, bool of_its_channels) {
  const std::vector<Series>& series = measurements.series();
  const Series& there = series[heard.front().series];
  const double frequency = 1 / (heard.front().period * there.interval),
               ordinate = 1 / (static_cast<double>(there.readings.size()) * there.interval);
  std::vector<std::size_t> here;
  for (std::size_t s = 0; s < series.size(); ++s) {
    if (series[s].run != run || !long_enough(series[s]) || !(series[s].interval > 0)) continue;
    if (!here.empty() && series[s].readings != series[here.front()].readings) continue;
    const bool alike = std::any_of(heard.begin(), heard.end(), [&](const Hum& one) {
      return series[one.series].channel == series[s].channel;
    });
    const auto is_here = [&](const Hum& one) { return one.series == s; };
    const auto is_like_it = [&](const Hum& one) {
      return is_here(one) && std::abs(1 / (one.period * series[s].interval) - frequency) < ordinate;
    };
    if (alike == of_its_channels && std::count_if(all.begin(), all.end(), is_here) < most_tones &&
        std::none_of(all.begin(), all.end(), is_like_it))
      here.push_back(s);
  }
  return here;
}

}  // namespace

void add_known(const Measurements& measurements, const std::vector<double>& residual, double level,
               std::vector<Hum>& all) {
  const std::vector<Chord> heard = chords(measurements, all);
  const std::size_t runs = measurements.series().empty() ? 0 : measurements.series().back().run + 1;
  for (std::size_t run = 0; run < runs; ++run)
    for (const Chord& one : heard)
      for (const bool its_channels : {true, false}) {
        if (!(measurements.series()[one.front().series].interval > 0)) continue;
        const std::vector<std::size_t> here = deaf_to(measurements, run, one, all, its_channels);
        if (here.empty()) continue;
        const std::vector<double> left = without_hum(measurements, residual, all);
        const auto found = known_chord(measurements, left, here, one, level);
        if (found) all.insert(all.end(), found->begin(), found->end());
      }
}

}  // namespace plumbline::diagnose
