#include "diagnose/inference/hum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"
#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

Eigen::VectorXd clock_of(const Series& series) {
  return Eigen::Map<const Eigen::VectorXd>(series.clock.data(),
                                           static_cast<Eigen::Index>(series.clock.size()));
}

/// The interval at which most of a series was read, in mean ones: readings may be missing.
double tick(const Series& series) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < series.clock.size(); ++i)
    steps.push_back(series.clock[i] - series.clock[i - 1]);
  return median(std::move(steps));
}

/// The tone of this frequency in values, beside what is slow.
Hum tone_of(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency) {
  const Fast fast(static_cast<std::size_t>(values.size()));
  const Eigen::Vector2d size = fast.amplitudes(values, tone(clock, frequency));
  return {0, 1 / frequency, size(0), size(1)};
}

/// A tone of this frequency, slow in a series, and how far noise alone would fall behind.
struct Slow {
  Hum tone;
  double loud;
};

/// Beside the mean of the values, where the tone goes round; of less than a round the mean is a part.
Slow slow_tone(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency, bool round) {
  const Eigen::Index columns = round ? 3 : 2;
  Eigen::MatrixXd waves(values.size(), columns);
  waves.leftCols(2) = tone(clock, frequency);
  if (round) waves.col(2).setOnes();
  const Eigen::VectorXd size = LeastSquares(waves).solve(values);
  const double energy = (values.array() - (round ? values.mean() : 0)).square().sum(),
               left = (values - waves * size).squaredNorm();
  return {{0, 1 / frequency, size(0), size(1)},
          left > 0 ? static_cast<double>(values.size() - columns) / 2 * std::log(energy / left) : 0};
}

/// The slowest tone of the spectrum, or one that is slower by up to an ordinate where that leaves less: of
/// what goes round 3.7 times the spectrum shows the flank.
Hum slowest_in(const Eigen::VectorXd& values, const Eigen::VectorXd& clock) {
  const auto count = static_cast<std::size_t>(values.size());
  Hum best = tone_of(values, clock, slowest_tone(count));
  double loud = 0;
  for (Eigen::Index look = 0; look > -looks_an_ordinate; --look) {
    const Slow one = slow_tone(values, clock, looked_at(count, look), true);
    if (!(one.loud > loud)) continue;
    loud = one.loud;
    if (look < 0) best = one.tone;
  }
  return best;
}

/// The loudest tone in these values, and their spectrum.
struct Loudest {
  Hum tone;
  double frequency;
  Eigen::VectorXd shares;
};

Loudest loudest(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(values.size());
  Eigen::VectorXd shares = tone_shares(values, clock, correlation);
  Eigen::Index look = 0;
  shares.maxCoeff(&look);
  const double frequency = looked_at(count, look);
  return {look == 0 ? slowest_in(values, clock) : tone_of(values, clock, frequency), frequency,
          std::move(shares)};
}

/// The chance that noise alone has as loud a tone as this one, the loudest. Fisher: with n ordinates the
/// largest share g of the energy has P(g > x) < n (1 - x)^(n - 1); looking between the ordinates finds no
/// more than twice as often.
double chance_of(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency,
                 double correlation) {
  const double n = ordinates(static_cast<std::size_t>(values.size()));
  return 2 * n * std::pow(1 - tone_share(values, clock, frequency, correlation), n - 1);
}

/// That a series may have.
constexpr long most_tones = 2;

/// A spectrum of fewer ordinates has no line.
bool long_enough(const Series& series) {
  return series.readings.size() >= 16;
}

Eigen::VectorXd values_of(const Series& series, const std::vector<double>& residual) {
  return Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first,
                                           static_cast<Eigen::Index>(series.readings.size()));
}

/// By how much neighbours correlate beside the loudest tone of each series, be it noise or not.
double correlation_beside_tones(const Measurements& measurements, const std::vector<double>& residual) {
  std::vector<Hum> all;
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    all.push_back(loudest(values_of(series, residual), clock_of(series), 0).tone);
    all.back().series = s;
  }
  return estimate_noise(measurements, without_hum(measurements, residual, all)).correlation;
}

/// A tone in some series of a run, alike in frequency.
using Chord = std::vector<Hum>;

double rms_of(const Chord& chord) {
  double squares = 0;
  for (const Hum& one : chord) squares += one.rms() * one.rms();
  return std::sqrt(squares / static_cast<double>(chord.size()));
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
struct Place {
  double frequency;  ///< rounds an interval of this run, at the times as they are
  double rounds;     ///< as often as its readings go round
};

/// Where a tone that was heard there is here, if slow: within half an ordinate of the run where it was heard,
/// and there at any of the frequencies that the same readings would show, a round or two a reading more or
/// less.
std::vector<Place> slow_places(const Series& there, double period, const Series& here) {
  constexpr int most_rounds_more = 2;
  constexpr double least_rounds = 0.5;
  const auto count = static_cast<double>(here.readings.size());
  const double ratio = here.interval / there.interval,
               off = ratio * 0.5 / static_cast<double>(there.readings.size()),
               step = 1.0 / (looks_an_ordinate * count);
  const auto looks = std::max(std::lround(std::ceil(off / step)), 4L);
  std::vector<Place> places;
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
  const std::vector<Place> places = slow_places(there, heard.front().period, first);
  double most = 0;
  Chord found;
  for (const Place& place : places) {
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

/// Adds to the tones that were heard in some run those that others then have too: the same channels first,
/// and the rest, for what hums in one may be in the room.
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

/// Series of a run that were read together, have no tone yet, and are long enough for one.
std::vector<std::size_t> read_together(const Measurements& measurements, std::size_t first,
                                       const std::vector<Hum>& all) {
  const std::vector<Series>& series = measurements.series();
  std::vector<std::size_t> together;
  for (std::size_t s = first; s < series.size() && series[s].run == series[first].run; ++s) {
    const bool has = std::any_of(all.begin(), all.end(), [&](const Hum& one) { return one.series == s; });
    if (!has && long_enough(series[s]) && series[s].readings == series[first].readings) together.push_back(s);
  }
  return together;
}

/// How far noise alone would fall behind at every look: of independent series the sum of what each has,
/// -(n - 1) log(1 - share), which is exponential in one of them.
Eigen::VectorXd loudness(const Measurements& measurements, const std::vector<std::size_t>& together,
                         const std::vector<Eigen::VectorXd>& spectra) {
  constexpr double whole = 1 - 1e-12;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(spectra[together.front()].size());
  for (const std::size_t s : together)
    sum.array() -=
        (ordinates(measurements.series()[s].readings.size()) - 1) * (1 - spectra[s].array().min(whole)).log();
  return sum;
}

/// Whether nothing beyond the line itself comes near it, and it is no flank of what is slower: a kink of the
/// residual is heard at all frequencies.
bool is_line(const Eigen::VectorXd& loud, Eigen::Index at) {
  constexpr double stands_out = 2;
  constexpr Eigen::Index width = 3 * looks_an_ordinate / 2;
  double beside = 0;
  for (Eigen::Index look = 0; look < loud.size(); ++look)
    if (std::abs(look - at) > width) beside = std::max(beside, loud(look));
  return at >= looks_an_ordinate && loud(at) > stands_out * beside;
}

/// Where series that were read together have a tone that is too soft to be heard in one of them, and the
/// chance that noise alone has one as loud.
struct Shared {
  Eigen::Index look;
  double chance;
};

std::optional<Shared> shared_look(const Eigen::VectorXd& loud, std::size_t count, std::size_t series) {
  Shared shared{};
  const double most = loud.maxCoeff(&shared.look);
  if (series < 2 || !is_line(loud, shared.look)) return std::nullopt;
  shared.chance = 2 * ordinates(count) * boost::math::gamma_q(static_cast<double>(series), most);
  return shared;
}

/// The same beside a tone that was heard in another series of the run: within half an ordinate of that.
std::optional<Shared> shared_look(const Eigen::VectorXd& loud, std::size_t count, std::size_t series,
                                  const Hum& heard) {
  constexpr Eigen::Index near = looks_an_ordinate / 2;
  const double look =
      (1 / heard.period - slowest_tone(count)) * looks_an_ordinate * static_cast<double>(count);
  const Eigen::Index from = std::max<Eigen::Index>(std::lround(look) - near, 0);
  const Eigen::Index looks = std::min<Eigen::Index>(2 * near + 1, loud.size() - from);
  if (looks < 1) return std::nullopt;
  Shared shared{};
  const double most = loud.segment(from, looks).maxCoeff(&shared.look);
  shared.look += from;
  shared.chance = static_cast<double>(looks) * boost::math::gamma_q(static_cast<double>(series), most);
  return shared;
}

/// Adds to each run the tones that its series share.
/// \param spectra  of all series
void add_shared(const Measurements& measurements, const std::vector<double>& residual,
                const std::vector<Eigen::VectorXd>& spectra, double level, std::vector<Hum>& all) {
  const std::vector<Series>& series = measurements.series();
  const std::vector<Hum> heard = all;
  for (std::size_t first = 0; first < series.size(); ++first) {
    if (first > 0 && series[first].run == series[first - 1].run) continue;
    const std::vector<std::size_t> together = read_together(measurements, first, all);
    if (together.empty()) continue;
    const std::size_t count = series[together.front()].readings.size();
    const Eigen::VectorXd loud = loudness(measurements, together, spectra);
    const auto here = std::find_if(heard.begin(), heard.end(), [&](const Hum& one) {
      return series[one.series].run == series[first].run;
    });
    const auto found = here == heard.end() ? shared_look(loud, count, together.size())
                                           : shared_look(loud, count, together.size(), *here);
    if (!found || !(found->chance < level)) continue;
    Chord chord;
    for (const std::size_t s : together) {
      chord.push_back(
          tone_of(values_of(series[s], residual), clock_of(series[s]), looked_at(count, found->look)));
      chord.back().series = s;
    }
    const bool ripples = std::any_of(chord.begin(), chord.end(),
                                     [](const Hum& one) { return one.rms() > beliefs::largest_scale; });
    if (!ripples) all.insert(all.end(), chord.begin(), chord.end());
  }
}

}  // namespace

double Hum::rms() const {
  return std::hypot(cosine, sine) / std::numbers::sqrt2;
}

std::vector<Hum> find_hum(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr double level = 1e-3;
  std::vector<Hum> all;
  std::vector<Eigen::VectorXd> spectra(measurements.series().size());
  const double correlation = correlation_beside_tones(measurements, residual);
  const auto larger = larger_correlations(measurements, residual, correlation);
  const auto by_chance = [&](const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency) {
    const double estimated = chance_of(values, clock, frequency, correlation);
    if (!(estimated < level)) return estimated;
    // Of noise that is slower than was estimated slow tones are none.
    double chance = estimated;
    for (const auto& [value, probability] : larger)
      chance += probability * (chance_of(values, clock, frequency, value) - estimated);
    return chance;
  };
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    Eigen::VectorXd values = values_of(series, residual);
    for (long i = 0; i < most_tones; ++i) {
      auto [one, frequency, shares] = loudest(values, clock_of(series), correlation);
      spectra[s] = std::move(shares);
      if (!(by_chance(values, clock_of(series), frequency) < level) || one.rms() > beliefs::largest_scale)
        break;
      values -= tone(clock_of(series), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
      one.series = s;
      all.push_back(one);
    }
  }
  add_shared(measurements, residual, spectra, level, all);
  add_known(measurements, residual, level, all);
  return all;
}

std::vector<double> without_hum(const Measurements& measurements, std::vector<double> residual,
                                const std::vector<Hum>& hum) {
  for (const Hum& one : hum) {
    const Series& series = measurements.series()[one.series];
    Eigen::Map<Eigen::VectorXd> values(residual.data() + series.first,
                                       static_cast<Eigen::Index>(series.readings.size()));
    values -= tone(clock_of(series), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
  }
  return residual;
}

}  // namespace plumbline::diagnose
